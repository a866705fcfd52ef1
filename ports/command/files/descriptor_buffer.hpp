// A stream's way to an open file.
#pragma once

#include <array>
#include <cstddef>
#include <streambuf>

namespace discmc::command {

/// Writes to a descriptor of the system, which std::ofstream cannot be given. What is left in the
/// buffer is written by a flush of the stream only. Seeks if the file can. Errors: the stream turns
/// bad, and errno has the cause.
class DescriptorBuffer final : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor);

 protected:
  int_type overflow(int_type byte) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int sync() override;
  pos_type seekpos(pos_type place, std::ios_base::openmode which) override;

 private:
  bool write_all(const char* bytes, std::size_t count) const;

  int descriptor_;
  std::array<char, 8192> waiting_;
};

}  // namespace discmc::command
