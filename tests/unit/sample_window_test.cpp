// The gradient at every vertex of small volumes, and the window of slices.
#include <discmc/sample_window.hpp>

#include "oracle/gradient.hpp"
#include "oracle/scan.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::Chance;

namespace {

template <class Sample>
SampleVolume<Sample> noise(Size size, Chance& chance) {
  SampleVolume<Sample> volume{size, {}};
  for (size_t i = 0; i < size_t{size.width} * size.height * size.depth; ++i)
    volume.samples.push_back(static_cast<Sample>(chance.next()));
  return volume;
}

// The possible vertices of a closed scan, in the order of z.
std::vector<Vertex> vertices_of(Size size) {
  const auto last = [](uint32_t extent) { return 2 * static_cast<int32_t>(extent) - 1; };
  std::vector<Vertex> vertices;
  for (int32_t z = -1; z <= last(size.depth); ++z)
    for (int32_t y = -1; y <= last(size.height); ++y)
      for (int32_t x = -1; x <= last(size.width); ++x)
        if ((x + y + z) % 2 != 0) vertices.push_back({x, y, z});
  return vertices;
}

struct StartedWindow : SampleWindow<uint8_t> {
  explicit StartedWindow(const Limits& limits) : block(bytes_for(limits)) {
    REQUIRE(start(limits, block.memory()) == Status::ok);
  }
  Block block;
};

template <class Sample>
void check_window(Size size, uint32_t chunk, Chance& chance) {
  const SampleVolume<Sample> volume = noise<Sample>(size, chance);
  const Limits limits{size.width, size.height};
  Block block(SampleWindow<Sample>::bytes_for(limits), Block::Kind::exact);
  SampleWindow<Sample> window;
  REQUIRE(window.start(limits, block.memory()) == Status::ok);
  const std::vector<Vertex> vertices = vertices_of(size);
  auto next = vertices.begin();
  const auto check_covered = [&] {
    for (; next != vertices.end() && window.covers(*next); ++next) {
      const LongVector down = window.negative_gradient(*next);
      const std::array<double, 3> up = gradient(volume, *next);
      const bool is_centroid = next->x % 2 != 0 && next->y % 2 != 0 && next->z % 2 != 0;
      const double times = is_centroid ? -16 : -4;
      REQUIRE(static_cast<double>(down.x) == up[0] * times);
      REQUIRE(static_cast<double>(down.y) == up[1] * times);
      REQUIRE(static_cast<double>(down.z) == up[2] * times);
    }
  };
  const size_t slice = size_t{size.width} * size.height;
  for (uint32_t z = 0; z < size.depth; ++z) {
    for (size_t at = 0; at < slice; at += chunk) {
      const auto count = static_cast<uint32_t>(std::min<size_t>(chunk, slice - at));
      REQUIRE(window.push(volume.slice(z) + at, count) == Status::ok);
    }
    check_covered();
    // All vertices below the slice before the last have been visited.
    REQUIRE((next == vertices.end() || next->z > 2 * static_cast<int32_t>(z) - 3));
  }
  window.end();
  check_covered();
  REQUIRE(next == vertices.end());
  REQUIRE(window.push(volume.slice(0), 1) == Status::finished);
}

}  // namespace

TEST_CASE(
    "gradients are central differences at every vertex and one-sided differences at the border") {
  Chance chance(11);
  for (uint32_t depth = 1; depth <= 6; ++depth)
    for (uint32_t height = 1; height <= 4; ++height)
      for (uint32_t width = 1; width <= 5; ++width)
        for (const uint32_t chunk : {1U, 3U, 1000U}) {
          check_window<uint8_t>({width, height, depth}, chunk, chance);
          check_window<uint16_t>({width, height, depth}, chunk, chance);
          check_window<int16_t>({width, height, depth}, chunk, chance);
        }
}

TEST_CASE("a window covers a vertex while all slices around the vertex are stored") {
  StartedWindow window({2, 1});
  const uint8_t slice[2] = {1, 2};
  const Vertex between{0, 0, 5};  // slices 2 and 3: reads 1 to 4
  const Vertex within{1, 0, 4};   // slice 2: reads 1 to 3
  const Vertex lowest{1, 0, 0};   // reads 0 and 1
  for (int slices = 1; slices <= 6; ++slices) {
    REQUIRE(window.push(slice, 2) == Status::ok);
    CHECK(window.covers(between) == (slices == 5));
    CHECK(window.covers(within) == (slices == 4 || slices == 5));
    CHECK(window.covers(lowest) == (slices >= 2 && slices <= 4));
    CHECK(window.covers({0, 0, -1}) == (slices >= 2));  // outside: reads none
  }
  REQUIRE(window.push(slice, 1) == Status::ok);  // overwrites slice 2
  CHECK(!window.covers({0, 0, 7}));
  CHECK(window.block.is_intact());
}

TEST_CASE("gradients include the rows of an unfinished slice") {
  StartedWindow window({2, 2});
  const uint8_t samples[] = {10, 10, 10, 10, 20, 20, 20, 20, 70, 70};  // two slices and a row
  REQUIRE(window.push(samples, 10) == Status::ok);
  CHECK(!window.covers({1, 0, 2}));
  window.end();
  CHECK(window.negative_gradient({1, 0, 4}).z == -2 * 2 * (70 - 20));  // one-sided: nothing above
  CHECK(window.negative_gradient({1, 0, 2}).z == -2 * (70 - 10));      // central
  CHECK(window.negative_gradient({1, 2, 2}).z == -2 * 2 * (20 - 10));  // one-sided: nothing above
  CHECK(window.covers({1, 0, 8}));
  CHECK(window.negative_gradient({1, 0, 8}).z == 0);  // above the volume
}

TEST_CASE("the first row of a new slice removes the oldest slice from the window") {
  StartedWindow window({1, 2});
  const uint8_t samples[9] = {};
  REQUIRE(window.push(samples, 8) == Status::ok);
  CHECK(window.covers({0, 0, 3}));  // reads slices 0 to 3
  REQUIRE(window.push(samples, 1) == Status::ok);
  CHECK(!window.covers({0, 0, 3}));
  CHECK(window.covers({0, 1, 4}));  // reads 1 to 3
}

TEST_CASE("a finished window can be restarted for another pass") {
  const Limits limits{2, 1};
  Block block(SampleWindow<uint8_t>::bytes_for(limits));
  SampleWindow<uint8_t> window;
  const uint8_t slice[2] = {1, 2};
  for (int pass = 0; pass < 2; ++pass) {
    REQUIRE(window.start(limits, block.memory()) == Status::ok);
    REQUIRE(window.push(slice, 2) == Status::ok);
    CHECK(!window.covers({1, 0, 0}));
    window.end();
    CHECK(window.covers({1, 0, 0}));
  }
}

TEST_CASE("a sample window accepts samples with a stride") {
  StartedWindow window({2, 2});
  const uint8_t samples[] = {10, 0, 0, 20, 0, 0, 30, 0, 0, 70};
  REQUIRE(window.push(samples, 4, 3) == Status::ok);
  window.end();
  const LongVector down =
      window.negative_gradient({1, 0, 0});  // between 10 and 20, above 30 and 70
  CHECK(down.x == -2 * (10 + 10));
  CHECK(down.y == -2 * (20 + 50));
  CHECK(down.z == 0);
}

TEST_CASE(
    "a window refuses invalid limits and too little memory, and leaves the memory unchanged") {
  Block block(SampleWindow<uint16_t>::bytes_for({8, 8}));
  const Memory memory = block.memory();
  SampleWindow<uint16_t> window;
  const uint16_t sample = 7;
  CHECK(window.push(&sample, 1) == Status::not_started);
  CHECK(window.start({0, 8}, memory) == Status::bad_limits);
  CHECK(window.start({8, 32767}, memory) == Status::bad_limits);
  CHECK(window.start({8, 8}, {memory.data, memory.bytes - 1}) == Status::too_little_memory);
  CHECK(window.start({8, 8}, {nullptr, memory.bytes}) == Status::too_little_memory);
  CHECK(window.push(&sample, 1) == Status::not_started);
  CHECK(window.start({8, 8}, memory) == Status::ok);
}
