#include "measured_volume.hpp"

namespace discmc::command {

void MeasuredVolume::read_slice(void* samples) {
  VolumeFilter::read_slice(samples);
  bounds_.include(info().type, samples, std::size_t{info().dims[0]} * info().dims[1]);
}

std::optional<ValueRange> MeasuredVolume::range() const {
  if (bounds_.is_empty()) return std::nullopt;
  const auto value = [this](double sample) { return info().slope * sample + info().intercept; };
  return ValueRange{value(bounds_.least), value(bounds_.greatest)};
}

ValueRange MeasuredVolume::range_with_infinities() const {
  constexpr double infinity = SampleBounds::infinity;
  ValueRange all = range().value_or(ValueRange{infinity, -infinity});
  if (bounds_.has_minus_infinity) all.least = -infinity;
  if (bounds_.has_infinity) all.greatest = infinity;
  if (bounds_.is_empty() && bounds_.has_infinity && !bounds_.has_minus_infinity)
    all.least = infinity;
  return all;
}

}  // namespace discmc::command
