// Rows of bits, compared with a comparison sample by sample.
#include <discmc/front/threshold_row.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;

namespace {

// Returns the bits of samples, followed by the old bits.
template <class IsOn>
std::vector<uint8_t> bits_of(uint32_t count, IsOn is_on) {
  std::vector<uint8_t> bits((count + 7) / 8);
  for (uint32_t x = 0; x < count; ++x)
    bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | (is_on(x) ? 1U : 0U) << x % 8);
  bits.resize(bits.size() + 4, 0x5A);
  return bits;
}

// Most samples are far below the threshold, so there are off blocks of any length.
template <class Sample>
std::vector<Sample> some_samples(size_t count, int32_t threshold, uint64_t seed) {
  test::Chance chance(seed);
  std::vector<Sample> samples;
  while (samples.size() < count) {
    const uint32_t stretch = 1 + chance.below(100);
    const bool is_off = chance.below(3) > 0;
    for (uint32_t i = 0; i < stretch; ++i)
      samples.push_back(is_off ? static_cast<Sample>(0)
                               : static_cast<Sample>(int64_t{threshold} + chance.below(5) - 2));
  }
  samples.resize(count);
  return samples;
}

template <class Sample>
void check_rows(int32_t threshold) {
  CAPTURE(threshold);
  for (uint32_t count = 0; count < 300; count += count < 70 ? 1 : 37)
    for (const uint32_t stride : {1U, 3U})
      for (uint32_t first = 0; first < 4; ++first) {
        const std::vector<Sample> samples =
            some_samples<Sample>(first + size_t{count} * stride, threshold, count);
        const Sample* const row = samples.data() + first;
        std::vector<uint8_t> bits((count + 7) / 8 + 4, 0x5A);
        threshold_row(row, count, threshold, bits.data(), stride);
        const bool is_right =
            bits == bits_of(count, [&](uint32_t x) { return row[x * stride] >= threshold; });
        INFO("count ", count, ", stride ", stride, ", first ", first);
        CHECK(is_right);
      }
}

template <class Sample>
void check_offsets(int32_t threshold) {
  for (uint32_t count = 0; count < 80; ++count) {
    const std::vector<Sample> samples = some_samples<Sample>(count, threshold, count);
    test::Chance chance(count);
    std::vector<int16_t> offsets;
    for (uint32_t x = 0; x < count; ++x)
      offsets.push_back(x % 5 == 0   ? INT16_MIN
                        : x % 5 == 1 ? INT16_MAX
                                     : static_cast<int16_t>(chance.below(5)));
    std::vector<uint8_t> bits((count + 7) / 8 + 4, 0x5A);
    threshold_row_less(samples.data(), offsets.data(), count, threshold, bits.data());
    CAPTURE(count);
    CHECK(bits == bits_of(count, [&](uint32_t x) {
            return int32_t{samples[x]} - offsets[x] >= threshold;
          }));
  }
}

}  // namespace

TEST_CASE(
    "threshold_row() sets the bits of samples at or above the threshold, for any width and "
    "address") {
  for (const int32_t threshold : {INT32_MIN, 0, 1, 100, 128, 200, 255, 256, INT32_MAX})
    check_rows<uint8_t>(threshold);
  for (const int32_t threshold : {0, 1, 300, 32768, 65535, 65536}) check_rows<uint16_t>(threshold);
  for (const int32_t threshold : {-32769, -32768, -5, 0, 300, 32767, 32768})
    check_rows<int16_t>(threshold);
}

TEST_CASE("threshold_row() subtracts the offset of its column from each sample before comparing") {
  check_offsets<uint8_t>(100);
  check_offsets<uint16_t>(40000);
  check_offsets<int16_t>(-300);
  check_offsets<int16_t>(INT16_MAX);
}
