// Meshes with fewer triangles: extract --triangles and --max-error.
#include "meshes/decimation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>

#include "command.hpp"
#include "meshes/mesh_simplifier.hpp"
#include "meshes/surface_distance.hpp"
#include "sampled_field.hpp"
#include "surface/components.hpp"

namespace {

using namespace sampled_field;
using command_tests::contains;
using command_tests::volume_of;

bool lacks_simplifier() {
  try {
    require_simplifier();
    return false;
  } catch (const std::runtime_error&) {
    MESSAGE("no meshoptimizer: meshes are not decimated");
    return true;
  }
}

FileMesh all_triangles(const Field& field, Border border = Border::closed) {
  return interpolated(extracted(field, SampleType::u8, {1, 1, 1}, border), 0);
}

// Smooth, and of many bodies, cavities and handles.
Field cloud(Size size, std::uint32_t seed) {
  const Field rough = noise(size, seed);
  const auto end = [](double at, std::uint32_t extent, int step) {
    return std::clamp(static_cast<int>(at) + step, 0, static_cast<int>(extent) - 1);
  };
  return field_of(size, [&](double x, double y, double z) {
    double sum = 0;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k)
          sum += rough.at(end(x, size.width, i), end(y, size.height, j), end(z, size.depth, k));
    return 50 + 3 * (sum / 27 - 50);
  });
}

// Of their coordinates.
std::set<Point> places(const FileMesh& mesh) {
  return {mesh.vertices_mm.begin(), mesh.vertices_mm.end()};
}

}  // namespace

TEST_CASE("a decimated ball has the triangles that were asked for, and stays a ball") {
  if (lacks_simplifier()) return;
  const FileMesh before = all_triangles(ball(40, 16, 4));
  FileMesh mesh = before;
  const DecimatedBodies bodies = decimate(mesh, {1000});
  CHECK(bodies.all == 1);
  CHECK(bodies.unchanged == 0);
  CHECK(mesh.face_count() <= 1000);
  CHECK(mesh.face_count() > 950);
  CHECK(check_mesh(mesh).closed());
  CHECK(mesh.lattice.size() == mesh.vertices_mm.size());
  CHECK(volume_of(mesh) == doctest::Approx(volume_of(before)).epsilon(0.01));
  CHECK(distances(before, mesh).mean < 0.06);
  const std::set<Point> all = places(before);
  for (const Point& vertex : mesh.vertices_mm) CHECK(all.count(vertex) == 1);
}

TEST_CASE("a larger error leaves fewer triangles, and the smallest that is given ends it") {
  if (lacks_simplifier()) return;
  const FileMesh before = all_triangles(ball(40, 16, 4));
  std::size_t faces = before.face_count();
  for (const double error : {0.01, 0.03, 0.1}) {
    FileMesh mesh = before;
    decimate(mesh, {0, error});
    CHECK(mesh.face_count() < faces);
    CHECK(distances(before, mesh).mean < error);
    faces = mesh.face_count();
  }
  FileMesh mesh = before;
  decimate(mesh, {10, 0.1});
  CHECK(mesh.face_count() == doctest::Approx(static_cast<double>(faces)).epsilon(0.02));
}

TEST_CASE(
    "more triangles than there are change nothing, and an error beyond the body leaves little") {
  if (lacks_simplifier()) return;
  const FileMesh before = all_triangles(ball(40, 16, 4));
  FileMesh mesh = before;
  decimate(mesh, {before.face_count() + 1});
  CHECK(mesh.corners.size() == before.corners.size());
  decimate(mesh, {0, 1000});
  CHECK(mesh.face_count() < 100);
  CHECK(check_mesh(mesh).closed());
}

TEST_CASE("whatever is decimated stays closed, and no body or cavity goes") {
  if (lacks_simplifier()) return;
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const Field field = cloud({24, 24, 24}, seed);
    const Extracted of = extracted(field);
    const std::size_t parts = components(of.surface).size();
    for (const std::uint64_t triangles : {2000U, 6000U}) {
      FileMesh mesh = interpolated(of, 0);
      const std::size_t before = mesh.face_count();
      const DecimatedBodies bodies = decimate(mesh, {triangles});
      CHECK(bodies.all == parts);
      CHECK(check_mesh(mesh).closed());
      CHECK(mesh.face_count() < before);
    }
  }
}

TEST_CASE("a body that would go stays as it was") {
  if (lacks_simplifier()) return;
  Field field = ball(30, 9, 4);
  field.samples[(3 * 30 + 3) * 30 + 3] = 100;
  const FileMesh before = all_triangles(field);
  FileMesh mesh = before;
  const DecimatedBodies bodies = decimate(mesh, {100});
  CHECK(bodies.all == 2);
  CHECK(bodies.unchanged == 1);
  CHECK(check_mesh(mesh).closed());
  const std::set<Point> left = places(mesh);
  for (const Point& vertex : before.vertices_mm)
    if (vertex[0] < 5) CHECK(left.count(vertex) == 1);
}

TEST_CASE("a mesh of many faces without area stays as it was") {
  if (lacks_simplifier()) return;
  FileMesh mesh = all_triangles(ball(40, 16, 4));
  for (Point& vertex : mesh.vertices_mm) vertex[0] = 8 * std::floor(vertex[0] / 8);
  const std::vector<std::uint32_t> corners = mesh.corners;
  const DecimatedBodies bodies = decimate(mesh, {1000, 1});
  CHECK(bodies.unchanged == bodies.all);
  CHECK(mesh.corners == corners);
}

TEST_CASE("the border of an open mesh keeps its edges") {
  if (lacks_simplifier()) return;
  const Field field = field_of({20, 20, 20}, [](double x, double y, double z) {
    return level + 4 * (8 - std::hypot(x - 9.5, y - 9.5, z - 1));
  });
  const FileMesh before = all_triangles(field, Border::open);
  FileMesh mesh = before;
  decimate(mesh, {150});
  CHECK(mesh.face_count() < before.face_count() / 3);
  CHECK(check_mesh(before).open_edges > 0);
  CHECK(check_mesh(mesh).open_edges == check_mesh(before).open_edges);
  CHECK(check_mesh(mesh).non_manifold_edges == 0);
}

TEST_CASE("--triangles and --max-error write decimated meshes, interpolated before") {
  if (lacks_simplifier()) return;
  const command_tests::Workshop workshop;
  std::string bytes;
  for (const int sample : ball(40, 16, 4).samples) bytes += static_cast<char>(sample);
  workshop.write("v.raw", bytes);
  const std::string extract = "extract v.raw --dims 40,40,40 --spacing 1,1,1 --type u8 --iso 50 ";
  const std::string told = workshop.done(extract + "--triangles 1000 --normals gradient -o v.ply");
  CHECK(contains(told, "closed                               yes"));
  const FileMesh mesh = command_tests::mesh_of_ply(workshop.read("v.ply"));
  CHECK(mesh.face_count() <= 1000);
  CHECK(check_mesh(mesh).closed());
  CHECK(mesh.normals.size() == mesh.vertices_mm.size());
  for (const std::string same : {"--triangles 1000 --surface interpolated --tolerance 0"}) {
    workshop.done(extract + same + " --normals gradient -o same.ply");
    CHECK(workshop.read("same.ply") == workshop.read("v.ply"));
  }
  workshop.done(extract + "--triangles 1000 --surface merged --normals surface -o merged.ply");
  CHECK(check_mesh(command_tests::mesh_of_ply(workshop.read("merged.ply"))).closed());
  workshop.done(extract + "--max-error 0.1 -o v.csv");
  workshop.done(
      "extract v.raw --dims 40,40,40 --type u8 --label 50 --allow-empty --triangles 99 "
      "--median 3 -o v.glb");
  std::replace_if(
      bytes.begin(), bytes.end(), [](char c) { return c != 0; }, '\1');
  workshop.write("mask.raw", bytes);
  CHECK(contains(workshop
                     .run("extract mask.raw --dims 40,40,40 --type u8 --iso 1 --triangles 999 "
                          "-o v.ply")
                     .error,
                 "as a mask, so the surface keeps the steps of the voxels; add --smooth auto"));
  CHECK(contains(workshop.run(extract + "--triangles 99 -o v.dmc").error, "not decimated"));
  CHECK(contains(workshop.run(extract + "--triangles 99 --faces polygons -o v.ply").error,
                 "leave out --faces polygons"));
  for (const std::string none : {"3", "4.5", "1e30", "-9"})
    CHECK(contains(workshop.run(extract + "--triangles=" + none + " -o v.ply").error,
                   "invalid value '" + none + "'; expected a whole number from 4"));
  CHECK(contains(workshop.run(extract + "--max-error 0 -o v.ply").error, "above 0"));
}

TEST_CASE("a note about a label that cannot be decimated further has the name of the label") {
  if (lacks_simplifier()) return;
  const command_tests::Workshop workshop;
  std::string bytes(12 * 12 * 12, '\0');
  for (const int at : {2, 5, 8})
    for (const int below : {2, 5, 8}) bytes[static_cast<std::size_t>(at + 12 * below + 720)] = '\3';
  workshop.write("v.raw", bytes);
  workshop.write("table.txt", "3 seeds\n");
  const auto result = workshop.run(
      "extract v.raw --dims 12,12,12 --type u8 --labels all --label-table table.txt --triangles 9 "
      "-o v.glb");
  CHECK(contains(result.error, "v.raw: label 3 (seeds): --triangles 9: "));
}
