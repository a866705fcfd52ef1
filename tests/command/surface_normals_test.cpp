#include "meshes/surface_normals.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "hand_made.hpp"
#include "sample_reader.hpp"

namespace {

using namespace discmc::command;
using namespace hand_made;
using discmc::reference::ball;
using sample_reader::merged_mesh;

const Faces both_kinds[] = {Faces::polygons, Faces::triangles};

double degrees_between(const Point& a, const Point& b) {
  const double cosine = dot(unit_or_zero(a), unit_or_zero(b));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::acos(-1.0);
}

void check_near(const Point& a, const Point& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) CHECK(std::abs(a[axis] - b[axis]) < 1e-12);
}

// Every face with corners of its own, as an STL file has them.
Mesh soup_of(const Mesh& mesh) {
  Mesh soup = mesh;
  soup.vertices_mm.clear();
  for (std::uint32_t& corner : soup.corners) {
    soup.vertices_mm.push_back(mesh.vertices_mm[corner]);
    corner = static_cast<std::uint32_t>(soup.vertices_mm.size() - 1);
  }
  return soup;
}

}  // namespace

TEST_CASE("the normals of an octahedron are its axes, whichever way they run") {
  for (const double x : {0.5, -0.5})
    for (const double y : {1.0, -1.0})
      for (const double z : {3.0, -3.0}) {
        const Mesh mesh = build_mesh(octahedron({x, y, z}));
        const std::vector<Point> normals = surface_normals(mesh);
        REQUIRE(normals.size() == 6);
        for (std::size_t i = 0; i < 6; ++i)
          check_near(normals[i], unit_or_zero(mesh.vertices_mm[i]));
      }
}

TEST_CASE("the normals of a ball are near its radii, however it is stretched and mirrored") {
  const auto volume = ball({50, 50, 50}, {49, 49, 49}, 400);
  for (const Point& spacing : {Point{1, 1, 1}, {-1, 1, 1}, {1, -1, -1}, {0.8, -1.2, 1}}) {
    const Mesh mesh = merged_mesh(volume, Faces::polygons, spacing);
    const std::vector<Point> normals = surface_normals(mesh);
    double sum = 0, worst = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      Point radius{};  // of the ellipsoid: a plane's normal goes by the inverse of the spacing
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

TEST_CASE("normals depend on polygons and not on how these are cut into triangles") {
  const auto volume = discmc::reference::torus({30, 30, 12}, 20, 7);
  const Mesh whole = merged_mesh(volume, Faces::polygons);
  const Mesh cut = merged_mesh(volume, Faces::triangles);
  std::map<Point, Point> expected;
  const std::vector<Point> of_whole = surface_normals(whole), of_cut = surface_normals(cut);
  for (std::size_t i = 0; i < of_whole.size(); ++i) expected[whole.vertices_mm[i]] = of_whole[i];
  REQUIRE(of_cut.size() == expected.size());
  for (std::size_t i = 0; i < of_cut.size(); ++i)
    check_near(of_cut[i], expected.at(cut.vertices_mm[i]));
}

TEST_CASE("vertices at equal positions have one normal") {
  for (const Faces faces : both_kinds) {
    const Mesh mesh = build_mesh(leaning_wall(), {true, faces});
    const std::vector<Point> expected = surface_normals(mesh);
    const std::vector<Point> normals = surface_normals(soup_of(mesh));
    REQUIRE(normals.size() == mesh.corners.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
      check_near(normals[i], expected[mesh.corners[i]]);
  }
}

TEST_CASE("a large polygon outweighs a small one, and by less than its area") {
  // A floor nine times as large as the wall that it meets in the edge from (0,0,0) to (0,1,0).
  Mesh mesh;
  mesh.vertices_mm = {{0, 0, 0}, {9, 0, 0}, {9, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}};
  mesh.corners = {0, 1, 2, 3, 0, 3, 5, 4};
  mesh.face_begin = {0, 4, 8};
  mesh.polygons = {0, 1};
  const std::vector<Point> normals = surface_normals(mesh);
  check_near(normals[0], unit_or_zero({1, 0, 3}));
  check_near(normals[1], {0, 0, 1});
  check_near(normals[4], {1, 0, 0});
}

TEST_CASE("there is no normal where no face is, or where two of them cancel each other out") {
  Mesh mesh;
  mesh.vertices_mm = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
  mesh.corners = {0, 1, 2, 0, 2, 1};
  mesh.face_begin = {0, 3, 6};
  mesh.polygons = {0, 1};
  for (const Point& normal : surface_normals(mesh)) CHECK(normal == Point{});
}
