// Intersecting faces.
#include "meshes/intersections.hpp"

#include "hand_made.hpp"
#include "meshes/box_tree.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

namespace {

using namespace discmc::meshing;
using discmc::test::Chance;
using hand_made::triangles_of;

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

Pairs intersections_of(const FaceMesh& mesh) {
  return intersecting_faces(mesh, all_faces(mesh));
}

// A triangle in the plane z = 0, and another one.
bool goes_through_floor(const Point& a, const Point& b, const Point& c) {
  const FaceMesh mesh =
      triangles_of({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, a, b, c}, {0, 1, 2, 3, 4, 5});
  return !intersections_of(mesh).empty();
}

}  // namespace

TEST_CASE("two triangles intersect if an edge of one meets the other") {
  CHECK(goes_through_floor({1, 1, -1}, {1, 1, 1}, {9, 9, 0.5}));
  CHECK(goes_through_floor({-9, 1, 1}, {9, 1, 1}, {1, 1, -3}));
  CHECK(goes_through_floor({1, 1, 0}, {1, 1, 1}, {2, 1, 1}));
  CHECK(goes_through_floor({2, 0, 0}, {2, -1, 1}, {3, -1, 1}));
  CHECK(goes_through_floor({1, -1, -1}, {1, -1, 1}, {1, 9, 0}));
}

TEST_CASE("triangles that miss each other or are coplanar do not intersect") {
  CHECK_FALSE(goes_through_floor({1, 1, 0.01}, {2, 1, 1}, {1, 2, 1}));
  CHECK_FALSE(goes_through_floor({3, 3, -1}, {3, 3, 1}, {9, 9, 0}));
  CHECK_FALSE(goes_through_floor({-1, -1, -1}, {-1, -1, 1}, {9, -2, 0}));
  CHECK_FALSE(goes_through_floor({1, 1, 0}, {2, 1, 0}, {1, 2, 0}));
  CHECK_FALSE(goes_through_floor({5, 5, 0}, {6, 5, 0}, {5, 6, 0}));
}

TEST_CASE("shared edges and vertices of triangles are no intersections; other contacts are") {
  const std::vector<Point> vertices = {{0, 0, 0}, {4, 0, 0},  {0, 4, 0},  {4, 4, 1},
                                       {1, 1, 1}, {1, 1, -1}, {-1, -1, 1}};
  CHECK(intersections_of(triangles_of(vertices, {0, 1, 2, 2, 1, 3})).empty());
  CHECK(intersections_of(triangles_of(vertices, {0, 1, 2, 0, 4, 6})).empty());
  CHECK(intersections_of(triangles_of(vertices, {0, 1, 2, 0, 4, 5})).size() == 1);
}

TEST_CASE("intersections do not depend on units or mirrored axes") {
  for (const Point& spacing : {Point{1e-3, 1e-3, 1e-3}, Point{1e4, 1e4, 1e4}, Point{-1, 2, -3}}) {
    FaceMesh mesh = triangles_of(
        {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 9, 0.5}}, {0, 1, 2, 3, 4, 5});
    for (Point& vertex : mesh.vertices_mm)
      for (std::size_t axis = 0; axis < 3; ++axis) vertex[axis] *= spacing[axis];
    CHECK(intersections_of(mesh).size() == 1);
  }
}

TEST_CASE(
    "a search limited to some faces finds exactly the intersecting pairs with such a face, in "
    "order") {
  Chance chance(3);
  constexpr std::uint32_t count = 300;
  std::vector<Point> vertices;
  std::vector<std::uint32_t> corners(std::size_t{3} * count);
  std::iota(corners.begin(), corners.end(), 0U);
  for (std::uint32_t face = 0; face < count; ++face) {
    const double x = chance.below(20), y = chance.below(20), z = chance.below(20);
    for (std::size_t i = 0; i < 3; ++i)
      vertices.push_back({x + chance.below(9), y + chance.below(9), z + chance.below(9)});
  }
  const FaceMesh mesh = triangles_of(vertices, corners);
  FaceList faces;
  for (std::uint32_t face = count; face > 10; --face) faces.push_back(face - 1);
  const Pairs all = intersecting_faces(mesh, faces);
  for (const std::uint32_t one_of : {1U, 2U, 20U, 1000U}) {
    std::vector<bool> is_wanted(count);
    for (std::uint32_t face = 0; face < count; ++face) is_wanted[face] = chance.below(one_of) == 0;
    Pairs expected;
    for (const auto& pair : all)
      if (is_wanted[pair[0]] || is_wanted[pair[1]]) expected.push_back(pair);
    CHECK(intersecting_faces(mesh, faces, {}, 1, is_wanted) == expected);
    CHECK(expected.empty() == (one_of == 1000));
  }
}

TEST_CASE("a rounded bounding box contains its triangle as closely as its number format allows") {
  const Corners triangle = {{{0.1, -0.1, 1e9 + 1}, {0.7, -0.7, 1e-9}, {1.0 / 3, -1.0 / 3, 0}}};
  const Box box(triangle);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] =
        std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
    CHECK(static_cast<double>(box.low[axis]) <= least);
    CHECK(static_cast<double>(box.high[axis]) >= most);
    CHECK(static_cast<double>(std::nextafter(box.low[axis], Box::infinity)) > least);
    CHECK(static_cast<double>(std::nextafter(box.high[axis], -Box::infinity)) < most);
  }
}

TEST_CASE("the box of a coordinate beyond the range of its number format still overlaps it") {
  const Box box(Corners{{{1e39, -1e39, 0}, {1e39, -1e39, 1}, {1e39, -1e39, 2}}});
  CHECK(box.overlaps(box));
  CHECK(box.squared_distance({1e38, -1e38, 1}) <= 2 * 9e38 * 9e38);
}

TEST_CASE("a bounding box tree finds each pair of overlapping boxes exactly once") {
  for (const std::size_t count : {0U, 1U, 4U, 5U, 100U, 700U}) {
    Chance chance(static_cast<std::uint32_t>(count) + 1);
    std::vector<Box> boxes;
    while (boxes.size() < count) {
      const double x = chance.below(20), y = chance.below(20), z = chance.below(20);
      Corners triangle;
      for (Point& corner : triangle)
        corner = {x + chance.below(5), y + chance.below(5), z + chance.below(5)};
      boxes.emplace_back(triangle);
    }
    std::vector<std::vector<int>> calls(count, std::vector<int>(count));
    const BoxTree tree(boxes);
    for (std::size_t part = 0; part < tree.part_count(); ++part)
      tree.for_each_near_pair(part, [&](std::uint32_t first, std::uint32_t second) {
        const std::uint32_t a = tree.index_at(first), b = tree.index_at(second);
        ++calls[a][b];
        ++calls[b][a];
      });
    bool are_right = true;
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = 0; b < count; ++b)
        are_right &= calls[a][b] == (a != b && boxes[a].overlaps(boxes[b]) ? 1 : 0);
    CHECK(are_right);
  }
}

TEST_CASE(
    "successive boxes along the space-filling curve are neighbours if the boxes fill a cube") {
  std::vector<Box> boxes;
  const auto add = [&boxes](double x, double y, double z) {
    boxes.emplace_back(Corners{{{x, y, z}, {x, y, z}, {x, y, z}}});
  };
  for (std::uint32_t i = 0; i < 512; ++i) add(i % 8 + 0.5, i / 8 % 8 + 0.5, i / 64 + 0.5);
  add(0, 0, 0);
  add(1023, 1023, 1023);
  const std::vector<std::uint32_t> along = along_curve(boxes);
  REQUIRE(along.size() == 514);
  std::vector<std::uint32_t> cube;
  for (const std::uint32_t place : along)
    if (place < 512) cube.push_back(place);
  for (std::size_t i = 1; i < cube.size(); ++i) {
    int steps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      steps += static_cast<int>(std::fabs(boxes[cube[i]].low[axis] - boxes[cube[i - 1]].low[axis]) +
                                0.5F);
    CHECK(steps == 1);
  }
}
