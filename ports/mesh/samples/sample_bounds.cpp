#include "sample_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace discmc::meshing {
namespace {

template <class Sample>
bool is_finite(Sample sample) {
  if constexpr (std::is_floating_point_v<Sample>)
    return std::fabs(sample) <= std::numeric_limits<Sample>::max();
  else
    return true;
}

template <class Sample>
struct Bounds {
  Sample minimum = std::numeric_limits<Sample>::max();
  Sample maximum = std::numeric_limits<Sample>::lowest();
};

// Has no branch, so that compilers vectorise it.
template <class Sample, class Condition>
Bounds<Sample> bounds_of(const Sample* samples, std::size_t count, Condition is_included) {
  Bounds<Sample> bounds;
  for (std::size_t i = 0; i < count; ++i) {
    const Sample sample = samples[i];
    bounds.minimum = is_included(sample) && sample < bounds.minimum ? sample : bounds.minimum;
    bounds.maximum = is_included(sample) && sample > bounds.maximum ? sample : bounds.maximum;
  }
  return bounds;
}

}  // namespace

// Infinite samples are rare, so a second search runs only if there are any. No comparison holds for
// NaN.
void SampleBounds::include(SampleType type, const void* samples, std::size_t count) {
  with_sample_type(type, [&](auto type_of) {
    using Sample = decltype(type_of);
    const auto* const typed = static_cast<const Sample*>(samples);
    auto bounds = bounds_of(typed, count, [](Sample) { return true; });
    const bool has_low = !is_finite(bounds.minimum), has_high = !is_finite(bounds.maximum);
    has_minus_infinity = has_minus_infinity || has_low;
    has_infinity = has_infinity || has_high;
    if (has_low || has_high)
      bounds = bounds_of(typed, count, [](Sample sample) { return is_finite(sample); });
    if (bounds.minimum > bounds.maximum) return;
    const SampleBounds before = *this;
    least = std::min(least, static_cast<double>(bounds.minimum));
    greatest = std::max(greatest, static_cast<double>(bounds.maximum));
    const auto is_between = [this](double sample) { return least < sample && sample < greatest; };
    has_between = has_between || is_between(before.least) || is_between(before.greatest) ||
                  std::any_of(typed, typed + count, [&](Sample sample) {
                    return is_between(static_cast<double>(sample));
                  });
  });
}

SampleBounds sample_bounds(SliceReader& volume) {
  const SampleGrid& info = volume.info();
  std::vector<std::uint8_t> slice(info.slice_bytes());
  SampleBounds bounds;
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    bounds.include(info.type, slice.data(), std::size_t{info.dims[0]} * info.dims[1]);
  }
  return bounds;
}

}  // namespace discmc::meshing
