// Statements about the facets of all 256 configurations; by exhaustion.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <discmc/geometry/facet_table.hpp>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "oracle/cell_symmetry.hpp"

using namespace discmc;
using test::cell_symmetries;
using test::CellSymmetry;

namespace {

constexpr Vertex middle{1, 1, 1};

std::vector<Facet> facets_of(int configuration) {
  return {facet_table.facet + facet_table.first[configuration],
          facet_table.facet + facet_table.first[configuration + 1]};
}

std::vector<CellPoint> ring_of(Facet facet) {
  const FacetRing& ring = facet_rings.ring[facet];
  return {ring.point, ring.point + ring.count};
}

bool has_centroid(Facet facet) {
  const std::vector<CellPoint> ring = ring_of(facet);
  return std::find(ring.begin(), ring.end(), centroid) != ring.end();
}

using PointLink = std::pair<CellPoint, CellPoint>;
using LinkSet = std::set<PointLink>;

std::vector<PointLink> links_of(const std::vector<CellPoint>& ring) {
  std::vector<PointLink> result;
  for (size_t i = 0; i < ring.size(); ++i) result.push_back({ring[i], ring[(i + 1) % ring.size()]});
  return result;
}

std::vector<PointLink> links_of(Facet facet) {
  return links_of(ring_of(facet));
}

std::vector<std::vector<CellPoint>> loops_of(int configuration) {
  const Loops loops = detail::derive::loops(static_cast<Configuration>(configuration));
  std::vector<std::vector<CellPoint>> result;
  for (int l = 0; l < loops.count; ++l)
    result.emplace_back(loops.loop[l].point, loops.loop[l].point + loops.loop[l].count);
  return result;
}

// All facets that are, whether or not a configuration is given.
template <typename Check>
void for_each_facet(Check check) {
  for (int code = 0; code < facet_codes; ++code) {
    if (facet_rings.ring[code].count == 0) continue;
    CAPTURE(code);
    check(static_cast<Facet>(code));
  }
}

template <typename Check>
void for_each_configuration(Check check) {
  for (int c = 0; c < configurations; ++c) {
    CAPTURE(c);
    check(c);
  }
}

// The end of a cell's edge, given by its midpoint, in the direction of the edge.
bool end_is_on(int configuration, const Vertex& midpoint, bool far_end) {
  int corner = 0;
  const std::array<int32_t, 3> coordinates{midpoint.x, midpoint.y, midpoint.z};
  for (size_t axis = 0; axis < 3; ++axis)
    if (coordinates[axis] == 2 || (coordinates[axis] == 1 && far_end)) corner |= 1 << axis;
  return (configuration >> corner & 1) != 0;
}

// From the midpoint of a crossed edge towards its off end.
Vertex towards_off(int configuration, const Vertex& midpoint) {
  const Vertex along{midpoint.x % 2, midpoint.y % 2, midpoint.z % 2};
  return end_is_on(configuration, midpoint, true) ? -along : along;
}

bool is_ambiguous(int configuration, int face) {
  const detail::derive::FaceCorners ring = detail::derive::face_corners(face);
  const auto on = [&](int i) { return configuration >> ring.corner[i] & 1; };
  return on(0) == on(2) && on(1) == on(3) && on(0) != on(1);
}

bool has_ambiguous_face(int configuration) {
  for (int face = 0; face < faces; ++face)
    if (is_ambiguous(configuration, face)) return true;
  return false;
}

// A facet's ring, started where its smallest point is: rings that are the same compare as such.
std::vector<CellPoint> normalised(std::vector<CellPoint> ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

// A facet as geometry, so that a map of the cell can move it.
using Placed = std::pair<Incidence, std::vector<CellPoint>>;

std::set<Placed> placed_facets(int configuration) {
  std::set<Placed> set;
  for (const Facet facet : facets_of(configuration))
    set.insert({incidence_of(facet), normalised(ring_of(facet))});
  return set;
}

// Twice the area of a face's on part in square half-steps.
int twice_on_area(int configuration, int face) {
  constexpr int by_count[] = {0, 1, 4, 7, 8};
  int count = 0;
  for (const int corner : detail::derive::face_corners(face).corner)
    count += configuration >> corner & 1;
  return is_ambiguous(configuration, face) ? 2 : by_count[count];
}

// Six times the volume of the pyramid over a facet with its tip at corner 0.
int six_volumes(Facet facet) {
  const std::vector<CellPoint> ring = ring_of(facet);
  int sum = 0;
  for (size_t i = 2; i < ring.size(); ++i)
    sum += dot_product(position(ring[0]), cross(position(ring[i - 1]), position(ring[i])));
  return sum;
}

}  // namespace

TEST_CASE("1068 facets in total: 2/40/50/8/8/48/68/32 configurations have 0/1/2/3/4/5/6/7 facets") {
  std::array<int, 8> configurations_with{};
  CHECK(facet_table.first[0] == 0);
  for_each_configuration([&](int c) {
    REQUIRE(facet_table.first[c] <= facet_table.first[c + 1]);
    ++configurations_with.at(facets_of(c).size());
    CHECK(facets_of(c).size() == cell_facts.facets[c]);
  });
  CHECK(facet_table.first[configurations] == FacetTable::total);
  CHECK(configurations_with == std::array<int, 8>{2, 40, 50, 8, 8, 48, 68, 32});
}

TEST_CASE("every axis incidence occurs 44 times, every diagonal one 5, every corner one 93") {
  std::map<Incidence, int> times;
  for (const Facet facet : facet_table.facet) ++times[incidence_of(facet)];
  CHECK(times.size() == 26);
  constexpr int expected[] = {0, 44, 5, 93};
  for (const auto& [incidence, count] : times)
    CHECK(count == expected[dot_product(incidence_normal(incidence), incidence_normal(incidence))]);
}

TEST_CASE("axis incidences have 4 shapes, diagonal ones 2, corner ones 8") {
  std::map<Incidence, int> shapes;
  for_each_facet([&](Facet facet) { ++shapes[incidence_of(facet)]; });
  constexpr int expected[] = {0, 4, 2, 8};
  CHECK(shapes.size() == 26);
  for (const auto& [incidence, count] : shapes)
    CHECK(count == expected[dot_product(incidence_normal(incidence), incidence_normal(incidence))]);
}

TEST_CASE("a facet's code consists of its incidence and its shape") {
  for_each_facet([](Facet facet) {
    CHECK(facet_of(incidence_of(facet), shape_of(facet)) == facet);
    CHECK(incidence_of(facet) != no_incidence);
    CHECK(incidence_of(facet) < incidence_codes);
  });
}

TEST_CASE("every facet of the table has a ring, and all rings differ") {
  std::set<std::vector<CellPoint>> rings;
  int count = 0;
  for_each_facet([&](Facet facet) {
    rings.insert(normalised(ring_of(facet)));
    ++count;
  });
  CHECK(rings.size() == static_cast<size_t>(count));
  for (const Facet facet : facet_table.facet) CHECK(facet_rings.ring[facet].count >= 3);
}

TEST_CASE("a facet's points are edge midpoints or the centroid: an odd coordinate sum, each once") {
  for_each_facet([](Facet facet) {
    const std::vector<CellPoint> ring = ring_of(facet);
    CHECK(std::set<CellPoint>(ring.begin(), ring.end()).size() == ring.size());
    for (const CellPoint point : ring) {
      const Vertex p = position(point);
      CHECK((p.x + p.y + p.z) % 2 == 1);
    }
  });
}

TEST_CASE("a facet is flat and convex, its ring counter-clockwise seen from the normal's tip") {
  for_each_facet([](Facet facet) {
    const std::vector<CellPoint> ring = ring_of(facet);
    const Vertex n = incidence_normal(incidence_of(facet));
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vertex here = position(ring[i]);
      const Vertex next = position(ring[(i + 1) % ring.size()]);
      const Vertex after = position(ring[(i + 2) % ring.size()]);
      CHECK(dot_product(n, next - here) == 0);
      CHECK(dot_product(n, cross(next - here, after - next)) > 0);
    }
  });
}

TEST_CASE(
    "a facet's incidence determines its form: right triangle, rectangle or equilateral triangle") {
  for_each_facet([](Facet facet) {
    std::multiset<int> squared_lengths;
    for (const auto& [from, to] : links_of(facet)) {
      const Vertex link = position(to) - position(from);
      CHECK(detail::derive::link_of(detail::link_table, link) < link_codes);
      squared_lengths.insert(dot_product(link, link));
    }
    const Vertex n = incidence_normal(incidence_of(facet));
    if (dot_product(n, n) == 1) CHECK(squared_lengths == std::multiset<int>{2, 2, 4});
    if (dot_product(n, n) == 2) CHECK(squared_lengths == std::multiset<int>{2, 2, 4, 4});
    if (dot_product(n, n) == 3) CHECK(squared_lengths == std::multiset<int>{2, 2, 2});
  });
}

TEST_CASE("shapes are numbered as promised") {
  for_each_facet([](Facet facet) {
    const Incidence incidence = incidence_of(facet);
    const Vertex n = incidence_normal(incidence);
    const Shape shape = shape_of(facet);
    if (!has_centroid(facet)) {
      // On the on side of the centroid the plane cuts off what the normal points away from.
      CHECK(shape == (dot_product(n, position(ring_of(facet)[0]) - middle) < 0 ? 0 : 1));
      return;
    }
    CHECK(ring_of(facet)[0] == centroid);
    const Vertex outer = position(ring_of(facet)[2]) - position(ring_of(facet)[1]);
    const Direction direction = direction_of(incidence, outer);
    CHECK(shape == (dot_product(n, n) == 1 ? direction / 2 : 2 + direction));
  });
}

TEST_CASE("normals point from on to off, at every edge of the cell that a facet meets") {
  for_each_configuration([](int c) {
    for (const Facet facet : facets_of(c))
      for (const CellPoint point : ring_of(facet)) {
        if (point == centroid) continue;
        const Vertex midpoint = position(point);
        CHECK(end_is_on(c, midpoint, true) != end_is_on(c, midpoint, false));
        CHECK(dot_product(incidence_normal(incidence_of(facet)), towards_off(c, midpoint)) > 0);
      }
  });
}

TEST_CASE("inside a cell facets meet link against link, and only the loops are left over") {
  for_each_configuration([](int c) {
    LinkSet left_over;
    for (const Facet facet : facets_of(c))
      for (const auto& [from, to] : links_of(facet)) {
        CHECK(left_over.count({from, to}) == 0);
        if (left_over.erase({to, from}) == 0) left_over.insert({from, to});
      }
    LinkSet loops;
    for (const std::vector<CellPoint>& loop : loops_of(c))
      for (const PointLink& link : links_of(loop)) loops.insert(link);
    CHECK(left_over == loops);
  });
}

TEST_CASE("at most one loop per cell uses the centroid, and its fan turns around it once") {
  int fans = 0;
  for_each_configuration([&](int c) {
    LinkSet rim;
    for (const Facet facet : facets_of(c))
      if (has_centroid(facet)) rim.insert({ring_of(facet)[1], ring_of(facet)[2]});
    int loops_with_centroid = 0;
    for (const std::vector<CellPoint>& loop : loops_of(c)) {
      const std::vector<PointLink> loop_links = links_of(loop);
      if (rim.count(loop_links[0]) == 0) continue;
      ++loops_with_centroid;
      CHECK(rim == LinkSet(loop_links.begin(), loop_links.end()));
    }
    CHECK(loops_with_centroid == (rim.empty() ? 0 : 1));
    fans += loops_with_centroid;
  });
  CHECK(fans > 0);
}

TEST_CASE("classic Marching Cubes makes two triangles less than a loop has links") {
  for_each_configuration([](int c) {
    size_t triangles = 0;
    for (const std::vector<CellPoint>& loop : loops_of(c)) triangles += loop.size() - 2;
    CHECK(cell_facts.classic_triangles[c] == triangles);
  });
}

TEST_CASE("the enclosed volume can be computed from the facets with any reference point") {
  for_each_configuration([](int c) {
    int sum = 0;
    // The three faces at corner 0 have no height over it; the others have 2 half-steps.
    for (const int face : {face_right, face_back, face_above}) sum += 2 * twice_on_area(c, face);
    for (const Facet facet : facets_of(c)) sum += six_volumes(facet);
    CHECK(cell_facts.enclosed[c] == sum);
  });
}

TEST_CASE("both sides of a surface fill a cell of 48 units, except beside ambiguous faces") {
  CHECK(cell_facts.enclosed[0] == 0);
  CHECK(cell_facts.enclosed[1] == 1);
  for_each_configuration([](int c) {
    const int both = cell_facts.enclosed[c] + cell_facts.enclosed[255 - c];
    // On ambiguous faces both would be separated and leave room between them.
    CHECK((both == 48) == !has_ambiguous_face(c));
    CHECK(both <= 48);
  });
}

TEST_CASE("without an ambiguous face, on and off swapped turn every facet round") {
  for_each_configuration([](int c) {
    if (has_ambiguous_face(c)) return;
    std::set<Placed> turned;
    for (auto [incidence, ring] : placed_facets(c)) {
      std::reverse(ring.begin(), ring.end());
      turned.insert({opposite(incidence), normalised(ring)});
    }
    CHECK(turned == placed_facets(255 - c));
  });
}

TEST_CASE("facets follow the rotations and reflections of their cell") {
  for (const CellSymmetry& symmetry : cell_symmetries())
    for_each_configuration([&](int c) {
      std::set<Placed> moved;
      for (auto [incidence, ring] : placed_facets(c)) {
        for (CellPoint& point : ring) point = symmetry.point(point);
        if (symmetry.is_mirror()) std::reverse(ring.begin(), ring.end());
        moved.insert(
            {incidence_of(symmetry.vector(incidence_normal(incidence))), normalised(ring)});
      }
      CHECK(moved == placed_facets(symmetry.configuration(static_cast<Configuration>(c))));
    });
}
