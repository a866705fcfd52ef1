#include "unpacked_volume.hpp"

#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "packing.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

using Open = std::function<std::unique_ptr<VolumeReader>(const std::filesystem::path& folder)>;

class UnpackedVolume final : public VolumeReader {
 public:
  UnpackedVolume(std::filesystem::path packed, std::string_view packing, const Open& open)
      : packed_(std::move(packed)) {
    renamed([&] { volume_ = open(folder_.path()); });
    info_ = volume_->info();
    info_.format += ", " + std::string(packing);
    info_.notes = in_packed(info_.notes);
  }

  const VolumeInfo& info() const override { return info_; }
  const std::vector<std::string>& notes() const override {
    notes_ = in_packed(volume_->notes());
    return notes_;
  }
  void read_slice(void* samples) override {
    renamed([&] { volume_->read_slice(samples); });
  }
  void skip_slice() override {
    renamed([&] { volume_->skip_slice(); });
  }

 private:
  template <class Call>
  void renamed(Call call) {
    try {
      call();
    } catch (const VolumeError& error) {
      const std::filesystem::path inner =
          std::filesystem::path(error.file()).lexically_relative(folder_.path());
      const bool is_inside = !inner.empty() && *inner.begin() != "..";
      fail(is_inside ? named(inner).string() : error.file(), in_packed(error.fault()),
           in_packed(error.remedy()));
    }
  }

  // Converts patterns of files in the folder to patterns in the packed file.
  std::string in_packed(std::string text) const {
    const std::string folder = folder_.path().string(), packed = packed_.string();
    for (std::size_t at = text.find(folder); at != std::string::npos;
         at = text.find(folder, at + packed.size()))
      text.replace(at, folder.size(), packed);
    return text;
  }

  std::vector<std::string> in_packed(std::vector<std::string> notes) const {
    for (std::string& note : notes) note = in_packed(std::move(note));
    return notes;
  }

  // Converts the name of a file in the folder to its name in the packed file.
  std::filesystem::path named(const std::filesystem::path& inner) const {
    return inner == "." || inner == without_packing(packed_).filename() ? packed_ : packed_ / inner;
  }

  std::filesystem::path packed_;
  TemporaryFolder folder_;
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
  mutable std::vector<std::string> notes_;  // including notes that reading added
};

// The ends of pipes that close when this program ends. Removers inherit earlier ends.
std::set<int>& others_alive() {
  static std::set<int> ends;
  return ends;
}

}  // namespace

std::unique_ptr<VolumeReader> unpacked_volume(const std::filesystem::path& packed,
                                              std::string_view packing, const Open& open) {
  return std::make_unique<UnpackedVolume>(packed, packing, open);
}

bool write_bytes(const std::filesystem::path& file,
                 const std::function<std::size_t(void*, std::size_t)>& read) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  std::ofstream out(file, std::ios::binary);
  std::array<char, 65536> block;
  std::size_t got = 0;
  while (out && (got = read(block.data(), block.size())) > 0)
    out.write(block.data(), static_cast<std::streamsize>(got));
  return static_cast<bool>(out.flush());
}

void unpack(ByteStream& stream, const std::filesystem::path& file) {
  const bool is_written =
      write_bytes(file, [&](void* bytes, std::size_t count) { return stream.read(bytes, count); });
  stream.check_end();
  if (!stream.damage().empty()) fail(stream.file(), stream.damage(), "copy the file again");
  if (!is_written)
    fail(stream.file(), "the file cannot be unpacked into the temporary folder",
         "set TMPDIR to a folder with more space, or unpack it yourself");
}

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  std::string name =
      (std::filesystem::temp_directory_path(error) / "discmc-unpacked-XXXXXX").string();
  if (error || mkdtemp(name.data()) == nullptr)
    fail(name, "there is no folder for temporary files",
         "set TMPDIR to a folder that can be written");
  path_ = name;
  leave_to_remover();
}

TemporaryFolder::~TemporaryFolder() {
  close(alive_);
  others_alive().erase(alive_);
  waitpid(remover_, nullptr, 0);
}

void TemporaryFolder::leave_to_remover() {
  int ends[2];
  if (pipe(ends) != 0 || (remover_ = fork()) < 0) {
    rmdir(path_.c_str());
    fail(path_, "the process that removes unpacked files cannot be started",
         "unpack it and give the file or the folder");
  }
  if (remover_ == 0) remove_at_end(ends[0], ends[1]);
  close(ends[0]);
  alive_ = ends[1];
  others_alive().insert(alive_);
}

void TemporaryFolder::remove_at_end(int end, int alive) const {
  setsid();  // shields it from signals of the terminal
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

}  // namespace discmc::command
