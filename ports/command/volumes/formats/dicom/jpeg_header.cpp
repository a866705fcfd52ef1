#include "jpeg_header.hpp"

#include <optional>

namespace discmc::command {
namespace {

struct Header {
  std::uint32_t components;
  PictureSize size;
};

bool is_frame_header(std::uint8_t marker) {
  constexpr std::uint8_t of_jpeg_ls = 0xf7, huffman_tables = 0xc4, reserved = 0xc8,
                         arithmetic_tables = 0xcc;
  return marker == of_jpeg_ls || (marker >= 0xc0 && marker <= 0xcf && marker != huffman_tables &&
                                  marker != reserved && marker != arithmetic_tables);
}

// Nothing if samples come before a header, or none is whole.
std::optional<Header> header(const std::uint8_t* bytes, std::size_t count) {
  const auto number = [bytes](std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at] << 8 | bytes[at + 1]);
  };
  constexpr std::uint8_t start_of_samples = 0xda;
  constexpr std::size_t start_bytes = 2, frame_header_bytes = 10;
  for (std::size_t at = start_bytes; at + frame_header_bytes <= count && bytes[at] == 0xff;) {
    const std::uint8_t marker = bytes[at + 1];
    if (marker == start_of_samples) break;
    if (is_frame_header(marker))
      return Header{bytes[at + 9], {number(at + 7), number(at + 5), (bytes[at + 4] + 7U) / 8}};
    // Before a marker there may be more of its first byte.
    at += marker == 0xff ? 1 : 2 + number(at + 2);
  }
  return std::nullopt;
}

std::string text(PictureSize size) {
  return std::to_string(size.columns) + " x " + std::to_string(size.rows) + " samples of " +
         std::to_string(8 * size.sample_bytes) + " bits";
}

}  // namespace

std::string jpeg_mismatch(const std::uint8_t* bytes, std::size_t count, PictureSize size) {
  const std::optional<Header> found = header(bytes, count);
  if (!found) return "the JPEG data has no header";
  if (found->components != 1)
    return "the JPEG picture has " + std::to_string(found->components) + " components; expected 1";
  const PictureSize its = found->size;
  if (its.columns != size.columns || its.rows != size.rows || its.sample_bytes != size.sample_bytes)
    return "the JPEG picture has " + text(its) + "; expected " + text(size);
  return {};
}

}  // namespace discmc::command
