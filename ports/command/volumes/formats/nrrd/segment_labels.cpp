#include "header.hpp"

#include <cstddef>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/label_table.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

std::optional<Srgb> colour_of(std::string_view text) {
  const auto parts = words(text);
  if (parts.size() != 3) return std::nullopt;
  return colour_of_shares({parts[0], parts[1], parts[2]});
}

// NRRD encodes line feeds and backslashes in values as \n and \\.
std::string unescaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    if (is_escape) ++i;
    result += is_escape && text[i] == 'n' ? '\n' : text[i];
  }
  return result;
}

}  // namespace

void SegmentLabels::add(std::string_view key, std::string_view value) {
  constexpr std::string_view begin = "Segment";
  const std::size_t end = key.find('_');
  if (end == std::string_view::npos || key.substr(0, begin.size()) != begin) return;
  const std::string_view part = key.substr(end);
  const std::string text = unescaped(trimmed(value));
  // Slicer used the second name before version 5.
  if (part == "_SourceRepresentation" || part == "_MasterRepresentation")
    is_fractional_ = text == "Fractional labelmap";
  const auto number = whole_number<std::uint32_t>(key.substr(begin.size(), end - begin.size()));
  if (!number) return;
  Segment& segment = segments_[*number];
  if (part == "_Name") segment.name = text;
  if (part == "_ID") segment.id = text;
  if (part == "_Color") segment.colour = text;
  if (part == "_LabelValue") segment.label = text;
  if (part == "_Layer") segment.layer = text;
}

void SegmentLabels::describe(VolumeInfo& info) const {
  if (is_fractional_) {
    note(info, "a fractional segmentation; its values are fractions, not labels");
    return;
  }
  std::size_t outside = 0;
  std::string first_outside;
  for (const auto& [number, segment] : segments_) {
    // Before Slicer had labels, every segment was a layer of its own, with value 1.
    const bool is_old = !segment.label && !segment.layer;
    const auto label = is_old ? LabelValue(1) : label_value(segment.label.value_or(""));
    const auto layer =
        is_old ? number : whole_number<std::uint32_t>(segment.layer.value_or("0")).value_or(0);
    const std::string& name = segment.name.empty() ? segment.id : segment.name;
    if (!label || name.empty()) continue;
    if (layer < info.frames)
      info.labels.push_back({name, colour_of(segment.colour), {*label}, layer});
    else if (outside++ == 0)
      first_outside = shown(name) + " of layer " + std::to_string(layer);
  }
  if (outside > 0)
    note(info, "segments of layers that are not in the file are left out: " +
                   std::to_string(outside) + ", such as " + first_outside);
}

}  // namespace discmc::command
