#include "array_reader.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace discmc::meshing {
namespace {

// Copies samples that are this many bytes apart.
std::uint8_t* copy_row(const std::uint8_t* from, std::ptrdiff_t stride, std::uint32_t count,
                       SampleType type, std::uint8_t* to) {
  if (stride == static_cast<std::ptrdiff_t>(sample_bytes(type))) {
    std::memcpy(to, from, count * sample_bytes(type));
    return to + count * sample_bytes(type);
  }
  return with_sample_type(type, [&](auto sample) {
    for (std::uint32_t i = 0; i < count; ++i, from += stride, to += sizeof sample)
      std::memcpy(to, from, sizeof sample);
    return to;
  });
}

}  // namespace

AxisOrder axis_order(const Samples& samples) {
  const Extents& extents = samples.extents();
  Strides distances{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (extents[axis] > 1)
      distances[axis] = std::abs(samples.strides()[axis]);
    else if (axis > 0)  // the stride of a single sample is irrelevant
      distances[axis] = distances[axis - 1];
  AxisOrder order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distances[a] < distances[b]; });
  // An axis longer than max_across becomes the z axis of the sweep.
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (extents[order[axis]] > max_across) std::swap(order[axis], order[2]);
  return order;
}

ArrayReader::ArrayReader(const Samples& samples, const AxisOrder& order,
                         const std::array<double, 3>& spacing)
    : samples_(static_cast<const std::uint8_t*>(samples.data())) {
  info_.type = samples.type();
  info_.spacing_mm = spacing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    info_.dims[axis] = static_cast<std::uint32_t>(samples.extents()[order[axis]]);
    stride_bytes_[axis] = info_.dims[axis] == 1  // the stride of a single sample is irrelevant
                              ? 0
                              : samples.strides()[order[axis]] *
                                    static_cast<std::ptrdiff_t>(sample_bytes(samples.type()));
  }
}

void ArrayReader::read_slice(void* slice) {
  auto* to = static_cast<std::uint8_t*>(slice);
  const std::uint8_t* const from = samples_ + stride_bytes_[2] * next_++;
  for (std::uint32_t y = 0; y < info_.dims[1]; ++y)
    to = copy_row(from + stride_bytes_[1] * static_cast<std::ptrdiff_t>(y), stride_bytes_[0],
                  info_.dims[0], info_.type, to);
}

}  // namespace discmc::meshing
