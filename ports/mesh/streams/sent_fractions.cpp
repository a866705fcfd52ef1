#include "sent_fractions.hpp"

#include <discmc/fraction.hpp>

namespace discmc::meshing {

void SentFractions::accept(const Event& event) {
  if (event.kind == Event::Kind::start) {
    width_ = static_cast<std::uint16_t>(event.header->width);
    levels_ = event.header->levels;
  }
  if (event.kind != Event::Kind::fractions) return;
  rows_.push_back({event.slice, event.row, voxels_.size()});
  for (std::uint16_t x = 0; x < width_; ++x)
    if (event.fractions[x] != 0) voxels_.push_back({x, event.fractions[x]});
}

void SentFractions::place(Crossings& crossings) const {
  constexpr float eighths_of_half_steps = 4;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const std::size_t end = i + 1 < rows_.size() ? rows_[i + 1].begin : voxels_.size();
    for (std::size_t voxel = row.begin; voxel < end; ++voxel)
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t fraction = fraction_of(voxels_[voxel].entry, axis);
        if (fraction == 0) continue;
        const Vertex middle = edge_midpoint(voxels_[voxel].x, row.row, row.slice, axis);
        if (const auto place = crossings.find(middle))
          crossings.move(*place, static_cast<float>(fraction) / eighths_of_half_steps, levels_);
      }
  }
}

}  // namespace discmc::meshing
