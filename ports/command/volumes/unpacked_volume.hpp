// Volumes whose readers take files alone, out of something that is packed.
#pragma once

#include <sys/types.h>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "volume_info.hpp"
#include "volume_stream.hpp"

namespace discmc::command {

/// The volume of files that `open` unpacks into a folder for temporary files and opens. They are
/// removed when it is closed, and bear the name of what was packed in errors. packing: for people,
/// behind the format.
std::unique_ptr<VolumeReader> unpacked_volume(
    const std::filesystem::path& packed, std::string_view packing,
    const std::function<std::unique_ptr<VolumeReader>(const std::filesystem::path& folder)>& open);

/// Writes what is left of a stream into a file, for which folders are made.
void unpack(ByteStream& stream, const std::filesystem::path& file);

/// A folder of its own, removed at its end with its contents, and also when a signal ends the
/// program. Patients' data must not stay. A process that waits for that end removes it.
class TemporaryFolder {
 public:
  /// Throws VolumeError where there can be none.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  void leave_to_remover();
  [[noreturn]] void remove_at_end(int end, int alive) const;

  std::filesystem::path path_;
  pid_t remover_ = 0;
  int alive_ = -1;
};

}  // namespace discmc::command
