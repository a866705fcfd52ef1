// Ears of small rings: the triangles cover the ring once, and have the right neighbours. Rings that
// intersect themselves are refused.
#include "meshes/ears.hpp"

#include <random>

#include "test.hpp"

namespace {

using namespace discmc::meshing;

struct Cut {
  bool is_cut;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> pairs;
};

Cut cut(const std::vector<PlanePoint>& ring) {
  static Ears ears;  // reused, as in a triangulator
  Cut result;
  result.is_cut = ears.cut(ring, result.triangles, result.pairs);
  return result;
}

// A star-shaped ring: a point in the middle sees all of it, so the ring is simple.
std::vector<PlanePoint> star(std::size_t points, std::minstd_rand& random) {
  std::vector<PlanePoint> ring;
  const std::int64_t corner[] = {1000, 1000, -1000, 1000, -1000, -1000, 1000, -1000};
  for (std::size_t i = 0; i < points; ++i) {
    // Along the boundary of a square, then moved towards the middle.
    const std::size_t side = 4 * i / points;
    const auto along = static_cast<std::int64_t>(4 * i % points);
    const auto all = static_cast<std::int64_t>(points),
               part = 1 + static_cast<std::int64_t>(random() % 9);
    const std::int64_t* const from = corner + 2 * side;
    const std::int64_t* const to = corner + 2 * ((side + 1) % 4);
    ring.push_back({((all - along) * from[0] + along * to[0]) / 100 * part,
                    ((all - along) * from[1] + along * to[1]) / 100 * part});
  }
  return ring;
}

void check(const std::vector<PlanePoint>& ring, const Cut& cut) {
  REQUIRE(cut.is_cut);
  CHECK(cut.triangles.size() == ring.size() - 2);
  REQUIRE(cut.pairs.size() == 3 * cut.triangles.size());
  std::int64_t area = 0, expected = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;
  bool have_area = true;
  for (std::uint32_t t = 0; t < cut.triangles.size(); ++t) {
    const Triangle& corners = cut.triangles[t];
    const std::int64_t doubled = doubled_area(ring[corners[0]], ring[corners[1]], ring[corners[2]]);
    have_area = have_area && doubled > 0;
    area += doubled;
    for (std::uint32_t i = 0; i < 3; ++i) sides[{corners[i], corners[(i + 1) % 3]}] = 3 * t + i;
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanePoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
    expected += a.u * b.v - a.v * b.u;
  }
  CHECK(have_area);
  CHECK(area == expected);
  CHECK(sides.size() == cut.pairs.size());
  bool are_pairs = true;
  for (const auto& [ends, side] : sides) {
    const auto other = sides.find({ends.second, ends.first});
    are_pairs = are_pairs &&
                cut.pairs[side] == (other == sides.end() ? DelaunayFlips::no_side : other->second);
  }
  CHECK(are_pairs);
}

}  // namespace

TEST_CASE("ear clipping cuts a simple ring into triangles that list their neighbours") {
  std::minstd_rand random(1);
  for (std::size_t points = 5; points <= Ears::max_points; ++points)
    for (int round = 0; round < 20; ++round) {
      const std::vector<PlanePoint> ring = star(points, random);
      check(ring, cut(ring));
    }
  const std::vector<PlanePoint> collinear = {{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 4},
                                             {2, 2}, {1, 1}, {0, 2}, {0, 1}};
  check(collinear, cut(collinear));
}

TEST_CASE("ear clipping accepts a convex ring that begins at any point, also within a level side") {
  std::vector<PlanePoint> ring = {{0, 0}, {2, 0}, {4, 0}, {6, 2}, {4, 4}, {2, 4}, {0, 2}};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    check(ring, cut(ring));
  }
}

TEST_CASE("ear clipping refuses rings that touch or cross themselves or are clockwise") {
  CHECK_FALSE(cut({{2, 0}, {8, 4}, {0, 4}, {6, 0}, {4, 7}}).is_cut);          // winds twice
  CHECK_FALSE(cut({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {9, 4}, {1, 4}}).is_cut);  // crosses itself
  CHECK_FALSE(cut({{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}).is_cut);          // touches a side
  CHECK_FALSE(cut({{0, 0}, {8, 0}, {8, 2}, {4, -1}, {0, 2}}).is_cut);  // crosses a side twice
  CHECK_FALSE(cut({{0, 0}, {4, 2}, {8, 0}, {8, 8}, {4, 2}, {0, 8}}).is_cut);  // touches a corner
  CHECK_FALSE(cut({{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}}).is_cut);          // a spike
  CHECK_FALSE(cut({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}}).is_cut);          // repeats a point
  CHECK_FALSE(cut({{0, 4}, {4, 4}, {4, 2}, {4, 0}, {0, 0}}).is_cut);          // clockwise
  CHECK_FALSE(cut({{0, 0}, {1, 0}}).is_cut);
}

TEST_CASE("ear clipping refuses a ring of too many points") {
  std::minstd_rand random(1);
  CHECK(cut(star(Ears::max_points, random)).is_cut);
  CHECK_FALSE(cut(star(Ears::max_points + 1, random)).is_cut);
}
