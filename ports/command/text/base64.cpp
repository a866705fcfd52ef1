#include "base64.hpp"

#include <string>

namespace discmc::command {
namespace {

constexpr char characters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::streamsize Base64::xsputn(const char* bytes, std::streamsize count) {
  std::string text;
  text.reserve(static_cast<std::size_t>(count) / 3 * 4 + 4);
  for (std::streamsize i = 0; i < count; ++i) {
    bits_ = bits_ << 8 | static_cast<unsigned char>(bytes[i]);
    if (++waiting_ < 3) continue;
    for (const int shift : {18, 12, 6, 0}) text += characters[bits_ >> shift & 63];
    waiting_ = 0;
  }
  out_ << text;
  return out_ ? count : 0;
}

void Base64::finish() {
  if (waiting_ == 0) return;
  const bool has_two = waiting_ == 2;
  const std::uint32_t bits = bits_ << (has_two ? 8 : 16);
  out_ << characters[bits >> 18 & 63] << characters[bits >> 12 & 63]
       << (has_two ? characters[bits >> 6 & 63] : '=') << '=';
  waiting_ = 0;
}

}  // namespace discmc::command
