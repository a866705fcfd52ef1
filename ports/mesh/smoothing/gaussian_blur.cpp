#include "gaussian_blur.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace discmc::meshing {
namespace {

constexpr double deviations = 3;

// Returns weights with the sum 1. radius: number of steps to the last weight.
std::vector<float> gaussian(double deviation, std::uint32_t radius) {
  std::vector<double> weights;
  double sum = 0;
  for (std::uint32_t i = 0; i <= radius; ++i) {
    const double deviations_away = i > 0 ? i / deviation : 0;
    weights.push_back(std::exp(-0.5 * deviations_away * deviations_away));
    sum += (i == 0 ? 1 : 2) * weights.back();
  }
  std::vector<float> kernel;
  kernel.reserve(weights.size());
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

void add(float* to, const float* from, float weight, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) to[i] += weight * from[i];
}

}  // namespace

GaussianBlur::GaussianBlur(const Grid& grid, double deviation_mm, SliceSource source)
    : width_(grid.dims[0]),
      height_(grid.dims[1]),
      depth_(grid.dims[2]),
      source_(std::move(source)),
      window_(grid.dims[2], grid.slice_samples(), reach(grid, deviations * deviation_mm)[2]),
      copy_(grid.slice_samples()) {
  const auto radius = reach(grid, deviations * deviation_mm);
  for (std::size_t axis = 0; axis < 3; ++axis)
    kernel_[axis] = gaussian(deviation_mm / grid.spacing_mm[axis], radius[axis]);
}

void GaussianBlur::next(float* blurred) {
  const std::uint32_t z = next_++;
  while (window_.lacks(z)) source_(window_.add());
  const std::size_t count = copy_.size();
  std::fill_n(blurred, count, 0.0F);
  for (std::uint32_t i = 0; i < kernel_[2].size(); ++i) {
    add(blurred, window_.at(z > i ? z - i : 0), kernel_[2][i], count);
    if (i > 0) add(blurred, window_.at(std::min(z + i, depth_ - 1)), kernel_[2][i], count);
  }
  blur_columns(blurred);
  blur_rows(blurred);
}

void GaussianBlur::blur_columns(float* slice) {
  std::swap_ranges(slice, slice + copy_.size(), copy_.begin());
  const auto row = [&](std::uint32_t y) { return copy_.data() + std::size_t{y} * width_; };
  for (std::uint32_t y = 0; y < height_; ++y) {
    float* to = slice + std::size_t{y} * width_;
    std::fill_n(to, width_, 0.0F);
    for (std::uint32_t i = 0; i < kernel_[1].size(); ++i) {
      add(to, row(y > i ? y - i : 0), kernel_[1][i], width_);
      if (i > 0) add(to, row(std::min(y + i, height_ - 1)), kernel_[1][i], width_);
    }
  }
}

void GaussianBlur::blur_rows(float* slice) {
  const std::size_t radius = kernel_[0].size() - 1;
  std::vector<float> padded(width_ + 2 * radius);
  for (std::uint32_t y = 0; y < height_; ++y) {
    float* row = slice + std::size_t{y} * width_;
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, width_, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill_n(padded.end() - static_cast<std::ptrdiff_t>(radius), radius, row[width_ - 1]);
    std::fill_n(row, width_, 0.0F);
    for (std::size_t i = 0; i <= 2 * radius; ++i)
      add(row, padded.data() + i, kernel_[0][i < radius ? radius - i : i - radius], width_);
  }
}

}  // namespace discmc::meshing
