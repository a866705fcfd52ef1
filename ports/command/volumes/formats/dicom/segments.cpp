#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "attributes.hpp"
#include "segmentation.hpp"

namespace discmc::command {
namespace {

// Converts a CIELab root to a share of white.
double share(double root) {
  constexpr double linear_below = 6.0 / 29;
  return root > linear_below ? root * root * root
                             : (root - 4.0 / 29) * 3 * linear_below * linear_below;
}

std::uint8_t encoded_srgb(double linear) {
  return byte_of_share(encoded_light(linear));
}

std::optional<Srgb> colour(DcmItem& segment) {
  std::array<std::uint16_t, 3> lab{};
  for (std::size_t i = 0; i < 3; ++i)
    if (segment.findAndGetUint16(DCM_RecommendedDisplayCIELabValue, lab[i], i).bad())
      return std::nullopt;
  return srgb_of_cielab(lab);
}

}  // namespace

Srgb srgb_of_cielab(const std::array<std::uint16_t, 3>& encoded) {
  constexpr double max_component = 65535;
  const double lightness = 100 * encoded[0] / max_component;
  const double a = 255 * encoded[1] / max_component - 128;
  const double b = 255 * encoded[2] / max_component - 128;
  const double root = (lightness + 16) / 116;
  // The white of sRGB is the illuminant D65.
  const double x = 0.95047 * share(root + a / 500);
  const double y = share(root);
  const double z = 1.08883 * share(root - b / 200);
  return {encoded_srgb(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          encoded_srgb(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          encoded_srgb(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

DicomSegments segments_of(DcmItem& dataset) {
  DicomSegments segments;
  const std::string type = text_of(dataset, DCM_SegmentationType);
  if (type == "FRACTIONAL") {
    segments.kind = DicomSegments::Kind::fractions;
    segments.full = std::max(1U, whole_of(dataset, DCM_MaximumFractionalValue).value_or(255));
  } else if (type == "LABELMAP") {
    segments.kind = DicomSegments::Kind::numbers;
  }
  DcmItem* segment = nullptr;
  for (signed long i = 0; dataset.findAndGetSequenceItem(DCM_SegmentSequence, segment, i).good();
       ++i)
    if (const auto number = whole_of(*segment, DCM_SegmentNumber))
      segments.all[*number] = {name_in(dataset, *segment, DCM_SegmentLabel), colour(*segment)};
  return segments;
}

void Overlaps::start_slice(std::size_t voxels) {
  slice_.assign(voxels, 0);
}

// Returns the number of a set with one more segment.
std::uint32_t Overlaps::number_with(std::uint32_t before, std::uint32_t segment) {
  Set set = sets_[before];
  for (const std::uint32_t other : set) {
    neighbours_[segment].insert(other);
    neighbours_[other].insert(segment);
  }
  set.push_back(segment);
  constexpr std::size_t max_sets = 1U << 20;
  const auto next = static_cast<std::uint32_t>(sets_.size());
  const auto [entry, is_new] = numbers_.emplace(set, next);
  if (is_new) sets_.push_back(std::move(set));
  if (sets_.size() > max_sets) throw std::length_error("segments overlap in too many ways");
  return entry->second;
}

void Overlaps::add(std::uint32_t segment, const std::uint8_t* voxels) {
  std::map<std::uint32_t, std::uint32_t> with_segment;  // keyed by the set without it
  std::uint32_t last_before = 0;
  std::uint32_t last_after = 0;
  for (std::size_t i = 0; i < slice_.size(); ++i) {
    if (voxels[i] == 0) continue;
    if (last_after == 0 || slice_[i] != last_before) {
      last_before = slice_[i];
      const auto [entry, is_new] = with_segment.emplace(last_before, 0);
      if (is_new) entry->second = number_with(last_before, segment);
      last_after = entry->second;
    }
    slice_[i] = last_after;
  }
}

std::map<std::uint32_t, std::uint32_t> Overlaps::layers(
    const std::set<std::uint32_t>& segments) const {
  std::map<std::uint32_t, std::uint32_t> layers;
  for (const std::uint32_t segment : segments) {
    std::set<std::uint32_t> neighbour_layers;
    if (const auto found = neighbours_.find(segment); found != neighbours_.end())
      for (const std::uint32_t other : found->second)
        if (const auto layer = layers.find(other); layer != layers.end())
          neighbour_layers.insert(layer->second);
    std::uint32_t layer = 0;
    while (neighbour_layers.count(layer) > 0) ++layer;
    layers[segment] = layer;
  }
  return layers;
}

}  // namespace discmc::command
