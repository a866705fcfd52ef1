// Triangulation: it keeps every point and the exact area, has no flat triangle, and is Delaunay
// where the points allow.
#include "meshes/triangulator.hpp"

#include <random>

#include "test.hpp"

namespace {

using namespace discmc::meshing;

using Position = std::pair<std::int64_t, std::int64_t>;
using Edge = std::pair<Position, Position>;

Position position(const PlanePoint& point) {
  return {point.u, point.v};
}

struct Rings {
  std::vector<PlanePoint> points;
  std::vector<std::uint32_t> ends;

  void add(const std::vector<PlanePoint>& ring) {
    points.insert(points.end(), ring.begin(), ring.end());
    ends.push_back(static_cast<std::uint32_t>(points.size()));
  }

  template <class Visitor>
  void for_each_side(const Visitor& visit) const {
    std::size_t begin = 0;
    for (const std::uint32_t end : ends) {
      for (std::size_t i = begin; i < end; ++i)
        visit(points[i], points[i + 1 < end ? i + 1 : begin]);
      begin = end;
    }
  }
};

Rings rings(const std::vector<std::vector<PlanePoint>>& all) {
  Rings result;
  for (const auto& ring : all) result.add(ring);
  return result;
}

std::vector<Triangle> triangulate(const Rings& rings) {
  return Triangulator().triangulate(rings.points, rings.ends);
}

bool bound_a_polygon(const std::vector<std::vector<PlanePoint>>& all) {
  return !triangulate(rings(all)).empty();
}

bool is_between(const PlanePoint& a, const PlanePoint& b, const PlanePoint& point) {
  const std::int64_t along = (point.u - a.u) * (point.u - b.u) + (point.v - a.v) * (point.v - b.v);
  return doubled_area(a, b, point) == 0 && along < 0;
}

// The sides, divided where a point of a ring lies inside one.
std::set<Edge> boundary(const Rings& rings) {
  std::set<Edge> edges;
  rings.for_each_side([&](const PlanePoint& a, const PlanePoint& b) {
    std::vector<PlanePoint> stops = {a, b};
    for (const PlanePoint& point : rings.points)
      if (is_between(a, b, point)) stops.push_back(point);
    const auto distance = [&a](const PlanePoint& point) {
      return std::abs(point.u - a.u) + std::abs(point.v - a.v);
    };
    std::sort(stops.begin(), stops.end(), [&](const PlanePoint& one, const PlanePoint& other) {
      return distance(one) < distance(other);
    });
    for (std::size_t i = 1; i < stops.size(); ++i)
      if (distance(stops[i - 1]) < distance(stops[i]))
        edges.emplace(position(stops[i - 1]), position(stops[i]));
  });
  return edges;
}

// Whether d lies inside the circle through a, b and c. Limit: coordinates up to 2^13.
bool is_inside_circle(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c,
                      const PlanePoint& d) {
  const auto term = [&d](const PlanePoint& lifted, const PlanePoint& from, const PlanePoint& to) {
    const std::int64_t u = lifted.u - d.u, v = lifted.v - d.v;
    return (u * u + v * v) * doubled_area(d, from, to);
  };
  return term(a, b, c) + term(b, c, a) + term(c, a, b) > 0;
}

// Checks all promises. The boundary of the triangles is that of the polygon, and no point is
// covered twice. So every point is a corner, and there are no T-junctions.
void check_contract(const Rings& rings, const std::vector<Triangle>& triangles) {
  std::map<Edge, PlanePoint> apexes;
  std::int64_t area = 0, flat = 0, twice = 0;
  for (const Triangle& t : triangles) {
    const std::array<PlanePoint, 3> corners = {rings.points[t[0]], rings.points[t[1]],
                                               rings.points[t[2]]};
    const std::int64_t doubled = doubled_area(corners[0], corners[1], corners[2]);
    flat += doubled <= 0 ? 1 : 0;
    area += doubled;
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge = {position(corners[i]), position(corners[(i + 1) % 3])};
      twice += apexes.emplace(edge, corners[(i + 2) % 3]).second ? 0 : 1;
    }
  }
  CHECK(flat == 0);
  CHECK(twice == 0);
  std::int64_t expected = 0;
  rings.for_each_side(
      [&](const PlanePoint& a, const PlanePoint& b) { expected += a.u * b.v - a.v * b.u; });
  CHECK(area == expected);

  std::set<Edge> open;
  std::int64_t not_delaunay = 0;
  for (const auto& [edge, apex] : apexes) {
    const auto twin = apexes.find({edge.second, edge.first});
    if (twin == apexes.end()) {
      open.insert(edge);
      continue;
    }
    const PlanePoint a = {edge.first.first, edge.first.second};
    const PlanePoint b = {edge.second.first, edge.second.second};
    not_delaunay += is_inside_circle(a, b, apex, twin->second) ? 1 : 0;
  }
  CHECK(open == boundary(rings));
  CHECK(not_delaunay == 0);
}

void check_contract(const Rings& rings) {
  check_contract(rings, triangulate(rings));
}

// The boundary of the squares that are on, which may touch at their corners. Some points on its
// straight sides are kept.
Rings outlines(const std::vector<std::vector<bool>>& on, std::minstd_rand& random) {
  const auto is_on = [&on](std::int64_t x, std::int64_t y) {
    const auto height = static_cast<std::int64_t>(on.size());
    return y >= 0 && y < height && x >= 0 && x < static_cast<std::int64_t>(on[0].size()) &&
           on[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  };
  std::multimap<Position, Position> sides;
  for (std::int64_t y = 0; y < static_cast<std::int64_t>(on.size()); ++y)
    for (std::int64_t x = 0; x < static_cast<std::int64_t>(on[0].size()); ++x) {
      if (!is_on(x, y)) continue;
      if (!is_on(x, y - 1)) sides.insert({{x, y}, {x + 1, y}});
      if (!is_on(x + 1, y)) sides.insert({{x + 1, y}, {x + 1, y + 1}});
      if (!is_on(x, y + 1)) sides.insert({{x + 1, y + 1}, {x, y + 1}});
      if (!is_on(x - 1, y)) sides.insert({{x, y + 1}, {x, y}});
    }
  Rings result;
  while (!sides.empty()) {
    std::vector<PlanePoint> ring;
    for (auto side = sides.begin(); side != sides.end(); side = sides.find(position(ring.back()))) {
      ring.push_back({side->second.first, side->second.second});
      sides.erase(side);
    }
    std::vector<PlanePoint> kept;
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (random() % 2 == 0 || doubled_area(ring[(i + ring.size() - 1) % ring.size()], ring[i],
                                            ring[(i + 1) % ring.size()]) != 0)
        kept.push_back(ring[i]);
    result.add(kept);
  }
  return result;
}

}  // namespace

TEST_CASE("triangulation keeps collinear points and makes no flat triangle") {
  const Rings polygon =
      rings({{{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 2}, {1, 1}, {0, 2}, {0, 1}}});
  CHECK(triangulate(polygon).size() == polygon.points.size() - 2);
  check_contract(polygon);
}

TEST_CASE("triangulation accepts holes that touch each other or the rim, also inside a side") {
  const std::vector<PlanePoint> rim = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
  const std::vector<PlanePoint> low = {{6, 0}, {4, 2}, {6, 4}, {8, 2}};
  const std::vector<PlanePoint> high = {{6, 4}, {4, 6}, {6, 8}, {8, 6}};
  check_contract(rings({rim, low, high}));
  check_contract(rings({rim, {{6, 4}, {4, 8}, {8, 8}}, {{6, 8}, {5, 10}, {7, 10}}}));
  check_contract(rings({{{0, 0}, {6, 0}, {12, 0}, {12, 12}, {0, 12}}, low}));
}

TEST_CASE("triangulation succeeds for random patterns of squares under any shear") {
  std::minstd_rand random(1);
  for (int round = 0; round < 400; ++round) {
    const std::size_t width = 1 + random() % 9, height = 1 + random() % 9;
    const auto share = 20 + random() % 75;
    std::vector<std::vector<bool>> on(height, std::vector<bool>(width));
    on[0][0] = true;
    for (auto& row : on)
      for (std::size_t x = 0; x < width; ++x) row[x] = row[x] || random() % 100 < share;
    Rings polygon = outlines(on, random);
    const auto shear = static_cast<std::int64_t>(random() % 7);
    const auto lean = static_cast<std::int64_t>(random() % 5);
    for (PlanePoint& point : polygon.points) {
      point.u += shear * point.v;
      point.v += lean * point.u;
    }
    check_contract(polygon);
  }
}

TEST_CASE("triangulation succeeds for a wall with thousands of holes") {
  std::minstd_rand random(2);
  std::vector<std::vector<bool>> on(101, std::vector<bool>(101, true));
  for (std::size_t y = 1; y < 100; y += 2)
    for (std::size_t x = 1; x < 100; x += 2) on[y][x] = false;
  const Rings polygon = outlines(on, random);
  CHECK(polygon.ends.size() == 2501);
  const std::vector<Triangle> triangles = triangulate(polygon);
  CHECK(triangles.size() == polygon.points.size() - 2 + 2 * 2500);
  std::int64_t area = 0, flat = 0;
  for (const Triangle& t : triangles) {
    const std::int64_t doubled =
        doubled_area(polygon.points[t[0]], polygon.points[t[1]], polygon.points[t[2]]);
    flat += doubled <= 0 ? 1 : 0;
    area += doubled;
  }
  CHECK(flat == 0);
  CHECK(area == 2 * (101 * 101 - 2500));
}

TEST_CASE("a triangulator is reusable for further polygons") {
  Triangulator triangulator;
  const Rings large = rings({{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{3, 3}, {3, 6}, {6, 6}, {6, 3}}});
  const Rings small = rings({{{0, 0}, {1, 0}, {0, 1}}});
  CHECK(triangulator.triangulate(large.points, large.ends).size() == 8);
  check_contract(small, triangulator.triangulate(small.points, small.ends));
  const Rings crossing = rings({{{0, 0}, {2, 2}, {2, 0}, {0, 3}}});
  CHECK(triangulator.triangulate(crossing.points, crossing.ends).empty());
  check_contract(large, triangulator.triangulate(large.points, large.ends));
}

TEST_CASE("triangulation is exact for the largest coordinates") {
  constexpr std::int64_t far = max_plane_coordinate;
  const Rings polygon =
      rings({{{-far, -far}, {far, -far}, {far, 1 - far}, {far, far}, {-far, far}}});
  std::int64_t area = 0;
  for (const Triangle& t : triangulate(polygon))
    area += doubled_area(polygon.points[t[0]], polygon.points[t[1]], polygon.points[t[2]]);
  CHECK(area == 8 * far * far);
}

TEST_CASE("triangulation succeeds for points that would need more flips than the limit") {
  std::vector<PlanePoint> ring;
  for (std::int64_t i = -20000; i <= 20000; ++i) ring.push_back({i, -i * i / 64 - 1});
  for (std::int64_t i = 20000; i >= -20000; --i) ring.push_back({i, i * i / 64 + 1});
  CHECK(triangulate(rings({ring})).size() == ring.size() - 2);
}

TEST_CASE("triangulation gives no triangles for rings that bound no polygon") {
  const std::vector<PlanePoint> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(bound_a_polygon({square}));
  CHECK(!bound_a_polygon({}));
  CHECK(!bound_a_polygon({{{0, 0}, {0, 4}, {4, 4}, {4, 0}}}));
  CHECK(!bound_a_polygon({square, {{9, 1}, {9, 3}, {10, 3}}}));
  CHECK(!bound_a_polygon({square, {{1, 1}, {3, 1}, {3, 3}}}));
  // Sides cross.
  CHECK(!bound_a_polygon({square, {{1, 1}, {1, 3}, {9, 2}}}));
  CHECK(!bound_a_polygon({{{2, 0}, {8, 4}, {0, 4}, {6, 0}, {4, 7}}}));  // a star
  // Sides overlap.
  CHECK(!bound_a_polygon({square, {{0, 1}, {0, 3}, {2, 2}}}));
  CHECK(!bound_a_polygon({{{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}}}));
  CHECK(!bound_a_polygon({{{0, 0}, {4, 0}}}));                  // two points
  CHECK(!bound_a_polygon({{{0, 0}, {4, 0}, {4, 0}, {4, 4}}}));  // a side of length 0
  CHECK(!bound_a_polygon({{{0, 0}, {max_plane_coordinate + 1, 0}, {4, 4}}}));
}
