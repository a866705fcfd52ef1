// Normals, and those of a second pass, are the same through C.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <discmc/sample_window.hpp>
#include <vector>

#include "oracle/c_events.hpp"
#include "oracle/stream.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::Chance;

namespace {

bool are_equal(const discmc_long_vector& c, const LongVector& cpp) {
  return c.x == cpp.x && c.y == cpp.y && c.z == cpp.z;
}
bool are_equal(const discmc_unit_normal& c, const UnitNormal& cpp) {
  return c.x == cpp.x && c.y == cpp.y && c.z == cpp.z;
}

// A number of any length.
int64_t any_number(Chance& chance) {
  return static_cast<int64_t>(chance.next()) >> chance.below(64);
}

}  // namespace

TEST_CASE("normals are the same through C") {
  Chance chance(1);
  for (int i = 0; i < 10000; ++i) {
    const LongVector vector{any_number(chance), any_number(chance), any_number(chance)};
    const discmc_long_vector in_c = {vector.x, vector.y, vector.z};
    CHECK(are_equal(discmc_unit_normal_along(in_c), unit_normal(vector)));
    const OctahedralNormal normal = octahedral_normal(vector);
    const discmc_octahedral_normal told = discmc_octahedral_normal_along(in_c);
    CHECK(OctahedralNormal{told.u, told.v} == normal);
    CHECK(are_equal(discmc_unit_normal_of(told), unit_normal(normal)));

    const int32_t spacing[3] = {static_cast<int32_t>(chance.next()),
                                static_cast<int32_t>(chance.next()),
                                static_cast<int32_t>(chance.below(3))};
    const AxisWeights weights = axis_weights(spacing);
    const discmc_axis_weights weights_in_c = discmc_axis_weights_of(spacing);
    CHECK(weights_in_c.x == weights.x);
    CHECK(weights_in_c.y == weights.y);
    CHECK(weights_in_c.z == weights.z);
    CHECK(are_equal(discmc_weighted(in_c, weights_in_c), weighted(vector, weights)));
  }
  for (uint8_t incidence = 0; incidence < DISCMC_INCIDENCE_CODES; ++incidence)
    if (incidence != DISCMC_NO_INCIDENCE)
      CHECK(are_equal(discmc_area_vector(incidence, -1234567), area_vector(incidence, -1234567)));
}

namespace {

// ---- the second pass ----

constexpr uint32_t width = 5, height = 4, depth = 7;

discmc_status start(discmc_sample_window& window, const discmc_limits& limits, discmc_memory memory,
                    uint8_t) {
  return discmc_sample_window_start_u8(&window, &limits, memory);
}
discmc_status start(discmc_sample_window& window, const discmc_limits& limits, discmc_memory memory,
                    uint16_t) {
  return discmc_sample_window_start_u16(&window, &limits, memory);
}
discmc_status start(discmc_sample_window& window, const discmc_limits& limits, discmc_memory memory,
                    int16_t) {
  return discmc_sample_window_start_i16(&window, &limits, memory);
}
discmc_status push(discmc_sample_window& window, const uint8_t* samples, uint32_t count,
                   uint32_t stride) {
  return discmc_sample_window_push_u8(&window, samples, count, stride);
}
discmc_status push(discmc_sample_window& window, const uint16_t* samples, uint32_t count,
                   uint32_t stride) {
  return discmc_sample_window_push_u16(&window, samples, count, stride);
}
discmc_status push(discmc_sample_window& window, const int16_t* samples, uint32_t count,
                   uint32_t stride) {
  return discmc_sample_window_push_i16(&window, samples, count, stride);
}

// Compares what both windows tell of all vertices, and returns of how many they could.
template <class Sample>
uint32_t compare(const discmc_sample_window& in_c, const SampleWindow<Sample>& in_cpp) {
  uint32_t covered = 0;
  for (int32_t z = -1; z < 2 * static_cast<int32_t>(depth); ++z)
    for (int32_t y = -1; y < 2 * static_cast<int32_t>(height); ++y)
      for (int32_t x = -1; x < 2 * static_cast<int32_t>(width); ++x) {
        if ((x + y + z) % 2 == 0) continue;
        const Vertex vertex{x, y, z};
        const bool is_covered = discmc_sample_window_covers(&in_c, {x, y, z}) != 0;
        REQUIRE(is_covered == in_cpp.covers(vertex));
        if (!is_covered) continue;
        ++covered;
        REQUIRE(
            are_equal(discmc_sample_window_downhill(&in_c, {x, y, z}), in_cpp.downhill(vertex)));
      }
  return covered;
}

}  // namespace

TEST_CASE_TEMPLATE("a window tells through C what it tells in C++", Sample, uint8_t, uint16_t,
                   int16_t) {
  constexpr Limits limits{width, height};
  const discmc_limits in_c = to_c(limits);
  const uint64_t bytes = discmc_sample_window_bytes_for(&in_c, sizeof(Sample));
  REQUIRE(bytes == SampleWindow<Sample>::bytes_for(limits));
  CHECK(DISCMC_SAMPLE_WINDOW_BYTES_FOR(width, height, sizeof(Sample)) == bytes);
  Block block_c(bytes), block_cpp(bytes);
  discmc_sample_window window = {};
  SampleWindow<Sample> same;
  REQUIRE(start(window, in_c, {block_c.memory().data, bytes}, Sample{}) == DISCMC_OK);
  require_ok(same.start(limits, block_cpp.memory()));

  Chance chance(3);
  std::vector<Sample> samples(size_t{2} * width * height * depth);
  for (Sample& sample : samples) sample = static_cast<Sample>(chance.next());
  uint32_t covered = 0;
  constexpr uint32_t slice = width * height;
  for (uint32_t z = 0; z < depth; ++z) {
    REQUIRE(push(window, samples.data() + size_t{2} * z * slice, slice, 2) == DISCMC_OK);
    require_ok(same.push(samples.data() + size_t{2} * z * slice, slice, 2));
    covered += compare(window, same);
  }
  discmc_sample_window_end(&window);
  same.end();
  covered += compare(window, same);
  CHECK(covered > 1000);
  CHECK(push(window, samples.data(), 1, 1) == DISCMC_FINISHED);
  CHECK(block_c.is_intact());
}

TEST_CASE("what a window refuses it refuses through C, and one of zeros is not started") {
  const uint8_t samples[4] = {};
  const uint16_t words[4] = {};
  const discmc_limits good = {2, 2, DISCMC_CLOSED, {}}, bad = {};
  uint8_t memory[DISCMC_SAMPLE_WINDOW_BYTES_FOR(2, 2, 1)];
  const discmc_memory all = {memory, sizeof memory}, little = {memory, sizeof memory - 1};
  discmc_sample_window window = {};
  CHECK(discmc_sample_window_push_u8(&window, samples, 4, 1) == DISCMC_NOT_STARTED);
  CHECK(discmc_sample_window_covers(&window, {1, 0, 0}) == 0);
  CHECK(discmc_sample_window_downhill(&window, {1, 0, 0}).x == 0);
  discmc_sample_window_end(&window);
  CHECK(discmc_sample_window_start_u8(&window, &bad, all) == DISCMC_BAD_LIMITS);
  CHECK(discmc_sample_window_start_u8(&window, &good, little) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_sample_window_push_u8(&window, samples, 4, 1) == DISCMC_NOT_STARTED);
  REQUIRE(discmc_sample_window_start_u8(&window, &good, all) == DISCMC_OK);
  CHECK(discmc_sample_window_push_u16(&window, words, 4, 1) == DISCMC_NOT_STARTED);
  CHECK(discmc_sample_window_start_u16(&window, &good, all) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_sample_window_push_u8(&window, samples, 4, 1) == DISCMC_OK);
}
