// Statements about one cell and its loops, and about two cells with a common face; by exhaustion.
#include <discmc/geometry/cell.hpp>

#include "test.hpp"

using namespace discmc;

namespace {

bool is_on(Configuration configuration, int corner) {
  return (configuration >> corner & 1) != 0;
}

struct CellEdge {
  int corner_a, corner_b;
};

std::vector<CellEdge> cell_edges() {
  std::vector<CellEdge> edges;
  for (int a = 0; a < 8; ++a)
    for (int axis = 1; axis < 8; axis *= 2)
      if ((a & axis) == 0) edges.push_back({a, a | axis});
  return edges;
}

// The edges of the cell that the surface crosses.
std::set<CellPoint> crossings(Configuration configuration) {
  std::set<CellPoint> points;
  for (const CellEdge& edge : cell_edges())
    if (is_on(configuration, edge.corner_a) != is_on(configuration, edge.corner_b))
      points.insert(detail::derive::midpoint(edge.corner_a, edge.corner_b));
  return points;
}

struct LoopLink {
  CellPoint from, to;
};

std::vector<LoopLink> loop_links(Configuration configuration) {
  const Loops loops = detail::derive::loops(configuration);
  std::vector<LoopLink> result;
  for (int l = 0; l < loops.count; ++l)
    for (int i = 0; i < loops.loop[l].count; ++i)
      result.push_back(
          {loops.loop[l].point[i], loops.loop[l].point[(i + 1) % loops.loop[l].count]});
  return result;
}

template <typename Check>
void for_each_configuration(Check check) {
  for (int c = 0; c < configurations; ++c) {
    CAPTURE(c);
    check(static_cast<Configuration>(c));
  }
}

Vertex inward(int face) {
  const int sign = face < 3 ? 1 : -1;
  const int axis = face % 3;
  return {axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0};
}

// A face with on corners at opposite ends of a diagonal: its four crossings can be joined in two
// ways.
bool is_ambiguous(Configuration configuration, int face) {
  const detail::derive::FaceCorners ring = detail::derive::face_corners(face);
  const bool first = is_on(configuration, ring.corner[0]);
  return first == is_on(configuration, ring.corner[2]) &&
         first != is_on(configuration, ring.corner[1]) &&
         first != is_on(configuration, ring.corner[3]);
}

// Returns the corners of a face on the left of a link, seen from inside the cell.
std::vector<int> corners_on_left(int face, const LoopLink& link) {
  const Vertex from = position(link.from);
  const Vertex along = position(link.to) - from;
  std::vector<int> left;
  for (const int corner : detail::derive::face_corners(face).corner)
    if (dot_product(cross(along, detail::derive::corner_position(corner) - from), inward(face)) > 0)
      left.push_back(corner);
  return left;
}

using LinkSet = std::set<std::pair<CellPoint, CellPoint>>;

LinkSet links_on(int face, Configuration configuration, const Vertex& shift) {
  LinkSet set;
  for (const LoopLink& link : loop_links(configuration))
    if (face_of(link.from, link.to) == face)
      set.insert({point_at(position(link.from) + shift), point_at(position(link.to) + shift)});
  return set;
}

// All configurations of two adjacent cells: 12 voxels.
template <typename Check>
void for_each_pair(int axis, Check check) {
  const int bit = 1 << axis;
  const auto fit = [&](int cell, int next) {
    for (int corner = 0; corner < 8; ++corner)
      if ((corner & bit) == 0 && (cell >> (corner | bit) & 1) != (next >> corner & 1)) return false;
    return true;
  };
  for (int cell = 0; cell < configurations; ++cell)
    for (int next = 0; next < configurations; ++next)
      if (fit(cell, next))
        check(static_cast<Configuration>(cell), static_cast<Configuration>(next));
}

}  // namespace

TEST_CASE("cell point numbers and positions convert in both directions") {
  for (CellPoint point = 0; point < point_codes; ++point) CHECK(point_at(position(point)) == point);
  CHECK(point_at({2, 2, 2}) == point_codes - 1);
  CHECK(position(centroid) == Vertex{1, 1, 1});
}

TEST_CASE("corner c of a cell is at (c & 1, c >> 1 & 1, c >> 2) in steps of 2") {
  CHECK(detail::derive::corner_position(0) == Vertex{0, 0, 0});
  CHECK(detail::derive::corner_position(1) == Vertex{2, 0, 0});
  CHECK(detail::derive::corner_position(2) == Vertex{0, 2, 0});
  CHECK(detail::derive::corner_position(4) == Vertex{0, 0, 2});
  CHECK(detail::derive::corner_position(7) == Vertex{2, 2, 2});
}

TEST_CASE("edge midpoints are the twelve points with one odd coordinate") {
  std::set<CellPoint> midpoints;
  for (const CellEdge& edge : cell_edges())
    midpoints.insert(detail::derive::midpoint(edge.corner_a, edge.corner_b));
  CHECK(midpoints.size() == 12);
  for (int i = 0; i < 27; ++i) {
    const Vertex p{i % 3, i / 3 % 3, i / 9};
    CHECK((midpoints.count(point_at(p)) == 1) == (p.x % 2 + p.y % 2 + p.z % 2 == 1));
  }
}

TEST_CASE("the four corners of a face are counter-clockwise seen from inside the cell") {
  for (int face = 0; face < faces; ++face) {
    CAPTURE(face);
    const detail::derive::FaceCorners ring = detail::derive::face_corners(face);
    const int32_t plane = face < 3 ? 0 : -2;
    for (int i = 0; i < 4; ++i) {
      const Vertex before = detail::derive::corner_position(ring.corner[i]);
      const Vertex here = detail::derive::corner_position(ring.corner[(i + 1) % 4]);
      const Vertex after = detail::derive::corner_position(ring.corner[(i + 2) % 4]);
      CHECK(dot_product(inward(face), here) == plane);
      CHECK(cross(here - before, after - here) ==
            inward(face) + inward(face) + inward(face) + inward(face));
    }
  }
}

TEST_CASE("face_of() returns the face that two edge midpoints share, if any") {
  for (const CellEdge& a : cell_edges())
    for (const CellEdge& b : cell_edges()) {
      const CellPoint from = detail::derive::midpoint(a.corner_a, a.corner_b);
      const CellPoint to = detail::derive::midpoint(b.corner_a, b.corner_b);
      if (from == to) continue;
      int shared = faces;
      int count = 0;
      for (int face = 0; face < faces; ++face) {
        const int32_t plane = face < 3 ? 0 : -2;
        if (dot_product(inward(face), position(from)) != plane) continue;
        if (dot_product(inward(face), position(to)) != plane) continue;
        shared = face;
        ++count;
      }
      CHECK(count <= 1);
      CHECK(face_of(from, to) == shared);
    }
}

TEST_CASE("a link to the centroid is on no face") {
  for (const CellEdge& edge : cell_edges()) {
    const CellPoint point = detail::derive::midpoint(edge.corner_a, edge.corner_b);
    CHECK(face_of(point, centroid) == faces);
    CHECK(face_of(centroid, point) == faces);
  }
}

TEST_CASE("the loops of a cell visit each crossed edge once") {
  for_each_configuration([](Configuration configuration) {
    std::multiset<CellPoint> passed;
    for (const LoopLink& link : loop_links(configuration)) passed.insert(link.from);
    const std::set<CellPoint> crossed = crossings(configuration);
    CHECK(std::equal(passed.begin(), passed.end(), crossed.begin(), crossed.end()));
  });
}

TEST_CASE("every link of a loop is on a face and is a link of the lattice") {
  for_each_configuration([](Configuration configuration) {
    for (const LoopLink& link : loop_links(configuration)) {
      CHECK(face_of(link.from, link.to) < faces);
      CHECK(detail::derive::link_of(detail::link_table, position(link.to) - position(link.from)) <
            link_codes);
    }
  });
}

TEST_CASE("loops have 3 to 7 links, cells have 0 to 4 loops, and every count occurs") {
  std::set<int> lengths;
  std::set<int> loop_counts;
  for_each_configuration([&](Configuration configuration) {
    const Loops loops = detail::derive::loops(configuration);
    loop_counts.insert(loops.count);
    for (int l = 0; l < loops.count; ++l) lengths.insert(loops.loop[l].count);
  });
  CHECK(lengths == std::set<int>{3, 4, 5, 6, 7});
  CHECK(loop_counts == std::set<int>{0, 1, 2, 3, 4});
}

TEST_CASE("a cell has at most 12 links on faces and at most 6 on faces already visited") {
  size_t most = 0;
  std::ptrdiff_t max_behind = 0;
  for_each_configuration([&](Configuration configuration) {
    const std::vector<LoopLink> all = loop_links(configuration);
    most = std::max(most, all.size());
    max_behind = std::max(max_behind, std::count_if(all.begin(), all.end(), [](auto& link) {
                            return face_of(link.from, link.to) <= face_below;
                          }));
  });
  CHECK(most == 12);
  CHECK(max_behind == 6);
}

TEST_CASE(
    "each link has an on corner on its left and an off corner on its right, seen from inside") {
  for_each_configuration([](Configuration configuration) {
    for (const LoopLink& link : loop_links(configuration)) {
      const int face = face_of(link.from, link.to);
      const std::vector<int> left = corners_on_left(face, link);
      for (const int corner : detail::derive::face_corners(face).corner) {
        const bool on_left = std::find(left.begin(), left.end(), corner) != left.end();
        // On an ambiguous face, the other on corner is on the right of the link, and has a link of
        // its own.
        if (on_left || !is_ambiguous(configuration, face))
          CHECK(is_on(configuration, corner) == on_left);
      }
    }
  });
}

TEST_CASE("links on an ambiguous face separate the on corners") {
  int ambiguous = 0;
  for_each_configuration([&](Configuration configuration) {
    for (const LoopLink& link : loop_links(configuration)) {
      const int face = face_of(link.from, link.to);
      if (!is_ambiguous(configuration, face)) continue;
      ++ambiguous;
      CHECK(corners_on_left(face, link).size() == 1);
    }
  });
  CHECK(ambiguous == 2 * 2 * faces * 16);
}

TEST_CASE("two cells that share a face have the same links on the face, in opposite directions") {
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    int pairs = 0;
    for_each_pair(axis, [&](Configuration cell, Configuration next) {
      ++pairs;
      // Both in the coordinates of the second cell.
      const LinkSet from_cell = links_on(axis + 3, cell, -inward(axis) - inward(axis));
      LinkSet turned_round;
      for (const auto& [from, to] : links_on(axis, next, {0, 0, 0}))
        turned_round.insert({to, from});
      if (from_cell != turned_round) FAIL_CHECK("cells ", int{cell}, " and ", int{next});
    });
    CHECK(pairs == 4096);
  }
}
