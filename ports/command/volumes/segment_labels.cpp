#include "segment_labels.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "number_text.hpp"
#include "volume_format.hpp"

namespace discmc::host {
namespace {

// Red, green and blue from 0 to 1.
std::optional<Srgb> colour_of(std::string_view text) {
  const auto parts = words(text);
  Srgb colour{};
  if (parts.size() != colour.size()) return std::nullopt;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const auto part = finite_number(std::string(parts[i]));
    if (!part || *part < 0 || *part > 1) return std::nullopt;
    colour[i] = static_cast<std::uint8_t>(std::lround(255 * *part));
  }
  return colour;
}

}  // namespace

void SegmentLabels::take(std::string_view key, std::string_view value) {
  constexpr std::string_view begin = "Segment";
  const std::size_t end = key.find('_');
  if (end == std::string_view::npos || key.substr(0, begin.size()) != begin ||
      !whole_number<std::uint32_t>(key.substr(begin.size(), end - begin.size())))
    return;
  std::string Segment::*const part = key.substr(end) == "_Name"         ? &Segment::name
                                     : key.substr(end) == "_LabelValue" ? &Segment::label
                                     : key.substr(end) == "_Color"      ? &Segment::colour
                                                                        : nullptr;
  if (part != nullptr) segments_[std::string(key.substr(0, end))].*part = trimmed(value);
}

LabelTable SegmentLabels::table() const {
  LabelTable table;
  for (const auto& [key, segment] : segments_) {
    const auto label = whole_number<std::int64_t>(segment.label);
    if (label && !segment.name.empty())
      table.emplace(*label, LabelDescription{segment.name, colour_of(segment.colour)});
  }
  return table;
}

}  // namespace discmc::host
