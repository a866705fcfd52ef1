#include "meshes/surface_normals.hpp"

#include "hand_made.hpp"
#include "oracle/angle.hpp"
#include "sampled_field.hpp"
#include "test.hpp"

namespace {

using namespace discmc::meshing;
using namespace hand_made;
using discmc::reference::ball;
using discmc::reference::degrees_between;
using sample_reader::merged_mesh;

void check_near(const Point& a, const Point& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(std::abs(a[axis] - b[axis]) < 1e-12);
}

// Every face has its own vertices, as in an STL file.
FaceMesh soup_of(const FaceMesh& mesh) {
  FaceMesh soup = mesh;
  soup.vertices_mm.clear();
  for (std::uint32_t& corner : soup.corners) {
    soup.vertices_mm.push_back(mesh.vertices_mm[corner]);
    corner = static_cast<std::uint32_t>(soup.vertices_mm.size() - 1);
  }
  return soup;
}

}  // namespace

TEST_CASE("surface normals of an octahedron are its axes in both directions") {
  for (const double x : {0.5, -0.5})
    for (const double y : {1.0, -1.0})
      for (const double z : {3.0, -3.0}) {
        const FaceMesh mesh = build_mesh(octahedron({x, y, z}), {true, Faces::triangles});
        const std::vector<Point> normals = surface_normals(mesh);
        REQUIRE(normals.size() == 6);
        for (std::size_t i = 0; i < 6; ++i)
          check_near(normals[i], unit_or_zero(mesh.vertices_mm[i]));
      }
}

TEST_CASE("surface normals of a ball are close to its radii for any spacing and mirroring") {
  const auto volume = ball({50, 50, 50}, {49, 49, 49}, 400);
  for (const Point& spacing : {Point{1, 1, 1}, {-1, 1, 1}, {1, -1, -1}, {0.8, -1.2, 1}}) {
    const FaceMesh mesh = merged_mesh(volume, Faces::triangles, spacing);
    const std::vector<Point> normals = surface_normals(mesh);
    double sum = 0, worst = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      Point radius{};  // of the ellipsoid: a normal scales by the inverse of the spacing
      for (std::size_t axis = 0; axis < 3; ++axis)
        radius[axis] = (mesh.vertices_mm[i][axis] / spacing[axis] - 24.5) / spacing[axis];
      const double angle = degrees_between(radius, normals[i]);
      sum += angle;
      worst = std::max(worst, angle);
    }
    CHECK(sum / static_cast<double>(normals.size()) < 10);
    CHECK(worst < 25);
  }
}

TEST_CASE("surface normals of an interpolated ball deviate at most 3 degrees from its radii") {
  struct Expected {
    Point spacing;
    double degrees;
  };
  for (const auto& [spacing, degrees] : {Expected{{1, 1, 1}, 1.5}, Expected{{0.5, 0.7, 2}, 3}}) {
    const double radius = 20;
    const discmc::reference::Size size = {static_cast<std::uint32_t>(48 / spacing[0]),
                                          static_cast<std::uint32_t>(48 / spacing[1]),
                                          static_cast<std::uint32_t>(48 / spacing[2])};
    const Point middle = {(size.width - 1) / 2.0, (size.height - 1) / 2.0, (size.depth - 1) / 2.0};
    const Point mm = spacing;
    const sampled_field::Field field =
        sampled_field::field_of(size, [&](double x, double y, double z) {
          return 49.5 + 8 * (radius - std::hypot((x - middle[0]) * mm[0], (y - middle[1]) * mm[1],
                                                 (z - middle[2]) * mm[2]));
        });
    const FaceMesh mesh =
        sampled_field::interpolated(sampled_field::extracted(field, SampleType::u8, spacing), 0.05);
    const std::vector<Point> normals = surface_normals(mesh);
    double sum = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Point& at = mesh.vertices_mm[i];
      sum += degrees_between(
          {at[0] - middle[0] * mm[0], at[1] - middle[1] * mm[1], at[2] - middle[2] * mm[2]},
          normals[i]);
    }
    CHECK(sum / static_cast<double>(normals.size()) < degrees);
  }
}

TEST_CASE("surface normals do not depend on the triangulation of a flat part") {
  // A roof: one square leans to the left, one to the right.
  const FaceMesh mesh =
      triangles_of({{-1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 1}, {1, 1, 0}},
                   {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4});
  FaceMesh other = mesh;
  other.corners = {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4};
  const std::vector<Point> normals = surface_normals(mesh), of_other = surface_normals(other);
  for (std::size_t i = 0; i < normals.size(); ++i) check_near(normals[i], of_other[i]);
  check_near(normals[1], {0, 0, 1});
}

TEST_CASE("vertices at equal positions have equal surface normals") {
  const FaceMesh mesh = build_mesh(leaning_wall(), {true, Faces::triangles});
  const std::vector<Point> expected = surface_normals(mesh);
  const std::vector<Point> normals = surface_normals(soup_of(mesh));
  REQUIRE(normals.size() == mesh.corners.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    check_near(normals[i], expected[mesh.corners[i]]);
}

TEST_CASE("surface normals weight each triangle by its angle, not by its area") {
  // The floor is nine times as long as the wall. They meet in the edge from (0,0,0) to (0,1,0).
  const std::vector<Point> normals = surface_normals(
      triangles_of({{0, 0, 0}, {9, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 0, 2, 3}));
  check_near(normals[0], unit_or_zero({1, 0, 1}));
  check_near(normals[1], {0, 0, 1});
  check_near(normals[3], {1, 0, 0});
}

TEST_CASE("a vertex without faces, or with normals that cancel, has no normal") {
  const FaceMesh mesh =
      triangles_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {0, 1, 2, 0, 2, 1});
  for (const Point& normal : surface_normals(mesh)) CHECK(normal == Point{});
}
