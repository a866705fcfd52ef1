#include "mosaic.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "text/words.hpp"

namespace discmc::command {
namespace {

// Takes little-endian numbers and texts off the front, nothing behind the end.
class Taker {
 public:
  explicit Taker(std::string_view bytes) : left_(bytes) {}

  std::optional<std::string_view> bytes(std::size_t count) {
    if (count > left_.size()) return std::nullopt;
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }

  std::optional<std::uint32_t> number() {
    const auto four = bytes(4);
    if (!four) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>((*four)[i]);
    return value;
  }

 private:
  std::string_view left_;
};

std::string text(std::string_view padded) {
  return std::string(trimmed(padded.substr(0, padded.find('\0'))));
}

struct Element {
  std::string name;
  std::uint32_t values = 0;  ///< the others of its items are empty
  std::uint32_t items = 0;
};

std::optional<Element> take_element(Taker& taker) {
  const auto name = taker.bytes(64);
  const auto values = taker.number();
  const auto kind = taker.bytes(8);  // the value representation, twice
  const auto items = taker.number();
  const auto check = taker.number();
  if (!name || !values || !kind || !items || !check) return std::nullopt;
  return Element{text(*name), *values, *items};
}

// The second of four numbers before an item is its length. In the older kind it is the first, which
// counts the items of the first element in.
std::optional<std::string_view> take_item(Taker& taker, bool is_newer, std::uint32_t excess) {
  const auto first = taker.number();
  const auto second = taker.number();
  if (!first || !second || !taker.bytes(8)) return std::nullopt;
  if (!is_newer && *first < excess) return std::nullopt;
  const std::uint32_t length = is_newer ? *second : *first - excess;
  const auto item = taker.bytes(length);
  const std::uint32_t padding = (4 - length % 4) % 4;
  if (!item || !taker.bytes(padding)) return std::nullopt;
  return item;
}

}  // namespace

CsaHeader read_csa_header(std::string_view bytes) {
  constexpr std::uint32_t max_elements = 1000;
  const bool is_newer = bytes.substr(0, 4) == "SV10";
  if (is_newer) bytes.remove_prefix(std::min<std::size_t>(8, bytes.size()));
  Taker taker(bytes);
  CsaHeader header;
  const auto elements = taker.number();
  if (!elements || *elements > max_elements || !taker.number()) return header;
  std::uint32_t excess = 0;
  for (std::uint32_t i = 0; i < *elements; ++i) {
    const auto element = take_element(taker);
    if (!element) return header;
    if (i == 0) excess = element->items;
    for (std::uint32_t item = 0; item < element->items; ++item) {
      const auto value = take_item(taker, is_newer, excess);
      if (!value) return header;
      if (item < element->values) header[element->name].push_back(text(*value));
    }
  }
  return header;
}

}  // namespace discmc::command
