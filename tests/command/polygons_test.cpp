// The container of polygons: views of growing arrays.
#include "surface/polygons.hpp"

#include <random>

#include "hand_made.hpp"
#include "test.hpp"

namespace {

using discmc::Incidence;
using discmc::Vertex;
using discmc::meshing::Polygon;
using discmc::meshing::Polygons;
using discmc::meshing::Ring;
using hand_made::Corners;
using hand_made::polygon_of;
using hand_made::rings_of;

const Incidence up = discmc::incidence_of({0, 0, 1});
const Incidence down = discmc::incidence_of({0, 0, -1});
const Corners square = {{1, 0, 0}, {9, 0, 0}, {9, 8, 0}, {1, 8, 0}};
const Corners hole = {{3, 2, 0}, {3, 4, 0}, {5, 4, 0}};

Polygons square_with_hole() {
  return polygon_of(up, {square, hole});
}

struct Met {
  std::vector<Incidence> incidences;
  std::vector<std::vector<Corners>> rings;
  Corners corners;
};

Met met(const Polygons& polygons) {
  Met all;
  for (const Polygon& polygon : polygons) {
    all.incidences.push_back(polygon.incidence);
    all.rings.push_back(rings_of(polygon));
    for (const Ring& ring : polygon.rings)
      for (const Vertex& corner : ring) all.corners.push_back(corner);
  }
  return all;
}

}  // namespace

TEST_CASE("an empty list of polygons has no rings and no corners") {
  const Polygons none;
  CHECK(none.empty());
  CHECK(none.size() == 0);
  CHECK(met(none).incidences.empty());
  CHECK(none.corners().empty());
}

TEST_CASE("a polygon has its rings in the order of their addition") {
  const Polygons polygons = square_with_hole();
  REQUIRE(polygons.size() == 1);
  const Polygon polygon = polygons[0];
  CHECK(polygon.incidence == up);
  REQUIRE(polygon.rings.size() == 2);
  const Ring ring = polygon.rings[1];
  CHECK(ring.size() == 3);
  CHECK(ring[2] == Vertex{5, 4, 0});
  CHECK(rings_of(polygon) == std::vector<Corners>{square, hole});
}

TEST_CASE("append() adds polygons at the end, and polygons without rings keep their places") {
  Polygons polygons = polygon_of(down, {hole});
  polygons.append(polygon_of(up, {}));
  Polygons more = square_with_hole();
  more.append(polygon_of(down, {square}));
  polygons.append(more);
  polygons.append({});
  const Met all = met(polygons);
  CHECK(all.incidences == std::vector<Incidence>{down, up, up, down});
  CHECK(all.rings == std::vector<std::vector<Corners>>{{hole}, {}, {square, hole}, {square}});
  CHECK(all.corners.size() == polygons.corners().size());
}

TEST_CASE("adding a polygon of another list copies all its rings") {
  Polygons others = square_with_hole();
  others.append(polygon_of(down, {square}));
  Polygons polygons;
  polygons.push_back(others[1]);
  polygons.push_back(others[0]);
  const Met all = met(polygons);
  CHECK(all.incidences == std::vector<Incidence>{down, up});
  CHECK(all.rings == std::vector<std::vector<Corners>>{{square}, {square, hole}});
}

TEST_CASE("a list of polygons sorts by z, y and x of the first corners, then by incidence") {
  // Side by side; in distant rows; and in layers, some of which are distant.
  struct Spread {
    std::int32_t row, far_layer;
  };
  for (const Spread& spread : {Spread{1, 0}, Spread{9999, 0}, Spread{1, 99999999}}) {
    CAPTURE(spread.row);
    CAPTURE(spread.far_layer);
    std::minstd_rand random(7);
    const auto below = [&random](std::uint32_t end) {
      return static_cast<std::int32_t>(random() % end);
    };
    Polygons polygons;
    for (int i = 0; i < 10000; ++i) {
      const Vertex first{below(9), spread.row * below(20),
                         below(60) + (below(8) == 0 ? spread.far_layer : 0)};
      const Vertex second = first + Vertex{-2, -below(2), 0};
      polygons.append(polygon_of(below(2) == 0 ? up : down, {{first, second, {0, 0, 0}}}));
    }
    std::vector<std::pair<Incidence, Corners>> sorted;
    for (const Polygon& polygon : polygons)
      sorted.emplace_back(polygon.incidence, rings_of(polygon)[0]);
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
      const auto key = [](const auto& each) {
        const Vertex &first = each.second[0], &second = each.second[1];
        return std::array<std::int32_t, 5>{first.z, first.y, first.x, each.first, second.y};
      };
      return key(a) < key(b);
    });
    for (const unsigned jobs : {1U, 3U}) {
      CAPTURE(jobs);
      Polygons by_jobs = polygons;
      by_jobs.sort(jobs);
      std::vector<std::pair<Incidence, Corners>> result;
      for (const Polygon& polygon : by_jobs)
        result.emplace_back(polygon.incidence, rings_of(polygon)[0]);
      CHECK(result == sorted);
    }
  }
}
