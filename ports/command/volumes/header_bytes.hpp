// A header of fixed length, whose fields are at offsets.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "text/number_text.hpp"
#include "volume_error.hpp"
#include "volume_stream.hpp"

namespace discmc::command {

/// Returns the decimal number that the writer meant by a float: 0.01f is 0.01.
inline double decimal(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return *decimal_number({text.data(), static_cast<std::size_t>(end - text.data())});
}

class HeaderBytes {
 public:
  /// Reads the header. Throws VolumeError if the file is shorter.
  HeaderBytes(ByteStream& stream, std::size_t bytes, bool is_big_endian)
      : bytes_(bytes, '\0'), is_turned_(is_big_endian != is_native_big_endian()) {
    if (stream.read(bytes_.data(), bytes) < bytes)
      fail(stream.file(), "the header of " + std::to_string(bytes) + " bytes is incomplete",
           copy_or_export);
  }

  std::string_view text(std::size_t offset, std::size_t count) const {
    return std::string_view(bytes_).substr(offset, count);
  }

  /// Units of all offsets: bytes. Limit: the field lies in the header.
  template <class Number>
  Number number(std::size_t offset) const {
    char bytes[sizeof(Number)];
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(offset), sizeof bytes, bytes);
    if (is_turned_) std::reverse(bytes, bytes + sizeof bytes);
    Number value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

  /// Returns three successive numbers, each as decimal().
  std::array<double, 3> reals(std::size_t offset) const {
    return {decimal(number<float>(offset)), decimal(number<float>(offset + 4)),
            decimal(number<float>(offset + 8))};
  }

 private:
  std::string bytes_;
  bool is_turned_;
};

}  // namespace discmc::command
