// A zip of DICOM or pictures: unpacked into a folder for temporary files, and read from there.
#include <utility>

#include "text/control_character.hpp"
#include "text/words.hpp"
#include "volumes/formats/readers.hpp"

#ifdef DISCMC_WITH_LIBARCHIVE
#include <archive.h>
#include <archive_entry.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <clocale>
#include <cstdlib>
#include <fstream>
#include <new>
#include <set>
#include <system_error>
#include <vector>

#include "volumes/formats/dicom/files.hpp"
#include "volumes/formats/pictures/picture_names.hpp"
#endif

namespace discmc::command {

bool has_zip_name(const std::filesystem::path& file) {
  return lower(file.extension().string()) == ".zip";
}

#ifdef DISCMC_WITH_LIBARCHIVE
namespace {

// A folder of its own, removed at its end with all that is in it, and also when a signal ends the
// program: patients' data must not stay. A process that waits for that end removes it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "discmc-zip-XXXXXX").string();
    if (error || mkdtemp(name.data()) == nullptr)
      fail("zip", "no folder for temporary files", "set TMPDIR to one that can be written");
    path_ = name;
    leave_to_remover();
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    close(alive_);
    others_alive().erase(alive_);
    waitpid(remover_, nullptr, 0);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  // The ends of pipes that close when this program ends. Removers inherit those made before.
  static std::set<int>& others_alive() {
    static std::set<int> ends;
    return ends;
  }

  void leave_to_remover() {
    int ends[2];
    if (pipe(ends) != 0 || (remover_ = fork()) < 0) {
      rmdir(path_.c_str());
      fail("zip", "no process can be started that removes what is unpacked",
           "unpack it and give the folder");
    }
    if (remover_ == 0) remove_at_end(ends[0], ends[1]);
    close(ends[0]);
    alive_ = ends[1];
    others_alive().insert(alive_);
  }

  [[noreturn]] void remove_at_end(int end, int alive) const {
    setsid();  // signals of the terminal are not for it
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) close(standard);
    for (const int other : others_alive()) close(other);
    close(alive);
    char nothing = 0;
    while (read(end, &nothing, 1) < 0 && errno == EINTR) {
    }
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    _exit(0);
  }

  std::filesystem::path path_;
  pid_t remover_ = 0;
  int alive_ = -1;
};

using Archive = std::unique_ptr<archive, int (*)(archive*)>;

// libarchive gives names of any language in such a locale alone.
class Utf8Locale {
 public:
  Utf8Locale() : locale_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (locale_ != nullptr) before_ = uselocale(locale_);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;
  ~Utf8Locale() {
    if (locale_ == nullptr) return;
    uselocale(before_);
    freelocale(locale_);
  }

 private:
  locale_t locale_;
  locale_t before_{};
};

// The name of a member; its number where the archive has it in a way that is not known.
std::string name_of(archive_entry* entry, std::size_t number) {
  const char* name = archive_entry_pathname_utf8(entry);
  if (name == nullptr) name = archive_entry_pathname(entry);
  return name == nullptr ? std::to_string(number) : without_control(name);
}

// The name that a member has in the folder: without what would lead out of it. Empty for what macOS
// adds to archives of its own.
std::filesystem::path inner_path(const std::string& name) {
  std::filesystem::path inner;
  for (const std::filesystem::path& part : std::filesystem::path(name)) {
    if (part == "__MACOSX" || part == ".DS_Store" || part.native().rfind("._", 0) == 0) return {};
    if (part != "/" && part != "." && part != "..") inner /= part;
  }
  return inner;
}

void unpack_member(const std::filesystem::path& zip, archive* reader,
                   const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  std::ofstream out(file, std::ios::binary);
  std::array<char, 65536> block;
  la_ssize_t got = 0;
  while (out && (got = archive_read_data(reader, block.data(), block.size())) > 0)
    out.write(block.data(), got);
  if (got < 0)
    fail(zip, shown(file.filename().string()) + " is damaged or encrypted in it",
         "copy or export the archive again, without a password");
  if (!out.flush())
    fail(zip, shown(file.filename().string()) + " cannot be unpacked into the temporary folder",
         "set TMPDIR to a folder with more space, or unpack the archive and give the folder");
}

void unpack(const std::filesystem::path& zip, const std::filesystem::path& folder) {
  const Utf8Locale any_language;
  const Archive reader(archive_read_new(), archive_read_free);
  if (!reader) throw std::bad_alloc();
  archive_read_support_format_zip(reader.get());
  constexpr std::size_t block_bytes = 65536;
  int result = archive_read_open_filename(reader.get(), zip.c_str(), block_bytes);
  archive_entry* entry = nullptr;
  std::size_t number = 0;
  while (result >= ARCHIVE_WARN &&
         (result = archive_read_next_header(reader.get(), &entry)) >= ARCHIVE_WARN &&
         result != ARCHIVE_EOF) {
    const std::filesystem::path name = inner_path(name_of(entry, ++number));
    if (archive_entry_filetype(entry) == AE_IFREG && name.has_filename())
      unpack_member(zip, reader.get(), folder / name);
  }
  if (result != ARCHIVE_EOF)
    fail(zip, "the archive is damaged or no zip", "copy or export it again");
}

// Where pictures are: goes into a folder that is alone, but for files that are none.
std::filesystem::path picture_folder(std::filesystem::path folder) {
  for (;;) {
    std::vector<std::filesystem::path> folders;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.is_directory())
        folders.push_back(entry.path());
      else if (is_picture_name(entry.path()))
        return folder;
    }
    if (folders.size() != 1) return folder;
    folder = folders.front();
  }
}

std::unique_ptr<VolumeReader> open_unpacked(const std::filesystem::path& folder,
                                            const VolumeOptions& options) {
  const auto dicom = dicom_files(folder);
  return open_folder(dicom.empty() ? picture_folder(folder) : folder, dicom, options,
                     "unpack the zip, and give a pattern, such as 'FOLDER/*.png'");
}

// A volume whose files are gone when it is closed, and bear the name of the archive in errors.
class UnpackedVolume final : public VolumeReader {
 public:
  UnpackedVolume(const std::filesystem::path& zip, const VolumeOptions& options) : zip_(zip) {
    unpack(zip, folder_.path());
    renamed([&] { volume_ = open_unpacked(folder_.path(), options); });
    info_ = volume_->info();
    info_.format += ", zip";
  }

  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override {
    renamed([&] { volume_->read_slice(samples); });
  }

 private:
  template <class Call>
  void renamed(Call call) {
    try {
      call();
    } catch (const VolumeError& error) {
      const std::filesystem::path inner = error.file().lexically_relative(folder_.path());
      const bool is_inside = !inner.empty() && *inner.begin() != "..";
      const std::filesystem::path named = inner == "." ? zip_ : zip_ / inner;
      fail(is_inside ? named : error.file(), error.fault(), error.remedy());
    }
  }

  std::filesystem::path zip_;
  TemporaryFolder folder_;
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
};

}  // namespace

std::unique_ptr<VolumeReader> open_zip(const std::filesystem::path& file,
                                       const VolumeOptions& options) {
  return std::make_unique<UnpackedVolume>(file, options);
}
#else
std::unique_ptr<VolumeReader> open_zip(const std::filesystem::path& file, const VolumeOptions&) {
  fail(file, "this discmc was built without libarchive", "unpack it and give the folder");
}
#endif

}  // namespace discmc::command
