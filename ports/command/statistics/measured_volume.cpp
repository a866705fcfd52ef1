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
  ValueRange values = range().value_or(ValueRange{infinity, -infinity});
  if (bounds_.has_minus_infinity) values.least = -infinity;
  if (bounds_.has_infinity) values.greatest = infinity;
  if (bounds_.is_empty() && bounds_.has_infinity && !bounds_.has_minus_infinity)
    values.least = infinity;
  return values;
}

}  // namespace discmc::command
