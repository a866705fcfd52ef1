// A Gaussian blur across slices.
#ifndef DISCMC_MESH_SMOOTHING_GAUSSIAN_BLUR_HPP
#define DISCMC_MESH_SMOOTHING_GAUSSIAN_BLUR_HPP

#include <array>
#include <cstdint>
#include <vector>

#include "slice_window.hpp"

namespace discmc::meshing {

/// Blurs along each axis by a Gaussian that is cut off at three deviations. Repeats the last voxels
/// beyond the ends of the volume. Memory: the slices within three deviations.
class GaussianBlur {
 public:
  /// deviation_mm: of the Gaussian; Limit: positive
  GaussianBlur(const Grid& grid, double deviation_mm, SliceSource source);

  /// Writes the next blurred slice.
  void next(float* blurred);
  /// Returns the last blurred slice before the blur.
  const float* sharp() const { return sharp(next_ - 1); }
  /// Returns an earlier slice before the blur. Limit: at most three deviations before the last one.
  const float* sharp(std::uint32_t z) const { return window_.at(z); }

 private:
  // Weights of the voxel itself, and of voxels at each distance in steps.
  using Kernel = std::vector<float>;

  void blur_rows(float* slice);
  void blur_columns(float* slice);

  std::uint32_t width_, height_, depth_;
  SliceSource source_;
  std::array<Kernel, 3> kernel_;
  SliceWindow<float> window_;
  std::vector<float> copy_;
  std::uint32_t next_ = 0;
};

}  // namespace discmc::meshing

#endif
