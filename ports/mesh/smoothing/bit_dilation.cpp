#include "bit_dilation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace discmc::meshing {
namespace {

// Adds to each voxel its neighbours along x.
void spread_row(const std::uint64_t* from, std::uint64_t* to, std::size_t words) {
  for (std::size_t i = 0; i < words; ++i) {
    const std::uint64_t before = i > 0 ? from[i - 1] >> 63 : 0;
    const std::uint64_t after = i + 1 < words ? from[i + 1] << 63 : 0;
    to[i] = from[i] | from[i] << 1 | before | from[i] >> 1 | after;
  }
}

// Includes voxels exactly at the radius, despite rounding.
constexpr double rounding_slack = 1e-9;

std::uint32_t voxels_in(double length_mm, double spacing_mm) {
  return static_cast<std::uint32_t>(length_mm / spacing_mm + rounding_slack);
}

}  // namespace

VoxelBall::VoxelBall(double radius_mm, const std::array<double, 3>& spacing_mm) : reach{} {
  for (std::size_t axis = 0; axis < 3; ++axis) reach[axis] = voxels_in(radius_mm, spacing_mm[axis]);
  for (std::uint32_t z = 0; z <= reach[2]; ++z) {
    width.emplace_back();
    for (std::uint32_t y = 0; y <= reach[1]; ++y) {
      const double dy = y * spacing_mm[1], dz = z * spacing_mm[2];
      const double square = radius_mm * radius_mm * (1 + rounding_slack);
      const double left = square - dy * dy - dz * dz;
      width.back().push_back(
          left < 0 ? -1 : static_cast<std::int32_t>(voxels_in(std::sqrt(left), spacing_mm[0])));
    }
  }
}

BitDilation::BitDilation(const BitGrid& grid, VoxelBall ball, Source source)
    : grid_(grid),
      ball_(std::move(ball)),
      source_(std::move(source)),
      window_(grid.dims[2], (ball_.reach[0] + 1) * grid.slice_words(), ball_.reach[2]) {}

void BitDilation::next(std::uint64_t* dilated) {
  const std::uint32_t z = next_++;
  while (window_.lacks(z)) add_slice();
  const std::size_t words = grid_.row_words();
  std::fill_n(dilated, grid_.slice_words(), 0);
  for (std::uint32_t k = window_.first(z); k <= window_.last(z); ++k) {
    const std::vector<std::int32_t>& widths = ball_.width[k > z ? k - z : z - k];
    for (std::uint32_t y = 0; y < grid_.dims[1]; ++y) {
      const std::uint32_t first = y > ball_.reach[1] ? y - ball_.reach[1] : 0;
      const std::uint32_t last = std::min(y + ball_.reach[1], grid_.dims[1] - 1);
      for (std::uint32_t from = first; from <= last; ++from) {
        const std::int32_t width = widths[from > y ? from - y : y - from];
        if (width < 0) continue;
        const std::uint64_t* const row = spread(k, width, from);
        std::transform(row, row + words, dilated + y * words, dilated + y * words,
                       [](std::uint64_t a, std::uint64_t b) { return a | b; });
      }
    }
  }
}

void BitDilation::add_slice() {
  std::uint64_t* const slice = window_.add();
  source_(slice);
  const std::size_t words = grid_.row_words();
  const std::size_t rows = grid_.dims[1];
  const unsigned used = grid_.dims[0] % 64;  // of the last word; 0: all
  const std::uint64_t in_row = used == 0 ? ~std::uint64_t{0} : ~(~std::uint64_t{0} << used);
  for (std::size_t row = 0; row < (ball_.reach[0] + 1) * rows; ++row) {
    std::uint64_t* const bits = slice + row * words;
    if (row >= rows) spread_row(bits - rows * words, bits, words);
    bits[words - 1] &= in_row;
  }
}

const std::uint64_t* BitDilation::spread(std::uint32_t z, std::int32_t width,
                                         std::uint32_t y) const {
  return window_.at(z) + (static_cast<std::size_t>(width) * grid_.dims[1] + y) * grid_.row_words();
}

}  // namespace discmc::meshing
