// From chains to polygons: simple rings, compared with a naive splitter; areas; corners.
#include <discmc/polygon.hpp>

#include "oracle/agreement.hpp"
#include "oracle/scan.hpp"
#include "test.hpp"

using namespace discmc;
using reference::Ring;

namespace {

using Rings = std::vector<Ring>;

Rings split(Ring ring) {
  Rings rings;
  // Memory of exactly the requested size.
  std::vector<uint32_t> scratch(2 * ring.size(), UINT32_MAX);  // with arbitrary contents
  const auto take = [](void* context, const Vertex* vertices, uint32_t count) {
    static_cast<Rings*>(context)->emplace_back(vertices, vertices + count);
  };
  split_ring(ring.data(), static_cast<uint32_t>(ring.size()), scratch.data(), {&rings, take});
  return rings;
}

// A vertex that recurs closes a loop. Cuts the loop out, and starts again.
Rings split_naively(Ring ring) {
  Rings rings;
  for (size_t end = 1; end < ring.size();) {
    size_t begin = 0;
    while (begin < end && ring[begin] != ring[end]) ++begin;
    if (begin == end) {
      ++end;
      continue;
    }
    const auto first = ring.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = ring.begin() + static_cast<std::ptrdiff_t>(end);
    if (end - begin > 2) rings.emplace_back(first, last);
    ring.erase(first, last);
    end = begin + 1;
  }
  if (ring.size() > 2) rings.push_back(ring);
  return rings;
}

Ring canonical(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), reference::before),
              ring.end());
  return ring;
}

Rings canonical(Rings rings) {
  for (Ring& ring : rings) ring = canonical(ring);
  std::sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), reference::before);
  });
  return rings;
}

Ring flat(const std::vector<std::pair<int, int>>& points) {
  Ring ring;
  for (const auto& [x, y] : points) ring.push_back({x, y, 0});
  return ring;
}

// A closed walk on a small torus of vertices. It touches itself nearly everywhere.
Ring random_walk(uint32_t seed, uint32_t length, int32_t extent) {
  Ring ring;
  for (uint32_t i = 0; i < length; ++i) {
    seed = seed * 1664525 + 1013904223;
    ring.push_back(
        {static_cast<int32_t>(seed >> 8) % extent, static_cast<int32_t>(seed >> 20) % extent, 1});
  }
  return ring;
}

constexpr Incidence up = incidence_of(Vertex{0, 0, 1});

}  // namespace

TEST_CASE("a ring is split into the same rings after a rotation of its axes") {
  for (uint32_t seed = 0; seed < 300; ++seed) {
    Ring ring = random_walk(seed, seed % 60, 7);
    const Rings expected = split(ring);
    for (int axis = 0; axis < 2; ++axis) {
      for (Vertex& vertex : ring) vertex = {vertex.z, vertex.x, vertex.y};
      Rings turned = split(ring);
      for (Ring& simple : turned)
        for (Vertex& vertex : simple)
          for (int back = 0; back <= axis; ++back) vertex = {vertex.y, vertex.z, vertex.x};
      CHECK(turned == expected);
    }
  }
}

TEST_CASE("any ring is split as by a naive splitter, and its area is preserved") {
  for (uint32_t seed = 0; seed < 3000; ++seed) {
    const Ring ring = random_walk(seed, seed % 120, 1 + static_cast<int32_t>(seed % 13));
    const Rings rings = split(ring);
    CAPTURE(seed);
    CHECK(rings == split_naively(ring));
    int64_t area = 0;
    for (Ring simple : rings) {
      area += twice_area(up, simple.data(), static_cast<uint32_t>(simple.size()));
      std::sort(simple.begin(), simple.end(), reference::before);
      CHECK(std::adjacent_find(simple.begin(), simple.end()) == simple.end());
    }
    CHECK(area == twice_area(up, ring.data(), static_cast<uint32_t>(ring.size())));
  }
}

TEST_CASE(
    "the rings of a swept volume, whole or cut, split into the simple rings of the reference") {
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const reference::BitVolume volume = reference::random({14, 13, 4}, 200, seed);
    const Limits limits{14, 13};
    reference::Collector collector;
    reference::scan_into<uint16_t>(collector, volume, {},
                                   Extractor16::minimum_bytes(limits) + 1 + seed * 300);
    for (const reference::Region& region : collector.regions()) {
      Rings expected;
      Rings rings;
      for (const Ring& ring : region.rings) {
        const Rings of_library = split(ring);
        const Rings of_naive = split_naively(ring);
        rings.insert(rings.end(), of_library.begin(), of_library.end());
        expected.insert(expected.end(), of_naive.begin(), of_naive.end());
      }
      CHECK(rings == expected);
      const auto simple = reference::simple_rings({region});
      CHECK(canonical(rings) == canonical(simple[0].rings));
    }
  }
}

TEST_CASE(
    "a ring of half a million links is split: a slit vanishes, and a simple ring is unchanged") {
  constexpr uint32_t half = 250000;
  Ring line;
  for (int32_t x = 0; x < static_cast<int32_t>(half); ++x) line.push_back({x, 0, 0});
  for (auto x = static_cast<int32_t>(half); x > 0; --x) line.push_back({x, 0, 0});
  CHECK(split(line).empty());
  for (size_t i = half; i < line.size(); ++i) line[i].y = 2;
  CHECK(split(line) == Rings{line});
}

TEST_CASE("ring_vertices() returns one vertex per link, beginning with the start") {
  const Run runs[] = {Run::straight(0, 3), Run::straight(2, 2), Run::straight(4, 3),
                      Run::straight(6, 2)};
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    if (direction_count(incidence) != 8) continue;
    CHECK(link_count(runs, 4) == 10);
    Ring vertices(10);
    ring_vertices(incidence, {5, 6, 8}, runs, 4, vertices.data());
    CHECK(vertices[0] == Vertex{5, 6, 8});
    for (size_t i = 0; i < 10; ++i) {
      const Direction direction = i < 3 ? 0 : i < 5 ? 2 : i < 8 ? 4 : 6;
      CHECK(vertices[(i + 1) % 10] - vertices[i] == direction_vector(incidence, direction));
    }
    CHECK(twice_area(incidence, vertices.data(), 10) == twice_area(incidence, runs, 4));
    CHECK(twice_area(incidence, vertices.data(), 10) ==
          reference::signed_area(incidence, vertices));
  }
  CHECK(link_count(nullptr, 0) == 0);
  const Run longest[] = {Run::straight(0, Run::max_length), Run::straight(0, Run::max_length)};
  CHECK(link_count(longest, 2) == 2 * uint64_t{Run::max_length});
}

TEST_CASE("the area of a ring is exact for the whole range of coordinates") {
  constexpr int32_t far = 65531;
  const Ring ring = {{-1, -1, 0}, {far, -1, 0}, {far, far, 0}, {-1, far, 0}};
  CHECK(twice_area(up, ring.data(), 4) == int64_t{2} * (far + 1) * (far + 1));
  // A wall as high as the deepest scan.
  constexpr int32_t top = 2147483645;
  const Incidence right = incidence_of(Vertex{1, 0, 0});
  const Ring wall = {{0, -1, -1}, {0, far, -1}, {0, far, top}, {0, -1, top}};
  CHECK(twice_area(right, wall.data(), 4) == int64_t{2} * (far + 1) * (int64_t{top} + 1));
  CHECK(twice_area(up, ring.data(), 0) == 0);
  CHECK(twice_area(up, ring.data(), 1) == 0);
  CHECK(twice_area(up, ring.data(), 2) == 0);
}

TEST_CASE("corners are the vertices between links of different directions, the start included") {
  const Ring square = flat({{1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}});
  const bool expected[] = {false, true, false, true, false, true, false, true};
  for (uint32_t i = 0; i < 8; ++i) CHECK(is_corner(square.data(), 8, i) == expected[i]);
  Ring corners = square;
  CHECK(keep_corners(corners.data(), 8) == 4);
  corners.resize(4);
  CHECK(corners == flat({{2, 0}, {2, 2}, {0, 2}, {0, 0}}));
}

TEST_CASE("keep_corners() keeps corners and the requested vertices") {
  for (uint32_t seed = 0; seed < 500; ++seed) {
    const Ring ring = random_walk(seed, seed % 40, 3);
    const auto count = static_cast<uint32_t>(ring.size());
    const auto wanted = [](const Vertex& vertex) { return vertex.x == 1; };
    Ring expected;
    Ring expected_corners;
    for (uint32_t i = 0; i < count; ++i) {
      const bool corner = is_corner(ring.data(), count, i);
      if (corner) expected_corners.push_back(ring[i]);
      if (corner || wanted(ring[i])) expected.push_back(ring[i]);
    }
    Ring kept = ring;
    kept.resize(keep_corners(kept.data(), count, wanted));
    CHECK(kept == expected);
    kept = ring;
    kept.resize(keep_corners(kept.data(), count));
    CHECK(kept == expected_corners);
  }
}
