// A file for what does not fit in memory.
#pragma once

#include <cstddef>
#include <cstdint>

namespace discmc::command {

/// In the folder that TMPDIR names, without a name of its own: it is gone when the program ends,
/// however it ends. All throw std::runtime_error where the system refuses.
class TemporaryFile {
 public:
  TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Returns where the bytes begin.
  std::uint64_t append(const void* data, std::size_t bytes);
  /// Limit: bytes that were appended.
  void read(std::uint64_t from, void* data, std::size_t bytes) const;

 private:
  int file_;
  std::uint64_t size_ = 0;
};

}  // namespace discmc::command
