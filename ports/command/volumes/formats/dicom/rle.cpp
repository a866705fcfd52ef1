#include "decoders.hpp"

#include <algorithm>

#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

// The header has the number of segments, and the offsets of up to 15.
constexpr std::size_t word_bytes = 4;
constexpr std::size_t header_bytes = 16 * word_bytes;

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t index) {
  return static_cast<std::uint32_t>(whole_of(&bytes[index * word_bytes], word_bytes, false));
}

// The samples' bytes in one segment: every sample_bytes-th byte, from `byte` on.
struct Plane {
  unsigned char* byte;
  std::size_t sample_bytes;
  std::size_t count;
};

// Returns what is wrong with the segment; empty if nothing.
std::string unpack(const std::uint8_t* at, const std::uint8_t* end, const Plane& plane) {
  const std::string size = std::to_string(plane.count);
  for (std::size_t done = 0; done < plane.count;) {
    if (at == end) return "ends after " + std::to_string(done) + " of " + size + " bytes";
    const std::uint8_t code = *at++;
    constexpr std::uint8_t nothing = 128;
    if (code == nothing) continue;
    const bool is_repeated = code > nothing;
    const std::size_t length = is_repeated ? std::size_t{257} - code : std::size_t{code} + 1;
    const std::size_t stored = is_repeated ? 1 : length;
    if (stored > static_cast<std::size_t>(end - at))
      return "ends within a run of " + std::to_string(length) + " bytes";
    if (length > plane.count - done) return "has more than the " + size + " bytes of the picture";
    for (std::size_t i = 0; i < length; ++i)
      plane.byte[plane.sample_bytes * done++] = is_repeated ? *at : at[i];
    at += stored;
  }
  // Segments are padded to even sizes.
  if (std::any_of(at, end, [](std::uint8_t byte) { return byte != 0; }))
    return "has more than the " + size + " bytes of the picture";
  return {};
}

}  // namespace

std::string decode_rle(const std::vector<std::uint8_t>& bytes, PictureSize size,
                       unsigned char* samples) {
  if (bytes.size() < header_bytes)
    return "the RLE data of " + std::to_string(bytes.size()) + " bytes has no header of 64";
  const std::uint32_t segments = word(bytes, 0);
  if (segments != size.sample_bytes)
    return "the RLE header counts " + std::to_string(segments) + " segments; expected " +
           std::to_string(size.sample_bytes) + ", one per byte of a sample";
  for (std::size_t i = 0; i < segments; ++i) {
    const std::size_t begin = word(bytes, i + 1);
    const std::size_t end = i + 1 < segments ? word(bytes, i + 2) : bytes.size();
    const std::string name = "RLE segment " + std::to_string(i + 1);
    if (begin < header_bytes || begin > end || end > bytes.size())
      return name + ", from byte " + std::to_string(begin) + " to " + std::to_string(end) +
             ", is not within the data of " + std::to_string(bytes.size()) + " bytes";
    // The first segment has the high bytes.
    const std::size_t byte = is_native_big_endian() ? i : segments - 1 - i;
    const Plane plane = {samples + byte, segments, std::size_t{size.columns} * size.rows};
    const std::string damage = unpack(bytes.data() + begin, bytes.data() + end, plane);
    if (!damage.empty()) return name + " " + damage;
  }
  return {};
}

}  // namespace discmc::command
