// Distances between meshes with known results.
#include "meshes/surface_distance.hpp"

#include <stdexcept>

#include "hand_made.hpp"
#include "meshes/point_distance.hpp"
#include "oracle/stream.hpp"
#include "sample_reader.hpp"
#include "test.hpp"

namespace {

using namespace discmc::meshing;

FaceMesh square(double size, double height) {
  return hand_made::triangles_of(
      {{0, 0, height}, {size, 0, height}, {size, size, height}, {0, size, height}},
      {0, 1, 2, 0, 2, 3});
}

FaceMesh moved(FaceMesh mesh, const Point& by) {
  for (Point& vertex : mesh.vertices_mm)
    for (std::size_t axis = 0; axis < 3; ++axis) vertex[axis] += by[axis];
  return mesh;
}

FaceMesh ball() {
  return sample_reader::merged_mesh(discmc::reference::ball({14, 14, 14}, {13, 13, 13}, 30),
                                    discmc::meshing::Faces::triangles);
}

}  // namespace

TEST_CASE(
    "the distance to a triangle is measured to its interior, nearest side or nearest corner") {
  const std::array<Point, 3> triangle = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  CHECK(squared_distance({1, 1, 3}, triangle) == doctest::Approx(9));
  CHECK(squared_distance({1, 1, 0}, triangle) == doctest::Approx(0));
  CHECK(squared_distance({2, -2, 1}, triangle) == doctest::Approx(5));
  CHECK(squared_distance({4, 4, 0}, triangle) == doctest::Approx(8));
  CHECK(squared_distance({-3, -4, 0}, triangle) == doctest::Approx(25));
  CHECK(squared_distance({7, -4, 0}, triangle) == doctest::Approx(25));
  // Beyond an obtuse corner, which is the nearest point of two sides.
  CHECK(squared_distance({-3, -1, 0}, {{{0, 0, 0}, {9, 0, 0}, {-8, 1, 0}}}) ==
        doctest::Approx(121.0 / 65));
  CHECK(squared_distance({1, 1, 0}, {{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}}) == doctest::Approx(1));
  CHECK(squared_distance({3, 4, 0}, {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}) == doctest::Approx(25));
}

TEST_CASE("the distance between equal meshes is 0, and between shifted squares the shift") {
  const Distances none = distances(ball(), ball());
  CHECK(none.largest < 1e-7);
  const Distances lifted = distances(square(10, 0), square(10, 0.25));
  CHECK(lifted.mean == doctest::Approx(0.25));
  CHECK(lifted.percentile_99 == doctest::Approx(0.25));
  CHECK(lifted.largest == doctest::Approx(0.25));
}

TEST_CASE("the distance from one mesh to another may differ from that in the other direction") {
  // A quarter of the large square lies below the small one.
  const Distances small_to_large = distances(square(10, 0), square(20, 0));
  CHECK(small_to_large.largest < 1e-9);
  const Distances large_to_small = distances(square(20, 0), square(10, 0));
  CHECK(large_to_small.largest == doctest::Approx(std::sqrt(200)));
  // Half of the area is to the side, 5 away on average; a quarter is beyond the corner.
  const double beyond_corner = 10 * (std::sqrt(2) + std::asinh(1)) / 3;
  CHECK(large_to_small.mean == doctest::Approx(0.5 * 5 + 0.25 * beyond_corner).epsilon(0.001));
  CHECK(large_to_small.percentile_99 < large_to_small.largest);
  CHECK(large_to_small.percentile_99 > 12);
}

TEST_CASE("distances between meshes are scaled by the unit of each axis") {
  const Distances in_voxels = distances(square(10, 0), square(10, 3), {1, 1, 2});
  CHECK(in_voxels.mean == doctest::Approx(1.5));
}

TEST_CASE("the search for the nearest triangle succeeds from any position") {
  const FaceMesh to = ball();
  discmc::test::Chance chance(9);
  for (int i = 0; i < 30; ++i) {
    Point by{};
    for (double& coordinate : by) coordinate = chance.below(2000) / 100.0 - 10;
    FaceMesh from = moved(square(0.01, 0), by);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t face = 0; face < to.face_count(); ++face)
      nearest = std::min(nearest,
                         squared_distance(from.vertices_mm[0], {to.vertices_mm[to.face(face)[0]],
                                                                to.vertices_mm[to.face(face)[1]],
                                                                to.vertices_mm[to.face(face)[2]]}));
    CHECK(distances(from, to, {1, 1, 1}, {}, 10).largest ==
          doctest::Approx(std::sqrt(nearest)).epsilon(0.02));
  }
}

TEST_CASE("measuring distances reports progress up to the number of points") {
  std::size_t last = 0;
  std::size_t calls = 0;
  const auto progress = [&](std::size_t done, std::size_t all) {
    CHECK(done > last);
    CHECK(all == 5000 + 6);
    last = done;
    ++calls;
  };
  distances(square(1, 0), square(1, 0.5), {1, 1, 1}, progress, 5000);
  CHECK(last == 5000 + 6);
  CHECK(calls > 3);
}

TEST_CASE(
    "the largest distance between meshes includes the vertices, not only points within faces") {
  FaceMesh spike = square(1, 0);
  spike.vertices_mm.push_back({0.5, 0.5, 7});
  spike.corners.insert(spike.corners.end(), {0, 4, 1});
  spike.face_begin.push_back(spike.corners.size());
  CHECK(distances(spike, square(1, 0), {1, 1, 1}, {}, 10).largest == doctest::Approx(7));
}

TEST_CASE("a mesh without faces or without area has no distance") {
  CHECK_THROWS_AS(distances(FaceMesh{}, square(1, 0)), std::invalid_argument);
  CHECK_THROWS_AS(distances(square(1, 0), FaceMesh{}), std::invalid_argument);
  CHECK_THROWS_AS(distances(square(0, 0), square(1, 0)), std::invalid_argument);
}
