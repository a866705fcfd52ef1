// Writes TIFF files tag by tag, for the tests of their reader.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tiff_writer {

/// The values of a tag: of 32 bits, fractions of two such values, or text.
struct Values {
  enum class Kind : std::uint16_t { text = 2, whole = 4, fraction = 5 };
  Kind kind = Kind::whole;
  std::vector<std::uint32_t> numbers = {};
  std::string text = {};
};

inline Values whole(std::vector<std::uint32_t> numbers) {
  return {Values::Kind::whole, std::move(numbers)};
}
inline Values fraction(std::uint32_t above, std::uint32_t below = 1) {
  return {Values::Kind::fraction, {above, below}};
}
inline Values text(const std::string& text) {
  return {Values::Kind::text, {}, text + '\0'};
}

using Tags = std::map<std::uint16_t, Values>;

namespace tag {
constexpr std::uint16_t kind_of_page = 254, bits = 258, compression = 259, photometric = 262,
                        description = 270, orientation = 274, samples = 277, x_resolution = 282,
                        y_resolution = 283, resolution_unit = 296, sub_directories = 330,
                        sample_format = 339;
}  // namespace tag

/// A little-endian file of pages with one strip each.
class TiffWriter {
 public:
  /// more: tags that replace those of 8-bit grey.
  TiffWriter& page(std::uint32_t width, std::uint32_t height, const std::string& samples,
                   const Tags& more = {}) {
    const std::size_t at = append(samples);
    Tags tags = {
        {256, whole({width})},          {257, whole({height})},
        {tag::bits, whole({8})},        {tag::compression, whole({1})},
        {tag::photometric, whole({1})}, {273, whole({static_cast<std::uint32_t>(at)})},
        {278, whole({height})},         {279, whole({static_cast<std::uint32_t>(samples.size())})}};
    for (const auto& [number, values] : more) tags[number] = values;
    append_directory(tags);
    return *this;
  }

  /// Appends bytes outside every directory.
  TiffWriter& behind(const std::string& bytes) {
    append(bytes);
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  static std::string little(std::uint64_t value, std::size_t size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
  }

  std::size_t append(const std::string& bytes) {
    const std::size_t at = bytes_.size();
    bytes_ += bytes;
    bytes_.resize(bytes_.size() + bytes_.size() % 2);
    return at;
  }

  void append_directory(const Tags& tags) {
    std::string entries;
    for (const auto& [number, values] : tags) entries += entry(number, values);
    const std::size_t at = append(little(tags.size(), 2) + entries + little(0, 4));
    bytes_.replace(next_, 4, little(at, 4));
    next_ = at + 2 + entries.size();
  }

  std::string entry(std::uint16_t number, const Values& values) {
    std::string stored = values.text;
    for (const std::uint32_t value : values.numbers) stored += little(value, 4);
    const std::size_t of_one = values.kind == Values::Kind::text       ? 1
                               : values.kind == Values::Kind::fraction ? 8
                                                                       : 4;
    const std::size_t count = stored.size() / of_one;
    stored.resize(stored.size() < 4 ? 4 : stored.size());
    if (stored.size() > 4) stored = little(append(stored), 4);
    return little(number, 2) + little(static_cast<std::uint16_t>(values.kind), 2) +
           little(count, 4) + stored;
  }

  std::string bytes_ = std::string("II*\0", 4) + little(0, 4);
  std::size_t next_ = 4;
};

}  // namespace tiff_writer
