// Thin triangles of a mesh, replaced by rounder ones.
#include "meshes/slivers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "command.hpp"
#include "meshes/decimation.hpp"
#include "meshes/mesh_simplifier.hpp"
#include "sampled_field.hpp"

namespace {

using namespace sampled_field;
using command_tests::volume_of;

// With an angle below 5 degrees.
std::size_t thin_faces(const FileMesh& mesh) {
  std::size_t count = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    double cosine = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& at = mesh.vertices_mm[mesh.face(face)[i]];
      cosine = std::max(
          cosine,
          dot(unit_or_zero(difference(mesh.vertices_mm[mesh.face(face)[(i + 1) % 3]], at)),
              unit_or_zero(difference(mesh.vertices_mm[mesh.face(face)[(i + 2) % 3]], at))));
    }
    count += cosine > 0.9962 ? 1U : 0U;
  }
  return count;
}

FileMesh mesh_of(const std::vector<Point>& vertices, const std::vector<std::uint32_t>& corners) {
  FileMesh mesh;
  mesh.vertices_mm = vertices;
  mesh.corners = corners;
  for (std::size_t end = 3; end <= corners.size(); end += 3) mesh.face_begin.push_back(end);
  return mesh;
}

// Two triangles with the edge from x = 0 to x = 10, a thin one with the corner c and another one.
FileMesh cap(const Point& d = {5, -8, 0}, const Point& c = {5, 0.1, 0}) {
  return mesh_of({{0, 0, 0}, {10, 0, 0}, c, d}, {0, 1, 2, 1, 0, 3});
}

FileMesh rough_ball() {
  return interpolated(extracted(ball(40, 16, 30), SampleType::u8, {1, 1, 1}), 0);
}

}  // namespace

TEST_CASE("the longest edge of a thin triangle is flipped") {
  FileMesh mesh = cap();
  remove_slivers(mesh, 0, 0.01);
  CHECK(thin_faces(cap()) == 1);
  CHECK(thin_faces(mesh) == 0);
  CHECK(mesh.face_count() == 2);
  CHECK(check_mesh(mesh).open_edges == 4);
}

TEST_CASE("an edge stays if the surface would move or turn too much, or if it is of a first face") {
  const auto stays = [](const FileMesh& before, std::size_t first_faces, double distance) {
    FileMesh mesh = before;
    remove_slivers(mesh, first_faces, distance);
    return mesh.corners == before.corners;
  };
  CHECK_FALSE(stays(cap({5, -8, 4}), 0, 0.1));
  CHECK(stays(cap({5, -8, 4}), 0, 0.02));
  CHECK(stays(cap(), 1, 0.02));
  CHECK(stays(cap({11, -0.5, 0}, {9.9, 0.1, 0}), 0, 100));
}

TEST_CASE("an edge stays if its flip would be one that there is already") {
  const FileMesh tetrahedron = mesh_of({{0, 0, 0}, {10, 0, 0}, {5, 0.3, 0}, {5, -8, 1}},
                                       {0, 1, 2, 1, 0, 3, 0, 2, 3, 2, 1, 3});
  FileMesh mesh = tetrahedron;
  remove_slivers(mesh, 0, 10);
  CHECK(check_mesh(tetrahedron).closed());
  CHECK(mesh.corners == tetrahedron.corners);
}

TEST_CASE("short edges are collapsed, and the mesh stays closed") {
  FileMesh mesh = rough_ball();
  const std::size_t thin = thin_faces(mesh), faces = mesh.face_count();
  const double volume = volume_of(mesh);
  REQUIRE(thin > 20);
  remove_slivers(mesh, 0, 0.2);
  CHECK(mesh.face_count() < faces);
  CHECK(thin_faces(mesh) < thin / 4);
  CHECK(check_mesh(mesh).closed());
  CHECK(volume_of(mesh) == doctest::Approx(volume).epsilon(0.001));
}

TEST_CASE("a decimated mesh has hardly any thin triangles") {
  try {
    require_simplifier();
  } catch (const std::runtime_error&) {
    return;
  }
  FileMesh mesh = interpolated(extracted(field_of({60, 60, 12},
                                                  [](double x, double y, double z) {
                                                    return level + 30 * (2.1 + std::sin(x / 9) +
                                                                         std::cos(y / 11) / 2 -
                                                                         std::abs(z - 5.37));
                                                  })),
                               0);
  decimate(mesh, {mesh.face_count() / 3});
  CHECK(thin_faces(mesh) < mesh.face_count() / 40);
}

TEST_CASE("rough meshes of many handles stay closed, however far the surface may move") {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    FileMesh mesh = interpolated(extracted(noise({12, 12, 12}, seed)), 0);
    const std::size_t thin = thin_faces(mesh);
    const bool is_closed = check_mesh(mesh).degenerate_faces == 0;
    remove_slivers(mesh, 0, 10);
    const MeshReport report = check_mesh(mesh);
    CHECK(report.open_edges + report.non_manifold_edges + report.wrongly_oriented == 0);
    CHECK((!is_closed || report.degenerate_faces == 0));
    CHECK(thin_faces(mesh) < thin);
  }
}
