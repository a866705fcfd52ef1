#include "layers.hpp"

#include <stdexcept>

namespace discmc::command {

void Overlaps::start_slice(std::size_t voxels) {
  slice_.assign(voxels, 0);
}

// The sets of a set of segments and one more.
std::uint32_t Overlaps::number_with(std::uint32_t before, std::uint32_t segment) {
  Set set = sets_[before];
  for (const std::uint32_t other : set) {
    neighbours_[segment].insert(other);
    neighbours_[other].insert(segment);
  }
  set.push_back(segment);
  constexpr std::size_t most = 1U << 20;
  const auto next = static_cast<std::uint32_t>(sets_.size());
  const auto [entry, is_new] = numbers_.emplace(set, next);
  if (is_new) sets_.push_back(std::move(set));
  if (sets_.size() > most) throw std::length_error("segments overlap in too many ways");
  return entry->second;
}

void Overlaps::add(std::uint32_t segment, const std::uint8_t* voxels) {
  std::map<std::uint32_t, std::uint32_t> with_segment;  // by the number of the set without it
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
    std::set<std::uint32_t> taken;
    if (const auto found = neighbours_.find(segment); found != neighbours_.end())
      for (const std::uint32_t other : found->second)
        if (const auto layer = layers.find(other); layer != layers.end())
          taken.insert(layer->second);
    std::uint32_t layer = 0;
    while (taken.count(layer) > 0) ++layer;
    layers[segment] = layer;
  }
  return layers;
}

}  // namespace discmc::command
