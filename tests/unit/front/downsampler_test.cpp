// The means of blocks equal those added voxel by voxel. command/volume_part compares them with
// `discmc extract --shrink`.
#include <discmc/front/downsampler.hpp>

#include "oracle/scan.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using reference::Block;
using reference::Size;

namespace {

template <class Sample>
std::vector<Sample> some_samples(const Size& size, uint64_t seed) {
  test::Chance chance(seed);
  std::vector<Sample> samples;
  for (size_t i = 0; i < size_t{size.width} * size.height * size.depth; ++i)
    samples.push_back(static_cast<Sample>(chance.next()));
  return samples;
}

// Rounds to the nearest value, halves upwards.
template <class Sample>
Sample mean_at(const std::vector<Sample>& samples, const Size& size, uint32_t extent, uint32_t x,
               uint32_t y, uint32_t z) {
  int64_t sum = 0, count = 0;
  for (uint32_t k = z * extent; k < (z + 1) * extent && k < size.depth; ++k)
    for (uint32_t j = y * extent; j < (y + 1) * extent && j < size.height; ++j)
      for (uint32_t i = x * extent; i < (x + 1) * extent && i < size.width; ++i, ++count)
        sum += samples[(size_t{k} * size.height + j) * size.width + i];
  const int64_t twice = 2 * sum + count;
  const int64_t floor = twice / (2 * count) - (twice % (2 * count) < 0 ? 1 : 0);
  return static_cast<Sample>(floor);
}

template <class Sample>
std::vector<Sample> means_of(Downsampler<Sample>& means, const std::vector<Sample>& samples,
                             const Size& size, uint32_t extent) {
  const Limits limits{size.width, size.height, Border::open};
  Block block(Downsampler<Sample>::bytes_for(limits, extent));
  REQUIRE(means.start(limits, extent, block.memory()) == Status::ok);
  const uint32_t width = means.limits().width;
  CHECK(width == (size.width + extent - 1) / extent);
  CHECK(means.limits().height == (size.height + extent - 1) / extent);
  CHECK(means.limits().border == Border::open);
  std::vector<Sample> result;
  for (size_t row = 0; row < size_t{size.height} * size.depth; ++row)
    if (const Sample* due = means.push(&samples[row * size.width]))
      result.insert(result.end(), due, due + width);
  while (const Sample* due = means.drain()) result.insert(result.end(), due, due + width);
  CHECK(means.drain() == nullptr);
  CHECK(block.is_intact());
  return result;
}

template <class Sample>
void check(const Size& size, uint32_t extent) {
  const std::vector<Sample> samples = some_samples<Sample>(size, size.width + extent);
  std::vector<Sample> expected;
  for (uint32_t z = 0; z * extent < size.depth; ++z)
    for (uint32_t y = 0; y * extent < size.height; ++y)
      for (uint32_t x = 0; x * extent < size.width; ++x)
        expected.push_back(mean_at(samples, size, extent, x, y, z));
  INFO("width ", size.width, ", height ", size.height, ", depth ", size.depth, ", extent ", extent);
  Downsampler<Sample> means;
  CHECK(means_of(means, samples, size, extent) == expected);
}

}  // namespace

TEST_CASE("each block becomes the mean of its voxels, also blocks cut by the border") {
  for (const uint32_t extent : {1U, 2U, 3U, 5U, 16U})
    for (const uint32_t width : {1U, 2U, 7U, 16U, 17U})
      for (const uint32_t height : {1U, 3U, 6U})
        for (const uint32_t depth : {1U, 2U, 5U, 6U}) {
          check<uint8_t>({width, height, depth}, extent);
          check<uint16_t>({width, height, depth}, extent);
          check<int16_t>({width, height, depth}, extent);
        }
}

TEST_CASE("the sum of the largest block of maximal samples does not overflow") {
  for (const int16_t sample : {int16_t{INT16_MIN}, int16_t{INT16_MAX}}) {
    const std::vector<int16_t> samples(16 * 16 * 16, sample);
    Downsampler<int16_t> means;
    CHECK(means_of(means, samples, {16, 16, 16}, 16) == std::vector<int16_t>{sample});
  }
}

TEST_CASE("a downsampler restarted in the middle of a volume begins a new volume") {
  const Size size{5, 4, 3};
  const std::vector<uint8_t> samples = some_samples<uint8_t>(size, 1);
  Downsampler<uint8_t> fresh;
  const std::vector<uint8_t> expected = means_of(fresh, samples, size, 2);
  for (uint32_t pushed = 0; pushed < 12; ++pushed) {
    const Limits limits{5, 4};
    Block block(Downsampler<uint8_t>::bytes_for(limits, 2));
    Downsampler<uint8_t> means;
    REQUIRE(means.start(limits, 2, block.memory()) == Status::ok);
    for (uint32_t row = 0; row < pushed; ++row) (void)means.push(&samples[row * 5]);
    CHECK(means_of(means, samples, size, 2) == expected);
  }
}

TEST_CASE("a downsampler refuses invalid limits, empty blocks and too little memory") {
  Downsampler<uint16_t> means;
  const Limits limits{33, 4};
  Block block(Downsampler<uint16_t>::bytes_for(limits, 2) - 1);
  CHECK(means.start(limits, 2, block.memory()) == Status::too_little_memory);
  CHECK(means.start(limits, 3, block.memory()) == Status::ok);
  CHECK(means.start(limits, 0, block.memory()) == Status::bad_limits);
  CHECK(means.start(limits, 17, block.memory()) == Status::bad_limits);
  CHECK(means.start({0, 4}, 2, block.memory()) == Status::bad_limits);
}
