// A zip of DICOM or pictures: unpacked into a folder for temporary files, and read from there.
#include <algorithm>
#include <utility>

#include "volume_format.hpp"

#ifdef DISCMC_WITH_LIBARCHIVE
#include <archive.h>
#include <archive_entry.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <system_error>
#endif

namespace discmc::host {

bool has_zip_name(const std::filesystem::path& file) {
  return lower(file.extension().string()) == ".zip";
}

#ifdef DISCMC_WITH_LIBARCHIVE
namespace {

// A folder of its own, removed at its end with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "discmc-zip-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw VolumeError(name + ": no folder can be made here; set TMPDIR to another place");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

using Archive = std::unique_ptr<archive, int (*)(archive*)>;

// The name that a member has in the folder: without what would lead out of it.
std::filesystem::path inner_path(const char* name) {
  std::filesystem::path inner;
  for (const std::filesystem::path& part : std::filesystem::path(name == nullptr ? "" : name))
    if (part != "/" && part != "." && part != "..") inner /= part;
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
    fail(zip, file.filename().string() + " is damaged or encrypted in it",
         "copy or export the archive again, without a password");
  if (!out.flush())
    fail(zip, "it cannot be unpacked into " + file.parent_path().string(),
         "set TMPDIR to a folder with more space");
}

void unpack(const std::filesystem::path& zip, const std::filesystem::path& folder) {
  const Archive reader(archive_read_new(), archive_read_free);
  if (!reader) throw VolumeError("libarchive does not start; the memory may be exhausted");
  archive_read_support_format_zip(reader.get());
  constexpr std::size_t block_bytes = 65536;
  int result = archive_read_open_filename(reader.get(), zip.c_str(), block_bytes);
  archive_entry* entry = nullptr;
  while (result >= ARCHIVE_WARN &&
         (result = archive_read_next_header(reader.get(), &entry)) >= ARCHIVE_WARN &&
         result != ARCHIVE_EOF) {
    const std::filesystem::path name = inner_path(archive_entry_pathname(entry));
    if (archive_entry_filetype(entry) == AE_IFREG && name.has_filename())
      unpack_member(zip, reader.get(), folder / name);
  }
  if (result != ARCHIVE_EOF)
    fail(zip, "the archive is damaged or no zip", "copy or export it again");
}

// Goes into folders that hold nothing but a folder.
std::filesystem::path filled_folder(std::filesystem::path folder) {
  for (;;) {
    std::filesystem::directory_iterator entry(folder);
    if (entry == end(entry)) return folder;
    const std::filesystem::directory_entry first = *entry;
    if (!first.is_directory() || ++entry != end(entry)) return folder;
    folder = first.path();
  }
}

// A volume whose files are gone when it is closed, and bear the name of the archive in errors.
class UnpackedVolume final : public VolumeReader {
 public:
  UnpackedVolume(const std::filesystem::path& zip, const VolumeOptions& options) : zip_(zip) {
    unpack(zip, folder_.path());
    renamed([&] { volume_ = open_folder(filled_folder(folder_.path()), options); });
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
      std::string text = error.what();
      const std::string folder = folder_.path().string(), zip = zip_.string();
      for (std::size_t at = text.find(folder); at != std::string::npos;
           at = text.find(folder, at + zip.size()))
        text.replace(at, folder.size(), zip);
      throw VolumeError(text);
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

}  // namespace discmc::host
