// A file for data that does not fit in memory.
#pragma once

#include <cstddef>
#include <cstdint>

namespace discmc::command {

/// A file without a name in the folder TMPDIR. It disappears when the program ends, for whatever
/// reason. All functions throw std::runtime_error if the system refuses.
class TemporaryFile {
 public:
  TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Returns the offset of the bytes.
  std::uint64_t append(const void* data, std::size_t bytes);
  /// Limit: only bytes that were appended.
  void read(std::uint64_t from, void* data, std::size_t bytes) const;

 private:
  int file_;
  std::uint64_t size_ = 0;
};

}  // namespace discmc::command
