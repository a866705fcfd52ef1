#include "signed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace discmc::meshing {
namespace {

constexpr float unreached = 1e15F;  // its square is also a float

float square(float value) {
  return value * value;
}

// Sets each result to the squared distance from the nearer of two.
void square_nearer(const float* before, float* after, float spacing, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    after[i] = square(spacing * std::min(before[i], after[i]));
}

void keep_smaller(float* squares, const float* other, float added, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) squares[i] = std::min(squares[i], other[i] + added);
}

}  // namespace

SignedDistance::SignedDistance(const Grid& grid, double limit_mm, SliceSource mask)
    : width_(grid.dims[0]),
      height_(grid.dims[1]),
      limit_squared_(square(static_cast<float>(limit_mm))),
      reach_(reach(grid, limit_mm)),
      mask_(std::move(mask)),
      masks_(grid.dims[2], grid.slice_samples(), reach_[2]),
      in_slices_(grid.dims[2], grid.slice_samples(), reach_[2]),
      between_(grid.dims[2], grid.slice_samples(), reach_[2]),
      plane_distances_(grid.slice_samples()) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    spacing_[axis] = static_cast<float>(grid.spacing_mm[axis]);
}

void SignedDistance::next(float* distances) {
  const std::uint32_t z = next_++;
  while (masks_.lacks(z)) add_slice();
  const std::size_t count = plane_distances_.size();
  std::fill_n(distances, count, limit_squared_);
  const auto away = [&](float plane) {
    return square((plane - static_cast<float>(z)) * spacing_[2]);
  };
  for (std::uint32_t k = masks_.first(z); k <= masks_.last(z); ++k) {
    keep_smaller(distances, in_slices_.at(k), away(static_cast<float>(k)), count);
    if (k < masks_.last(z))
      keep_smaller(distances, between_.at(k), away(static_cast<float>(k) + 0.5F), count);
  }
  const float* mask = masks_.at(z);
  for (std::size_t i = 0; i < count; ++i)
    distances[i] = std::sqrt(distances[i]) * (2 * mask[i] - 1);
}

void SignedDistance::add_slice() {
  float* mask = masks_.add();
  mask_(mask);
  float* squares = in_slices_.add();
  std::fill_n(squares, plane_distances_.size(), square(unreached));
  find_along_rows(mask, squares);
  find_along_columns(mask, squares);
  if (masks_.count() > 1) find_between(masks_.at(masks_.count() - 2), mask, between_.add());
}

// Distances from midpoints between neighbours in a row.
void SignedDistance::find_along_rows(const float* mask, float* squares) {
  std::vector<float> before(width_);
  for (std::uint32_t y = 0; y < height_; ++y) {
    const float* row = mask + std::size_t{y} * width_;
    float* row_distances = plane_distances_.data() + std::size_t{y} * width_;
    for (std::uint32_t x = 0; x < width_; ++x)
      before[x] = x == 0 ? unreached : row[x] != row[x - 1] ? 0.5F : before[x - 1] + 1;
    for (std::uint32_t x = width_; x-- > 0;)
      row_distances[x] = x + 1 == width_        ? unreached
                         : row[x] != row[x + 1] ? 0.5F
                                                : row_distances[x + 1] + 1;
    square_nearer(before.data(), row_distances, spacing_[0], width_);
  }
  spread_to_columns(squares);
}

// Distances from midpoints between neighbours in a column.
void SignedDistance::find_along_columns(const float* mask, float* squares) {
  std::vector<float> before(plane_distances_.size(), unreached);
  std::fill(plane_distances_.begin(), plane_distances_.end(), unreached);
  const std::size_t end = plane_distances_.size();
  for (std::size_t i = width_; i < end; ++i)
    before[i] = mask[i] != mask[i - width_] ? 0.5F : before[i - width_] + 1;
  for (std::size_t i = end - width_; i-- > 0;)
    plane_distances_[i] = mask[i] != mask[i + width_] ? 0.5F : plane_distances_[i + width_] + 1;
  square_nearer(before.data(), plane_distances_.data(), spacing_[1], end);
  spread_to_rows(squares);
}

// Distances from midpoints between neighbours of two slices.
void SignedDistance::find_between(const float* below, const float* above, float* squares) {
  std::vector<float> before(width_);
  for (std::size_t row = 0; row < plane_distances_.size(); row += width_) {
    float* row_distances = plane_distances_.data() + row;
    const auto is_crossing = [&](std::uint32_t x) { return below[row + x] != above[row + x]; };
    for (std::uint32_t x = 0; x < width_; ++x)
      before[x] = is_crossing(x) ? 0 : x == 0 ? unreached : before[x - 1] + 1;
    for (std::uint32_t x = width_; x-- > 0;)
      row_distances[x] = is_crossing(x)    ? 0
                         : x + 1 == width_ ? unreached
                                           : row_distances[x + 1] + 1;
    square_nearer(before.data(), row_distances, spacing_[0], width_);
  }
  std::fill_n(squares, plane_distances_.size(), square(unreached));
  spread_to_columns(squares);
}

// Spreads the distances along rows to the rows within reach.
void SignedDistance::spread_to_columns(float* squares) {
  for (std::uint32_t y = 0; y < height_; ++y) {
    const float* row_distances = plane_distances_.data() + std::size_t{y} * width_;
    if (*std::min_element(row_distances, row_distances + width_) >= limit_squared_) continue;
    const std::uint32_t first = y > reach_[1] ? y - reach_[1] : 0;
    const std::uint32_t last = std::min(y + reach_[1], height_ - 1);
    for (std::uint32_t to = first; to <= last; ++to) {
      const float rows = static_cast<float>(to) - static_cast<float>(y);
      keep_smaller(squares + std::size_t{to} * width_, row_distances, square(rows * spacing_[1]),
                   width_);
    }
  }
}

// Spreads the distances along columns to the voxels within reach in the row.
void SignedDistance::spread_to_rows(float* squares) {
  for (std::size_t row = 0; row < plane_distances_.size(); row += width_) {
    const float* row_distances = plane_distances_.data() + row;
    if (*std::min_element(row_distances, row_distances + width_) >= limit_squared_) continue;
    keep_smaller(squares + row, row_distances, 0, width_);
    for (std::uint32_t step = 1; step <= reach_[0] && step < width_; ++step) {
      const float added = square(static_cast<float>(step) * spacing_[0]);
      keep_smaller(squares + row + step, row_distances, added, width_ - step);
      keep_smaller(squares + row, row_distances + step, added, width_ - step);
    }
  }
}

}  // namespace discmc::meshing
