// Bytes in the 64 characters of RFC 4648.
#pragma once

#include <cstdint>
#include <ostream>
#include <streambuf>

namespace discmc::command {

/// A stream buffer that writes its bytes as base64 to another buffer.
class Base64 : public std::streambuf {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}

  /// Writes the rest and the padding. Call it last.
  void finish();

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;

 private:
  std::ostream& out_;
  std::uint32_t bits_ = 0;  // bytes of an incomplete group of three
  int waiting_ = 0;
};

}  // namespace discmc::command
