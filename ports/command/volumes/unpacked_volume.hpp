// Unpacks volumes whose readers need files.
#pragma once

#include <sys/types.h>
#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "volume_info.hpp"
#include "volume_stream.hpp"

namespace discmc::command {

/// Returns the volume of files that `open` unpacks into a temporary folder and opens. Closing the
/// volume removes the files. Errors show their names in the packed file. packing: for people,
/// behind the format.
std::unique_ptr<VolumeReader> unpacked_volume(
    const std::filesystem::path& packed, std::string_view packing,
    const std::function<std::unique_ptr<VolumeReader>(const std::filesystem::path& folder)>& open);

/// Writes all bytes that `read` returns to a file, and creates its folders. Returns whether the
/// file is complete.
bool write_bytes(const std::filesystem::path& file,
                 const std::function<std::size_t(void* bytes, std::size_t count)>& read);

/// Writes the rest of a stream to a file, and creates its folders.
void unpack(ByteStream& stream, const std::filesystem::path& file);

/// A temporary folder, removed with its content when the object or the program ends, even by a
/// signal, because patients' data must not stay. A process that waits for this end removes the
/// folder.
class TemporaryFolder {
 public:
  /// Throws VolumeError if the folder cannot be created.
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
