#include "selection.hpp"
#include "samples/iso_value.hpp"

#include <array>
#include <cmath>
#include <type_traits>

namespace discmc::meshing {
namespace {

// Returns the least sample that fulfils a monotonic condition, or the greatest sample if none does.
// Uses bisection, which is exact although a quotient would be rounded.
template <class Sample, class Condition>
Sample first_sample(Condition holds) {
  using NumericLimits = std::numeric_limits<Sample>;
  Sample low = NumericLimits::min();
  Sample high = NumericLimits::max();
  while (low < high) {
    // Half of the distance fits the unsigned type of this width.
    using Distance = std::make_unsigned_t<Sample>;
    const auto half = static_cast<Distance>(
        static_cast<Distance>(static_cast<Distance>(high) - static_cast<Distance>(low)) / 2);
    const auto middle = static_cast<Sample>(static_cast<Distance>(low) + half);
    if (holds(middle))
      high = middle;
    else
      low = static_cast<Sample>(middle + 1);
  }
  return low;
}

template <class Sample>
SampleRange<Sample> none() {
  return {Sample{1}, Sample{0}};
}

// Handles values that are the stored whole numbers, with all digits of 64 bits.
template <class Sample>
SampleRange<Sample> selected_as_stored(const Selection& selection) {
  using NumericLimits = std::numeric_limits<Sample>;
  const double low = std::ceil(selection.low);
  const double high = std::floor(selection.high);
  const double beyond = std::ldexp(1, NumericLimits::digits);
  const double lowest = std::is_signed_v<Sample> ? -beyond : 0;
  if (!(low < beyond) || !(high >= lowest)) return none<Sample>();
  return {low > lowest ? static_cast<Sample>(low) : NumericLimits::min(),
          high < beyond ? static_cast<Sample>(high) : NumericLimits::max()};
}

// Handles whole numbers, and compares value = slope * stored + intercept like stored_threshold().
template <class Sample>
SampleRange<Sample> selected_whole(const SampleGrid& info, const Selection& selection) {
  using NumericLimits = std::numeric_limits<Sample>;
  const auto value = [&](Sample stored) {
    return info.slope * static_cast<double>(stored) + info.intercept;
  };
  const double lowest = lowered_by_rounding(info, selection.low);
  const double highest = -lowered_by_rounding(info, -selection.high);
  if (!(value(NumericLimits::max()) >= lowest) || !(value(NumericLimits::min()) <= highest))
    return none<Sample>();
  SampleRange<Sample> range{};
  range.low = first_sample<Sample>([&](Sample stored) { return value(stored) >= lowest; });
  range.high = NumericLimits::max();
  if (value(range.high) > highest)
    range.high = static_cast<Sample>(
        first_sample<Sample>([&](Sample stored) { return value(stored) > highest; }) - 1);
  return range;
}

template <class Sample>
SampleRange<Sample> selected_floating(const SampleGrid& info, const Selection& selection) {
  const auto stored = [&](double value) {
    return static_cast<Sample>((value - info.intercept) / info.slope);
  };
  return {stored(lowered_by_rounding(info, selection.low)),
          stored(-lowered_by_rounding(info, -selection.high))};
}

// Packs eight flags of a byte each to eight bits, the first one lowest. The highest byte of the
// product has all of them.
std::uint8_t packed(const std::uint8_t* flags) {
  std::uint64_t word = 0;
  for (unsigned i = 0; i < 8; ++i) word |= std::uint64_t{flags[i]} << (8 * i);
  return static_cast<std::uint8_t>(word * 0x0102040810204080 >> 56);
}

// Requests memory ahead of a group of samples. A processor's own prefetching is late, because it
// restarts after each slice.
template <class Sample>
void prefetch_after([[maybe_unused]] const Sample* samples, [[maybe_unused]] std::size_t count) {
#if defined(__GNUC__)
  constexpr std::size_t line = 64, ahead = 1024;  // Units: bytes
  // Pointers beyond the volume would be invalid; requests there are ignored.
  const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(samples) + ahead;
  for (std::size_t i = 0; i < count * sizeof(Sample); i += line)
    __builtin_prefetch(reinterpret_cast<const void*>(begin + i));
#endif
}

// is_on: without a branch, and a copy, so that compilers vectorise it.
template <class Sample, class Condition>
void select_row(const Sample* samples, std::uint32_t width, Condition is_on, std::uint8_t* bits) {
  constexpr std::uint32_t group = 64;
  std::array<std::uint8_t, group> flags{};
  std::uint32_t left = width;
  for (; left >= group; left -= group, samples += group, bits += group / 8) {
    prefetch_after(samples, group);
    for (std::uint32_t i = 0; i < group; ++i)
      flags[i] = static_cast<std::uint8_t>(is_on(samples[i]));
    for (std::uint32_t i = 0; i < group; i += 8) bits[i / 8] = packed(flags.data() + i);
  }
  flags = {};
  for (std::uint32_t i = 0; i < left; ++i) flags[i] = static_cast<std::uint8_t>(is_on(samples[i]));
  for (std::uint32_t i = 0; i < left; i += 8) bits[i / 8] = packed(flags.data() + i);
}

template <class Sample>
std::uint64_t count_not_numbers(const Sample* samples, std::size_t count) {
  std::uint64_t not_numbers = 0;
  if constexpr (std::is_floating_point_v<Sample>)
    for (std::size_t i = 0; i < count; ++i) not_numbers += std::isnan(samples[i]) ? 1U : 0U;
  return not_numbers;
}

// The functions that SliceSelector calls.
template <class Sample, class Condition>
auto selector_of(const SampleGrid& info, Condition is_on) {
  return [is_on, width = info.dims[0], height = info.dims[1]](const void* slice, std::uint8_t* bits,
                                                              std::size_t stride) {
    const auto* row = static_cast<const Sample*>(slice);
    for (std::uint32_t y = 0; y < height; ++y, row += width, bits += stride)
      select_row(row, width, is_on, bits);
    return count_not_numbers(static_cast<const Sample*>(slice), std::size_t{width} * height);
  };
}

}  // namespace

template <class Sample>
SampleRange<Sample> selected_samples(const SampleGrid& info, const Selection& selection) {
  if constexpr (std::is_floating_point_v<Sample>)
    return selected_floating<Sample>(info, selection);
  else
    return info.slope == 1 && info.intercept == 0 ? selected_as_stored<Sample>(selection)
                                                  : selected_whole<Sample>(info, selection);
}

template SampleRange<std::uint8_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<std::int8_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<std::uint16_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<std::int16_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<std::uint32_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<std::int32_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<std::uint64_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<std::int64_t> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<float> selected_samples(const SampleGrid&, const Selection&);
template SampleRange<double> selected_samples(const SampleGrid&, const Selection&);

SliceSelector::SliceSelector(const SampleGrid& info, const Selection& selection) {
  if (selection.bits != 0) {
    with_whole_type(info.type, [&](auto type) {
      using Sample = decltype(type);
      select_ = selector_of<Sample>(info, [bits = selection.bits](Sample sample) {
        return static_cast<unsigned>((static_cast<std::uint64_t>(sample) & bits) != 0);
      });
    });
    return;
  }
  with_sample_type(info.type, [&](auto type) {
    using Sample = decltype(type);
    select_ = selector_of<Sample>(
        info, [range = selected_samples<Sample>(info, selection)](Sample sample) {
          return static_cast<unsigned>(range.low <= sample) &
                 static_cast<unsigned>(sample <= range.high);
        });
  });
}

}  // namespace discmc::meshing
