#include "volume_offset.hpp"

#include <algorithm>
#include <cmath>

namespace discmc::command {
namespace {

VolumePlacement by_spacing(const VolumeInfo& info) {
  std::array<double, 3> spacing = info.spacing_mm;
  for (double& length : spacing) length = std::fabs(length);
  return along_coordinates(spacing);
}

// Returns two comparable placements: by the spacing, if only one volume has a patient's space.
std::array<VolumePlacement, 2> comparable(const VolumeInfo& a, const VolumeInfo& b) {
  const VolumePlacement at_a = a.placement.value_or(along_coordinates(a.spacing_mm));
  const VolumePlacement at_b = b.placement.value_or(along_coordinates(b.spacing_mm));
  if ((at_a.space == Space::scanner) != (at_b.space == Space::scanner))
    return {by_spacing(a), by_spacing(b)};
  return {at_a, in_space(at_b, at_a.space)};
}

// Returns the largest distance between voxels of equal index, which is at a corner. Units:
// millimetres.
double farthest(const VolumeInfo& a, const VolumeInfo& b) {
  const auto [at_a, at_b] = comparable(a, b);
  double result = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::array<double, 3> apart{};
    for (std::size_t i = 0; i < 3; ++i) {
      apart[i] = at_a.origin_mm[i] - at_b.origin_mm[i];
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((corner >> axis & 1) != 0)
          apart[i] += (a.dims[axis] - 1) * (at_a.axes_mm[axis][i] - at_b.axes_mm[axis][i]);
    }
    result = std::max(result, std::hypot(apart[0], apart[1], apart[2]));
  }
  return result;
}

double cosine(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / std::hypot(a[0], a[1], a[2]) /
         std::hypot(b[0], b[1], b[2]);
}

}  // namespace

AxesMatch matching_axes(const VolumeInfo& volume, const VolumeInfo& other) {
  const auto [placement, other_placement] = comparable(volume, other);
  AxesMatch match{};
  std::array<bool, 3> is_matched{};
  for (std::size_t i = 0; i < 3; ++i) {
    double best_cosine = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double along = cosine(placement.axes_mm[i], other_placement.axes_mm[axis]);
      if (std::fabs(along) <= std::fabs(best_cosine)) continue;
      best_cosine = along;
      match[i] = {axis, along < 0};
    }
    is_matched[match[i].axis] = true;
  }
  const bool is_clear = is_matched[0] && is_matched[1] && is_matched[2];
  return is_clear ? match : AxesMatch{{{0, false}, {1, false}, {2, false}}};
}

double offset_mm(const VolumeInfo& a, const VolumeInfo& b) {
  const auto& s = a.spacing_mm;
  const double voxel = std::min({std::fabs(s[0]), std::fabs(s[1]), std::fabs(s[2])});
  const double apart = farthest(a, b);
  return apart > voxel / 10 ? apart : 0;
}

}  // namespace discmc::command
