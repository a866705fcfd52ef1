// Bytes in the 64 characters of RFC 4648.
#pragma once

#include <cstdint>
#include <ostream>
#include <streambuf>

namespace discmc::command {

/// Takes bytes as the buffer of a stream, and writes their characters to another one.
class Base64 : public std::streambuf {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}

  /// Call last: writes what is left, and the padding.
  void finish();

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;

 private:
  std::ostream& out_;
  std::uint32_t bits_ = 0;  // of the bytes that wait for a third
  int waiting_ = 0;
};

}  // namespace discmc::command
