#include "segment_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

// Red, green and blue from 0 to 1.
std::optional<Srgb> colour_of(std::string_view text) {
  const auto parts = words(text);
  Srgb colour{};
  if (parts.size() != colour.size()) return std::nullopt;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const auto part = finite_number(parts[i]);
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
                                     : key.substr(end) == "_Layer"      ? &Segment::layer
                                                                        : nullptr;
  if (part != nullptr) segments_[std::string(key.substr(0, end))].*part = trimmed(value);
}

LabelTable SegmentLabels::table(std::optional<std::uint32_t> layer, VolumeInfo& info) const {
  std::map<std::int64_t, std::vector<const Segment*>> by_label;
  for (const auto& [key, segment] : segments_) {
    const auto label = whole_number<std::int64_t>(segment.label);
    if (label && !segment.name.empty()) by_label[*label].push_back(&segment);
  }
  LabelTable table;
  std::string ambiguous;
  std::size_t count = 0;
  for (auto& [label, segments] : by_label) {
    // Segments that overlap are in layers, each with labels from 1 on.
    if (layer && segments.size() > 1)
      segments.erase(
          std::remove_if(segments.begin(), segments.end(),
                         [&](const Segment* segment) {
                           return whole_number<std::uint32_t>(segment->layer).value_or(0) != *layer;
                         }),
          segments.end());
    if (segments.size() == 1)
      table[label] = {segments[0]->name, colour_of(segments[0]->colour)};
    else if (segments.size() > 1 && ++count == 1)
      ambiguous = "label " + std::to_string(label) + " of " + shown(segments[0]->name) + " and " +
                  shown(segments[1]->name);
  }
  if (count > 0)
    note(info, "labels that several segments share left without a name: " + std::to_string(count) +
                   ", such as " + ambiguous + "; to name them give --label-table");
  return table;
}

}  // namespace discmc::command
