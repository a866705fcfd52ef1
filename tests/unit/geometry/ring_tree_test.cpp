// Rings sorted by position, and the rings inside a ring.
#include <discmc/geometry/ring_tree.hpp>

#include <stdexcept>

#include "incidences.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using test::Chance;
using test::for_each_incidence;

namespace {

// A convex ring, with one run per direction.
std::vector<Run> round_ring(Incidence incidence) {
  std::vector<Run> runs;
  const Direction count = direction_count(incidence);
  for (Direction direction = 0; direction < count; ++direction)
    runs.push_back(Run::straight(direction, 2 + direction % (count / 2U)));
  return runs;
}

// Uses the nearest side before the point, on its line.
bool is_inside(Incidence incidence, Vertex at, const std::vector<Run>& runs,
               const ProjectedPoint& point) {
  bool is_inside = false;
  int64_t nearest = INT64_MIN;
  int sides = 0;
  for (const Run run : runs) {
    const RingSide side(incidence, at, run);
    at = after_run(incidence, at, run);
    if (point.v < side.first_line() || point.v >= side.end_line()) continue;
    const int64_t crossing = side.crossing(point.v);
    if (crossing >= point.u) continue;
    ++sides;
    if (crossing > nearest) is_inside = side.leads_left();
    nearest = std::max(nearest, crossing);
  }
  CHECK(is_inside == (sides % 2 == 1));
  return is_inside;
}

// Whether a point is on the left of a side of a convex ring.
bool is_left_of_all(Incidence incidence, Vertex at, const std::vector<Run>& runs,
                    const Vertex& eighths) {
  for (const Run run : runs) {
    const Vertex step = direction_vector(incidence, run.direction());
    const Vertex to_point = eighths - Vertex{8 * at.x, 8 * at.y, 8 * at.z};
    if (dot_product(cross(step, to_point), incidence_normal(incidence)) <= 0) return false;
    at = after_run(incidence, at, run);
  }
  return true;
}

struct Ring {
  Incidence incidence;
  Vertex start;
  Direction first;
};

ProjectedPoint point_of(const Ring& ring) {
  return point_beside(ring.incidence, ring.start, ring.first);
}

bool are_on_one_plane(const Ring& a, const Ring& b) {
  return a.incidence == b.incidence &&
         plane_offset(a.incidence, a.start) == plane_offset(b.incidence, b.start);
}

// A ring on one of a few planes, so rings are close together.
Ring any_ring(Chance& chance) {
  static const Incidence incidences[] = {incidence_of({0, 0, 1}), incidence_of({1, 0, 1}),
                                         incidence_of({-1, 1, 1}), incidence_of({0, -1, 0})};
  Ring ring{incidences[chance.below(4)], {0, 0, 0}, 0};
  const auto count = static_cast<uint32_t>(direction_count(ring.incidence));
  for (int i = 0; i < 2; ++i)
    translate(ring.start, ring.incidence, static_cast<Direction>(chance.below(count)),
              chance.below(9));
  ring.start = ring.start + Vertex{0, 0, static_cast<int32_t>(chance.below(2))};
  ring.first = static_cast<Direction>(chance.below(count));
  return ring;
}

// The tree may change only its links. Access to number 0 fails, because no ring has it.
struct Rings {
  std::vector<Ring> ring{1};
  mutable std::map<uint32_t, std::pair<uint32_t, uint32_t>> links;

  const Ring& at(uint32_t i) const { return i == no_slot ? throw std::out_of_range("0") : ring[i]; }
  Incidence incidence(uint32_t i) const { return at(i).incidence; }
  Vertex start(uint32_t i) const { return at(i).start; }
  Direction first(uint32_t i) const { return at(i).first; }
  uint32_t& left(uint32_t i) const { return links[i].first; }
  uint32_t& right(uint32_t i) const { return links[i].second; }
};

}  // namespace

TEST_CASE(
    "point_beside() returns a point inside a ring for its links, and outside for opposite links") {
  for_each_incidence([](Incidence incidence) {
    const std::vector<Run> runs = round_ring(incidence);
    Vertex at{5, 6, 8};
    for (const Run run : runs) {
      const ProjectedPoint inside = point_beside(incidence, at, run.direction());
      CHECK(is_inside(incidence, {5, 6, 8}, runs, inside));
      // The opposite link.
      const Vertex next = at + direction_vector(incidence, run.direction());
      const Direction back = opposite_direction(incidence, run.direction());
      CHECK_FALSE(is_inside(incidence, {5, 6, 8}, runs, point_beside(incidence, next, back)));
      at = after_run(incidence, at, run);
    }
  });
}

TEST_CASE("point_beside() returns a point an eighth of a half-step left of the link's middle") {
  const Vertex at{5, 6, 8};
  for_each_incidence([&](Incidence incidence) {
    for (Direction direction = 0; direction < direction_count(incidence); ++direction) {
      const Vertex link = direction_vector(incidence, direction);
      const Vertex left = cross(incidence_normal(incidence), link);
      const Vertex eighths{8 * at.x + 4 * link.x + left.x, 8 * at.y + 4 * link.y + left.y,
                           8 * at.z + 4 * link.z + left.z};
      const ProjectedPoint point = point_beside(incidence, at, direction);
      CHECK(point.u == projected(incidence, eighths).u);
      CHECK(point.v == projected(incidence, eighths).v);
    }
  });
}

TEST_CASE("a ring contains the points left of all its sides, even on the level of a vertex") {
  Chance chance(1);
  for_each_incidence([&](Incidence incidence) {
    const Vertex start{1, -6, 4};
    const std::vector<Run> runs = round_ring(incidence);
    const int half = direction_count(incidence) / 2;
    int insides = 0;
    for (int i = 0; i < 3000; ++i) {
      // Points of the plane in steps of links, or parts of steps; many are level with a vertex.
      Vertex eighths{8 * start.x, 8 * start.y, 8 * start.z};
      const int scale = i % 2 == 0 ? 8 : 1;
      for (const int direction : {0, half / 2}) {
        const Vertex step = direction_vector(incidence, static_cast<Direction>(direction));
        const int by = scale * (static_cast<int>(chance.below(80 / static_cast<uint32_t>(scale))) -
                                40 / scale);
        eighths = eighths + Vertex{by * step.x, by * step.y, by * step.z};
      }
      // A point on a side may count as inside or outside.
      bool is_on_side = false;
      Vertex at = start;
      for (const Run run : runs) {
        const Vertex step = direction_vector(incidence, run.direction());
        const Vertex to_point = eighths - Vertex{8 * at.x, 8 * at.y, 8 * at.z};
        is_on_side = is_on_side || cross(step, to_point) == Vertex{0, 0, 0};
        at = after_run(incidence, at, run);
      }
      if (is_on_side) continue;
      const bool expected = is_left_of_all(incidence, start, runs, eighths);
      REQUIRE(is_inside(incidence, start, runs, projected(incidence, eighths)) == expected);
      insides += expected;
    }
    CHECK(insides > 50);
  });
}

TEST_CASE("the crossing of a side is exact at the minimal and maximal coordinates") {
  const Incidence side = incidence_of({1, 0, 0});
  const Direction rise = direction_of(side, Vertex{0, 0, 2});
  const RingSide wall(side, {1, INT32_MAX, INT32_MIN}, Run::straight(rise, Run::max_length));
  CHECK(wall.first_line() == 8 * int64_t{INT32_MIN});
  CHECK(wall.end_line() == wall.first_line() + 16 * int64_t{Run::max_length});
  CHECK(wall.crossing(wall.end_line() - 1) == 8 * int64_t{INT32_MAX});
}

TEST_CASE("a ring tree finds rings by plane, line and position like an exhaustive search") {
  Chance chance(3);
  Rings rings;
  RingTree<Rings> tree;
  std::vector<uint32_t> inside;
  for (int step = 0; step < 3000; ++step) {
    if (inside.size() < 40 || chance.below(2) == 0) {
      const auto ring = static_cast<uint32_t>(rings.ring.size());
      // Some rings are equal.
      rings.ring.push_back(chance.below(4) == 0 && !inside.empty() ? rings.ring[inside.back()]
                                                                   : any_ring(chance));
      tree.insert(rings, ring);
      inside.push_back(ring);
    } else {
      const size_t i = chance.below(static_cast<uint32_t>(inside.size()));
      tree.remove(rings, inside[i]);
      inside.erase(inside.begin() + static_cast<std::ptrdiff_t>(i));
    }
    const Ring probe = any_ring(chance);
    const ProjectedPoint at = point_of(probe), high{at.u + 20, at.v + 20};
    const auto is_on_plane = [&](uint32_t ring) {
      return are_on_one_plane(rings.ring[ring], probe);
    };
    const auto is_in_box = [&](uint32_t ring) {
      const ProjectedPoint point = point_of(rings.ring[ring]);
      return is_on_plane(ring) && point.u >= at.u && point.u <= high.u && point.v >= at.v &&
             point.v <= high.v;
    };
    const bool has_plane = std::any_of(inside.begin(), inside.end(), is_on_plane);
    const uint32_t on_plane = tree.any_on_plane(rings, probe.incidence, probe.start);
    REQUIRE((on_plane != no_slot) == has_plane);
    if (has_plane) CHECK(is_on_plane(on_plane));
    REQUIRE(tree.has_any(rings, probe.incidence, probe.start, at, high) ==
            std::any_of(inside.begin(), inside.end(), is_in_box));

    const auto length = 1 + chance.below(4);
    const RingSide side(probe.incidence, probe.start, Run::straight(probe.first, length));
    std::map<int64_t, uint32_t> found, expected;  // by line
    tree.cross(rings, probe.incidence, probe.start, side, [&](uint32_t ring, int64_t crossing) {
      const int64_t line = point_of(rings.ring[ring]).v;
      CHECK(crossing == side.crossing_above(line));
      CHECK(found.emplace(line, ring).second);
    });
    for (const uint32_t ring : inside) {
      const ProjectedPoint point = point_of(rings.ring[ring]);
      if (!is_on_plane(ring) || point.v < side.first_line() || point.v >= side.end_line() ||
          point.u < side.crossing(point.v))
        continue;
      const auto first = expected.emplace(point.v, ring).first;
      const ProjectedPoint known = point_of(rings.ring[first->second]);
      if (std::make_pair(point.u, ring) < std::make_pair(known.u, first->second))
        first->second = ring;
    }
    REQUIRE(found == expected);

    const uint32_t ring = inside[chance.below(static_cast<uint32_t>(inside.size()))];
    const auto behind = [&](uint32_t other) {
      const ProjectedPoint own = point_of(rings.ring[ring]), point = point_of(rings.ring[other]);
      const bool is_behind = are_on_one_plane(rings.ring[ring], rings.ring[other]) &&
                             point.v == own.v && point.u > own.u;
      return std::make_pair(is_behind ? point.u : INT64_MAX, other);
    };
    const uint32_t next =
        *std::min_element(inside.begin(), inside.end(),
                          [&](uint32_t a, uint32_t b) { return behind(a) < behind(b); });
    REQUIRE(tree.next_on_line(rings, ring) == (behind(next).first < INT64_MAX ? next : no_slot));
  }
}

TEST_CASE("crossing_above() separates two sides that begin at the same vertex") {
  const Incidence up = incidence_of({0, 0, 1});
  const Vertex corner{5, 7, 1};
  const auto crossing_above = [&](const Vertex& link) {
    const RingSide side(up, corner, Run::straight(direction_of(up, link), 3));
    CHECK(side.crossing(8 * 7) == 8 * 5);
    return side.crossing_above(8 * 7);
  };
  CHECK(crossing_above({-1, 1, 0}) == 16 * 5 - 1);
  CHECK(crossing_above({0, 2, 0}) == 16 * 5);
  CHECK(crossing_above({1, 1, 0}) == 16 * 5 + 1);
}

TEST_CASE("a tree of sorted or equal rings is about as deep as a tree of random rings") {
  for (const int32_t step : {0, 1}) {
    Rings rings;
    RingTree<Rings> tree;
    const Incidence up = incidence_of({0, 0, 1});
    constexpr int32_t count = 20000;
    for (int32_t i = 0; i < count; ++i) {
      rings.ring.push_back({up, {2 * (i % 100) * step, i / 100 * step, 1}, 0});
      tree.insert(rings, static_cast<uint32_t>(rings.ring.size() - 1));
    }
    uint32_t deepest = 0;
    std::vector<std::pair<uint32_t, uint32_t>> open{{tree.any(), 1}};
    while (!open.empty()) {
      const auto [ring, depth] = open.back();
      open.pop_back();
      if (ring == no_slot) continue;
      deepest = std::max(deepest, depth);
      open.push_back({rings.left(ring), depth + 1});
      open.push_back({rings.right(ring), depth + 1});
    }
    CHECK(deepest < 50);  // 15 at the least
  }
}
