// Merged polygons with vertices moved to the crossings of the samples.
#include "command.hpp"
#include "meshes/point_distance.hpp"
#include "sampled_field.hpp"

namespace {

using namespace sampled_field;
using command_tests::volume_of;

double distance_to(const FileMesh& mesh, const Point& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    std::array<Point, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = mesh.vertices_mm[mesh.face(face)[i]];
    nearest = std::min(nearest, squared_distance(point, triangle));
  }
  return std::sqrt(nearest);
}

// The maximum distance of a crossing of the samples from the mesh.
double farthest_crossing(const Field& field, const FileMesh& mesh) {
  double farthest = 0;
  for (const Point& vertex : classic(field).vertices_mm)
    farthest = std::max(farthest, distance_to(mesh, vertex));
  return farthest;
}

// One voxel thick, with terraces, mostly just above the threshold: two sheets, very close.
Field plate(std::uint32_t seed) {
  discmc::test::Chance chance(seed);
  return field_of({20, 20, 8}, [&](double x, double, double z) {
    if (z != std::floor(4 - x / 8) + 2) return chance.below(40);
    return 50 + chance.below(4) * (chance.below(4) == 0 ? 10 : 1);
  });
}

// Joins up to three polygons of each plane to one with several outer rings, as an invalid stream
// may have them.
Surface joined_in_planes(const Surface& surface) {
  std::map<std::pair<discmc::Incidence, std::int32_t>, std::vector<std::size_t>> planes;
  for (std::size_t i = 0; i < surface.polygons.size(); ++i) {
    const Polygon polygon = surface.polygons[i];
    const std::int32_t offset = discmc::plane_offset(polygon.incidence, polygon.rings[0][0]);
    planes[{polygon.incidence, offset}].push_back(i);
  }
  Surface joined{surface.spacing_mm, {}};
  for (const auto& [plane, indexes] : planes)
    for (std::size_t i = 0; i < indexes.size(); ++i) {
      if (i % 3 == 0) joined.polygons.add_polygon(plane.first);
      for (const Ring& ring : surface.polygons[indexes[i]].rings) joined.polygons.add_ring(ring);
    }
  return joined;
}

// A crossing next to a voxel keeps a distance from it.
constexpr double margin = Crossings::margin / 2 + 1e-6;

}  // namespace

TEST_CASE("every crossing is within the tolerance of the interpolated mesh") {
  for (const Field& field : {ball(13, 5.3), ball(14, 6, 3), noise({8, 7, 6}, 4)}) {
    const Extracted of = extracted(field);
    std::size_t faces = std::numeric_limits<std::size_t>::max();
    for (const double tolerance : {0.0, 0.02, 0.1, 0.3}) {
      const FileMesh mesh = interpolated(of, tolerance);
      CHECK(farthest_crossing(field, mesh) <= tolerance + margin);
      CHECK(mesh.face_count() <= faces);
      faces = mesh.face_count();
    }
    const FileMesh merged = build_mesh(of.surface, {true, Faces::triangles});
    CHECK(farthest_crossing(field, merged) > 0.2);
    CHECK(faces >= merged.face_count());
    CHECK(interpolated(of, 2).face_count() == merged.face_count());
  }
}

TEST_CASE("an interpolated mesh is closed and faces outside for axes in either direction") {
  for (const Field& field : {ball(14, 5.2), ball(9, 5), noise({9, 8, 7}, 5)})
    for (const Point& spacing : {Point{1, 1, 1}, Point{0.5, -2, 3}, Point{-1, -1, -1}})
      for (const double tolerance : {0.0, 0.05, 0.25, 2.0}) {
        const FileMesh mesh = interpolated(extracted(field, SampleType::u8, spacing), tolerance);
        CHECK(check_mesh(mesh).is_closed());
        CHECK(volume_of(mesh) > 0);
        CHECK(mesh.lattice.size() == mesh.vertices_mm.size());
        CHECK(mesh.polygons.size() == mesh.face_count());
      }
}

TEST_CASE(
    "triangles of an interpolated mesh intersect only where the exact surface intersects itself") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Extracted of = extracted(plate(seed));
    const std::size_t own = crossing_pairs(interpolated(of, 0));
    for (const double tolerance : {0.05, 0.1, 1e300}) {
      const FileMesh mesh = interpolated(of, tolerance);
      CHECK(crossing_pairs(mesh) <= own);
      CHECK(std::set<std::uint32_t>(mesh.corners.begin(), mesh.corners.end()).size() ==
            mesh.vertices_mm.size());
      CHECK(check_mesh(mesh).is_closed());
    }
  }
}

TEST_CASE("an interpolated mesh is closed even if polygons have several outer rings") {
  // In the second plate a new vertex lies on the side of a further outer ring.
  for (const std::uint32_t seed : {0U, 32U}) {
    Extracted of = extracted(plate(seed));
    of.surface = joined_in_planes(of.surface);
    CHECK(check_mesh(interpolated(of, 0.2)).is_closed());
  }
}

TEST_CASE("the mesh of a ball has its volume, with fewer triangles than Marching Cubes") {
  const Field field = ball(40, 16, 4);
  const FileMesh mesh = interpolated(extracted(field), 0.05);
  const double volume = 4.0 / 3 * std::acos(-1.0) * 16 * 16 * 16;
  CHECK(volume_of(mesh) == doctest::Approx(volume).epsilon(0.005));
  CHECK(mesh.face_count() < classic(field).face_count() / 2);
}

TEST_CASE("the interpolated mesh of a linear slope is exact") {
  // Steps of whole samples, so that nothing is rounded.
  const Field field = field_of(
      {12, 10, 9}, [](double x, double y, double z) { return 45 + 2 * x - 2 * y + 8 * (4 - z); });
  const Extracted of = extracted(field);
  const FileMesh mesh = interpolated(of, 1e-4);
  std::size_t on_slope = 0;
  for (const Point& at : mesh.vertices_mm) {
    const bool is_on_wall =
        std::min({at[0], at[1], at[2]}) < 0 || at[0] > 11 || at[1] > 9 || at[2] > 8;
    if (is_on_wall) continue;
    CHECK(45 + 2 * at[0] - 2 * at[1] + 8 * (4 - at[2]) == doctest::Approx(level).epsilon(1e-6));
    ++on_slope;
  }
  CHECK(on_slope > 20);
}

TEST_CASE("interpolation does not move vertices on the walls of the volume") {
  const Extracted of = extracted(ball(9, 6));
  const FileMesh mesh = interpolated(of, 0.05);
  std::size_t on_walls = 0;
  for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
    const std::array<int, 3> lattice = {mesh.lattice[i].x, mesh.lattice[i].y, mesh.lattice[i].z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t across = (axis + 1) % 3, along = (axis + 2) % 3;
      const bool is_on_wall = (lattice[axis] == -1 || lattice[axis] == 17) &&
                              lattice[across] % 2 == 0 && lattice[along] % 2 == 0;
      if (!is_on_wall) continue;
      CHECK(mesh.vertices_mm[i][axis] == lattice[axis] / 2.0);
      ++on_walls;
    }
  }
  CHECK(on_walls > 20);
}

TEST_CASE("an open interpolated surface ends at the border of the volume") {
  const Field field = ball(12, 7);
  const FileMesh mesh =
      interpolated(extracted(field, SampleType::u8, {1, 1, 1}, Border::open), 0.02);
  const MeshReport report = check_mesh(mesh);
  CHECK(report.open_edges > 0);
  CHECK(report.non_manifold_edges + report.wrongly_oriented + report.degenerate_faces == 0);
  for (const Point& at : mesh.vertices_mm)
    for (const double coordinate : at) CHECK((coordinate >= 0 && coordinate <= 11));
}

TEST_CASE("a volume without on voxels has no interpolated surface") {
  const Extracted of = extracted(field_of({3, 3, 3}, [](double, double, double) { return 0; }));
  CHECK(interpolated(of, 0.05).face_count() == 0);
}
