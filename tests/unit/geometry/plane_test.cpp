// Chains in their plane: where runs lead, which points lie in a ring.
#include <doctest/doctest.h>
#include <discmc/plane.hpp>

#include <cstdint>
#include <vector>

#include "oracle/region.hpp"
#include "oracle/stream.hpp"

using namespace discmc;
using test::Chance;

namespace {

template <class Visit>
void for_each_incidence(Visit visit) {
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    if (is_incidence(incidence)) visit(incidence);
}

// A convex ring, once round through all directions.
std::vector<Run> round_ring(Incidence incidence) {
  std::vector<Run> runs;
  const Direction count = direction_count(incidence);
  for (Direction direction = 0; direction < count; ++direction)
    runs.push_back(Run::straight(direction, 2 + direction % (count / 2U)));
  return runs;
}

bool is_inside(Incidence incidence, Vertex at, const std::vector<Run>& runs,
               const PlanePoint& point) {
  bool inside = false;
  for (const Run run : runs) {
    if (PlaneSide(incidence, at, run).meets_ray(point)) inside = !inside;
    at = after_run(incidence, at, run);
  }
  return inside;
}

// Where a point is seen from a side of a convex ring: to its left, in the plane.
bool is_left_of_all(Incidence incidence, Vertex at, const std::vector<Run>& runs,
                    const Vertex& eighths) {
  for (const Run run : runs) {
    const Vertex step = direction_vector(incidence, run.direction());
    const Vertex to_point = eighths - Vertex{8 * at.x, 8 * at.y, 8 * at.z};
    if (dot(cross(step, to_point), normal(incidence)) <= 0) return false;
    at = after_run(incidence, at, run);
  }
  return true;
}

}  // namespace

TEST_CASE("a run leads where its links lead, and wraps") {
  for_each_incidence([](Incidence incidence) {
    for (Direction direction = 0; direction < direction_count(incidence); ++direction) {
      Vertex at{7, -3, 100};
      for (uint32_t length = 1; length < 5; ++length) {
        at = at + direction_vector(incidence, direction);
        CHECK(after_run(incidence, {7, -3, 100}, Run::straight(direction, length)) == at);
      }
    }
  });
  const Incidence up = incidence_of({0, 0, 1});
  const Run longest = Run::straight(direction_of(up, Vertex{2, 0, 0}), Run::max_length);
  Vertex at{INT32_MAX, 0, 0};
  for (int i = 0; i < 8; ++i) at = after_run(up, at, longest);
  CHECK(at == Vertex{INT32_MAX - 16, 0, 0});
}

TEST_CASE("the vertices of a plane have one offset, and those beside it another") {
  for_each_incidence([](Incidence incidence) {
    const Vertex vertex{3, -4, 12};
    const int32_t offset = plane_offset(incidence, vertex);
    CHECK(offset == dot(normal(incidence), vertex));
    for (Direction direction = 0; direction < direction_count(incidence); ++direction)
      CHECK(plane_offset(incidence, vertex + direction_vector(incidence, direction)) == offset);
    CHECK(plane_offset(incidence, vertex + normal(incidence)) != offset);
  });
  CHECK(plane_offset(incidence_of({1, 1, 1}), {INT32_MAX, INT32_MAX, INT32_MAX}) == INT32_MAX - 2);
}

TEST_CASE("runs are of a plane when their direction is and they have a length that runs can have") {
  const Incidence corner = incidence_of({1, 1, 1});
  CHECK(is_run_of(corner, Run::straight(5, 1)));
  CHECK_FALSE(is_run_of(corner, Run::straight(6, 1)));
  CHECK(is_run_of(corner, Run::straight(0, Run::max_length)));
  CHECK_FALSE(is_run_of(corner, Run::straight(0, Run::max_length + 1)));
  CHECK_FALSE(is_run_of(corner, Run()));
  CHECK_FALSE(is_incidence(no_incidence));
  CHECK_FALSE(is_incidence(27));
  CHECK(is_incidence(26));
}

TEST_CASE("the point beside a link lies left of it, in and near the plane") {
  for_each_incidence([](Incidence incidence) {
    const std::vector<Run> runs = round_ring(incidence);
    Vertex at{5, 6, 8};
    for (const Run run : runs) {
      const PlanePoint inside = point_beside(incidence, at, run.direction());
      CHECK(is_inside(incidence, {5, 6, 8}, runs, inside));
      // The same link the other way.
      const Vertex next = at + direction_vector(incidence, run.direction());
      const Direction back = opposite_direction(incidence, run.direction());
      CHECK_FALSE(is_inside(incidence, {5, 6, 8}, runs, point_beside(incidence, next, back)));
      at = after_run(incidence, at, run);
    }
  });
}

TEST_CASE("the point beside a link is an eighth of a half-step left of its middle") {
  const Vertex at{5, 6, 8};
  for_each_incidence([&](Incidence incidence) {
    for (Direction direction = 0; direction < direction_count(incidence); ++direction) {
      const Vertex link = direction_vector(incidence, direction);
      const Vertex left = cross(normal(incidence), link);
      const Vertex eighths{8 * at.x + 4 * link.x + left.x, 8 * at.y + 4 * link.y + left.y,
                           8 * at.z + 4 * link.z + left.z};
      const PlanePoint point = point_beside(incidence, at, direction);
      CHECK(point.u == projected(incidence, eighths).u);
      CHECK(point.v == projected(incidence, eighths).v);
    }
  });
}

TEST_CASE(
    "a ring has the points inside that are left of all its sides, on the ray of a vertex too") {
  Chance chance(1);
  for_each_incidence([&](Incidence incidence) {
    const Vertex start{1, -6, 4};
    const std::vector<Run> runs = round_ring(incidence);
    const int half = direction_count(incidence) / 2;
    int insides = 0;
    for (int i = 0; i < 3000; ++i) {
      // Points of the plane in steps of links, or parts of them: often as high as a vertex.
      Vertex eighths{8 * start.x, 8 * start.y, 8 * start.z};
      const int scale = i % 2 == 0 ? 8 : 1;
      for (const int direction : {0, half / 2}) {
        const Vertex step = direction_vector(incidence, static_cast<Direction>(direction));
        const int by = scale * (static_cast<int>(chance.below(80 / static_cast<uint32_t>(scale))) -
                                40 / scale);
        eighths = eighths + Vertex{by * step.x, by * step.y, by * step.z};
      }
      // A point on a side may count as inside or not.
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

TEST_CASE("the least and the greatest coordinates are compared as they are") {
  const Incidence side = incidence_of({1, 0, 0});
  const Direction rise = direction_of(side, Vertex{0, 0, 2});
  const Vertex bottom{1, 0, INT32_MIN};
  const Run run = Run::straight(rise, Run::max_length);
  const int64_t v = 8 * int64_t{INT32_MIN};
  const int64_t end = v + 16 * int64_t{Run::max_length};
  CHECK(PlaneSide(side, bottom, run).meets_ray({-1, v}));
  CHECK_FALSE(PlaneSide(side, bottom, run).meets_ray({-1, v - 1}));
  CHECK(PlaneSide(side, bottom, run).meets_ray({-1, end - 1}));
  CHECK_FALSE(PlaneSide(side, bottom, run).meets_ray({-1, end}));
  CHECK_FALSE(PlaneSide(side, bottom, run).meets_ray({1, v + 8}));
}
