// Meshes with fewer triangles: extract --triangles and --max-error.
#include "decimation/decimation.hpp"

#include <stdexcept>

#include "command.hpp"
#include "meshes/mesh_edges.hpp"
#include "meshes/surface_distance.hpp"
#include "sampled_field.hpp"

namespace {

using namespace sampled_field;
using command_tests::contains;
using command_tests::volume_of;
using command_tests::Workshop;

FaceMesh all_triangles(const Field& field, Border border = Border::closed) {
  return interpolated(extracted(field, SampleType::u8, {1, 1, 1}, border), 0);
}

FaceMesh decimated(FaceMesh mesh, const Decimation& decimation) {
  decimate(mesh, decimation);
  return mesh;
}

// A smooth surface with many bodies, cavities and handles.
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

// Two sheets, 2 voxels apart, with many handles.
Field gyroid(std::uint32_t size) {
  return field_of({size, size, size}, [](double x, double y, double z) {
    const double u = x / 2.4, v = y / 2.4, w = z / 2.4;
    return level + 30 * (0.45 - std::fabs(std::sin(u) * std::cos(v) + std::sin(v) * std::cos(w) +
                                          std::sin(w) * std::cos(u)));
  });
}

// The measures of all bodies and cavities, the smallest first.
std::vector<double> volumes_of(const FaceMesh& mesh) {
  Sets pieces = connected_faces(sorted_edges(mesh), mesh.face_count());
  std::map<std::uint32_t, double> volumes;
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    const std::uint32_t* const corners = mesh.face(face);
    const auto at = [&](std::size_t i) { return mesh.vertices_mm[corners[i]]; };
    volumes[pieces.root(face)] += dot(at(0), cross(at(1), at(2))) / 6;
  }
  std::vector<double> sorted;
  for (const auto& each : volumes) sorted.push_back(each.second);
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

void check_bodies(const FaceMesh& before, const FaceMesh& after) {
  const std::vector<double> expected = volumes_of(before), found = volumes_of(after);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(std::fabs(found[i] - expected[i]) < 1e-5 * std::fabs(expected[i]) + 1e-4);
}

}  // namespace

TEST_CASE(
    "a ball decimated to --triangles has that number of triangles and keeps its volume and shape") {
  const FaceMesh before = all_triangles(ball(40, 16, 4));
  const FaceMesh mesh = decimated(before, {1000});
  CHECK(mesh.face_count() == 1000);
  CHECK(check_mesh(mesh).is_closed());
  CHECK(crossing_pairs(mesh) == 0);
  CHECK(mesh.lattice.size() == mesh.vertices_mm.size());
  CHECK(volume_of(mesh) == doctest::Approx(volume_of(before)).epsilon(1e-6));
  CHECK(distances(before, mesh).mean < 0.025);
  CHECK(distances(before, mesh).largest < 0.2);
}

TEST_CASE("a larger --max-error never leaves more triangles, and bounds the distance both ways") {
  struct Bounded {
    Field field;
    double bound;  // in units of --max-error: the measured distance uses samples, not all points
  };
  const Bounded fields[] = {
      {ball(24, 9, 4), 2.5}, {gyroid(16), 2.5}, {cloud({13, 13, 13}, 5), 3.0}};
  for (const auto& [field, bound] : fields) {
    const FaceMesh before = all_triangles(field);
    std::size_t faces = before.face_count();
    for (const double error : {0.02, 0.05, 0.07, 0.1, 0.15, 0.3, 0.5, 0.8, 1.5, 3.0, 1e9}) {
      const FaceMesh mesh = decimated(before, {0, error});
      CHECK(mesh.face_count() <= faces);
      CHECK(check_mesh(mesh).is_closed());
      faces = mesh.face_count();
      if (error > 0.5) continue;
      CAPTURE(error);
      CHECK(distances(before, mesh).largest < bound * error);
      CHECK(distances(mesh, before).largest < bound * error);
    }
    CHECK(faces < before.face_count() / 10);
  }
}

TEST_CASE(
    "--triangles is met within one triangle, and fewer triangles lie farther from the surface") {
  const FaceMesh before = all_triangles(gyroid(24));
  double mean = 0;
  for (const std::uint64_t triangles : {8000U, 4000U, 2001U, 1000U, 600U}) {
    const FaceMesh mesh = decimated(before, {triangles});
    CHECK(mesh.face_count() <= triangles);
    CHECK(mesh.face_count() + 1 >= triangles);
    CHECK(crossing_pairs(mesh) == 0);
    CHECK(distances(before, mesh).mean > mean);
    mean = distances(before, mesh).mean;
  }
}

TEST_CASE("--triangles or --max-error, whichever is reached first, ends the decimation") {
  const FaceMesh before = all_triangles(ball(40, 16, 4));
  const std::size_t by_error = decimated(before, {0, 0.1}).face_count();
  CHECK(decimated(before, {10, 0.1}).face_count() == by_error);
  CHECK(decimated(before, {2 * by_error, 0.1}).face_count() == 2 * by_error);
  CHECK(decimated(before, {before.face_count() + 1}).corners == before.corners);
}

TEST_CASE("a decimated mesh stays closed and free of crossings, and each body keeps its volume") {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    const FaceMesh before = all_triangles(cloud({24, 24, 24}, seed));
    for (const std::uint64_t triangles : {1U, 1000U, 3000U}) {
      const FaceMesh mesh = decimated(before, {triangles});
      CHECK(check_mesh(mesh).is_closed());
      CHECK(crossing_pairs(mesh) <= crossing_pairs(before));
      check_bodies(before, mesh);
      CHECK(mesh.face_count() < before.face_count() / 4);
    }
  }
}

TEST_CASE("decimating a body to few triangles keeps a small body beside it") {
  Field field = ball(30, 9, 4);
  field.samples[(3 * 30 + 3) * 30 + 3] = 100;
  const FaceMesh before = all_triangles(field);
  const FaceMesh mesh = decimated(before, {4});
  CHECK(mesh.face_count() <= 2 * 8);
  check_bodies(before, mesh);
}

TEST_CASE("a decimated large body does not enclose a small body beside it") {
  Field field = ball(40, 14, 4);
  const auto outside = [](double x, double y, double z) {
    return std::hypot(x - 19.5, y - 19.5, z - 19.5);
  };
  for (const int x : {4, 35})
    field.samples[static_cast<std::size_t>((19 * 40 + 19) * 40 + x)] = 100;
  const FaceMesh before = all_triangles(field);
  const FaceMesh mesh = decimated(before, {20});
  CHECK(crossing_pairs(mesh) == 0);
  check_bodies(before, mesh);
  // Each small body is fully visible from the middle of the large one, and a ray crosses the large
  // one once.
  for (const Point& vertex : mesh.vertices_mm) {
    if (outside(vertex[0], vertex[1], vertex[2]) < 14.9 || std::fabs(vertex[1] - 19) > 1) continue;
    double angle = 0;
    for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
      std::array<Point, 3> to;
      std::array<double, 3> length;
      bool is_its_own = false;
      for (std::size_t i = 0; i < 3; ++i) {
        to[i] = difference(mesh.vertices_mm[mesh.face(face)[i]], vertex);
        length[i] = std::hypot(to[i][0], to[i][1], to[i][2]);
        is_its_own |= length[i] < 2;
      }
      if (is_its_own) continue;
      angle += 2 * std::atan2(dot(to[0], cross(to[1], to[2])),
                              length[0] * length[1] * length[2] + dot(to[0], to[1]) * length[2] +
                                  dot(to[1], to[2]) * length[0] + dot(to[2], to[0]) * length[1]);
    }
    CHECK(std::fabs(angle) < 1);
  }
}

TEST_CASE("the long thin triangles of a merged surface are decimated without crossings") {
  for (const Field& field : {ball(40, 18, 4), gyroid(24)}) {
    const FaceMesh before = build_mesh(extracted(field).surface, {true, Faces::triangles});
    const FaceMesh mesh = decimated(before, {400});
    CHECK(mesh.face_count() <= 400);
    CHECK(mesh.face_count() >= 399);
    CHECK(check_mesh(mesh).is_closed());
    CHECK(crossing_pairs(mesh) == 0);
    check_bodies(before, mesh);
  }
}

TEST_CASE("faces without area are removed, and the mesh stays closed") {
  FaceMesh mesh = all_triangles(ball(40, 16, 4));
  for (Point& vertex : mesh.vertices_mm) vertex[0] = 8 * std::floor(vertex[0] / 8);
  const std::size_t before = mesh.face_count();
  decimate(mesh, {1000});
  CHECK(mesh.face_count() < before);
  const MeshReport report = check_mesh(mesh);
  CHECK(report.open_edges + report.non_manifold_edges + report.wrongly_oriented == 0);
}

TEST_CASE("a plane border stays plane, open and manifold, with fewer edges") {
  const Field field = field_of({20, 20, 20}, [](double x, double y, double z) {
    return level + 4 * (8 - std::hypot(x - 9.5, y - 9.5, z - 1));
  });
  const FaceMesh before = all_triangles(field, Border::open);
  const FaceMesh mesh = decimated(before, {150});
  CHECK(mesh.face_count() <= 150);
  CHECK(mesh.face_count() >= 148);
  const std::vector<FaceEdge> edges = sorted_edges(mesh);
  for_each_edge(edges, [&](const FaceEdge* uses, std::size_t count) {
    CHECK(count <= 2);
    if (count == 2) return;
    CHECK(mesh.vertices_mm[uses->low][2] == 0);
    CHECK(mesh.vertices_mm[uses->high][2] == 0);
  });
  CHECK(check_mesh(mesh).open_edges > 6);
  CHECK(check_mesh(mesh).open_edges < check_mesh(before).open_edges);
  CHECK(distances(before, mesh).largest < 0.6);
}

TEST_CASE("decimation does not depend on the unit, and ends when a check throws") {
  const Extracted in_mm = extracted(ball(24, 9, 4));
  const Extracted in_metres = extracted(ball(24, 9, 4), SampleType::u8, {1e-6, 1e-6, 1e-6});
  const FaceMesh mesh = decimated(interpolated(in_mm, 0), {200});
  const FaceMesh small = decimated(interpolated(in_metres, 0), {200});
  CHECK(small.face_count() == mesh.face_count());
  CHECK(volume_of(small) == doctest::Approx(1e-18 * volume_of(mesh)).epsilon(1e-4));
  FaceMesh stopped = all_triangles(gyroid(24));
  CHECK_THROWS_AS(decimate(stopped, {100}, [] { throw std::runtime_error("stop"); }),
                  std::runtime_error);
}

TEST_CASE_FIXTURE(Workshop, "--triangles and --max-error write decimated meshes") {
  std::string bytes;
  for (const int sample : ball(40, 16, 4).samples) bytes += static_cast<char>(sample);
  write("v.raw", bytes);
  const std::string extract = "extract v.raw --dims 40,40,40 --spacing 1,1,1 --type u8 --iso 50 ";
  const std::string output = done(extract + "--triangles 1000 --normals gradient -o v.ply");
  CHECK(contains(output, "closed                               yes"));
  const FileMesh mesh = mesh_in("v.ply");
  CHECK(mesh.face_count() <= 1000);
  CHECK(check_mesh(mesh).is_closed());
  CHECK(mesh.normals.size() == mesh.vertices_mm.size());
  done(extract +
       "--triangles 1000 --surface interpolated --tolerance 0 --normals gradient -o same.ply");
  CHECK(read("same.ply") == read("v.ply"));
  done(extract + "--triangles 1000 --surface merged --normals surface -o merged.ply");
  CHECK(check_mesh(mesh_in("merged.ply")).is_closed());
  done(extract + "--max-error 0.1 -o v.csv");
  done(
      "extract v.raw --dims 40,40,40 --type u8 --label 50 --allow-empty --triangles 99 "
      "--median 3 -o v.glb");
  std::replace_if(
      bytes.begin(), bytes.end(), [](char c) { return c != 0; }, '\1');
  write("mask.raw", bytes);
  CHECK(contains(run("extract mask.raw --dims 40,40,40 --type u8 --iso 1 --triangles 999 "
                     "-o v.ply")
                     .error,
                 "as a mask, so the surface keeps the steps of the voxels; add --smooth auto"));
  CHECK(contains(run(extract + "--triangles 99 -o v.dmc").error, "not decimated"));
  CHECK(contains(run(extract + "--triangles 99 --faces polygons -o v.ply").error,
                 "leave out --faces polygons"));
  for (const std::string none : {"3", "4.5", "1e30", "-9"})
    CHECK(contains(run(extract + "--triangles=" + none + " -o v.ply").error,
                   "invalid value '" + none + "'; expected a whole number from 4"));
  CHECK(contains(run(extract + "--max-error 0 -o v.ply").error, "above 0"));
}

TEST_CASE_FIXTURE(Workshop,
                  "the note about a label with more triangles than --triangles names the label") {
  std::string bytes(12 * 12 * 12, '\0');
  for (const int at : {2, 5, 8})
    for (const int below : {2, 5, 8}) bytes[static_cast<std::size_t>(at + 12 * below + 720)] = '\3';
  write("v.raw", bytes);
  write("table.txt", "3 seeds\n");
  const auto result = run(
      "extract v.raw --dims 12,12,12 --type u8 --labels all --label-table table.txt --triangles 9 "
      "-o v.glb");
  CHECK(contains(result.error, "v.raw: label 3 (seeds): --triangles 9: the mesh has "));
  CHECK(contains(result.error, "bodies or openings would be lost"));
}
