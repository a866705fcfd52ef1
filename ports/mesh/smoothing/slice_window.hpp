// Slices of numbers that the stages of a filter pass on.
#ifndef DISCMC_MESH_SMOOTHING_SLICE_WINDOW_HPP
#define DISCMC_MESH_SMOOTHING_SLICE_WINDOW_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace discmc::meshing {

/// The extents of a volume in voxels, and of a voxel in millimetres.
struct Grid {
  std::array<std::uint32_t, 3> dims;
  std::array<double, 3> spacing_mm;  ///< positive

  std::size_t slice_samples() const { return std::size_t{dims[0]} * dims[1]; }
};

/// Returns the number of voxels within a length along each axis, at least one.
inline std::array<std::uint32_t, 3> reach(const Grid& grid, double length_mm) {
  std::array<std::uint32_t, 3> voxels{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double max_step =
        std::min(std::ceil(length_mm / grid.spacing_mm[axis]), 1.0 * grid.dims[axis]);
    voxels[axis] = std::max(1U, static_cast<std::uint32_t>(max_step));
  }
  return voxels;
}

/// Writes the next slice of a volume, rows of x from y = 0.
using SliceSource = std::function<void(float*)>;

/// The slices within the radius of a filter across slices.
template <class Element>
class SliceWindow {
 public:
  /// elements: of a slice. radius: slices on either side.
  SliceWindow(std::uint32_t depth, std::size_t elements, std::uint32_t radius)
      : depth_(depth),
        radius_(std::min(radius, depth_)),
        slice_(elements),
        ring_(slice_ * (2 * std::size_t{radius_} + 1)) {}

  std::uint32_t first(std::uint32_t z) const { return z > radius_ ? z - radius_ : 0; }
  std::uint32_t last(std::uint32_t z) const { return std::min(z + radius_, depth_ - 1); }

  /// Whether slices around z are still missing.
  bool lacks(std::uint32_t z) const { return count_ <= last(z); }
  std::uint32_t count() const { return count_; }
  /// Adds the next slice, and returns its memory for the caller to fill.
  Element* add() { return slot(count_++); }
  /// Limit: a slice that was added and is at most 2 x radius before the last.
  const Element* at(std::uint32_t z) const { return ring_.data() + offset(z); }

 private:
  std::size_t offset(std::uint32_t z) const { return slice_ * (z % (2 * radius_ + 1)); }
  Element* slot(std::uint32_t z) { return ring_.data() + offset(z); }

  std::uint32_t depth_, radius_;
  std::size_t slice_;
  std::vector<Element> ring_;
  std::uint32_t count_ = 0;
};

}  // namespace discmc::meshing

#endif
