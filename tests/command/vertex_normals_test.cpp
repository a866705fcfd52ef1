// Normals of merged meshes, computed from their polygons or from the samples.
#include "meshes/vertex_normals.hpp"

#include "hand_made.hpp"
#include "normal_angles.hpp"
#include "oracle/ramp_ball.hpp"
#include "oracle/stream.hpp"
#include "sample_reader.hpp"
#include "test.hpp"

namespace {

using namespace discmc::meshing;
using namespace hand_made;
using namespace normal_angles;
using discmc::reference::gradient;
using discmc::reference::ramp_ball;
using discmc::reference::Size;
using discmc::test::Chance;
using sample_reader::SampleReader;

// The tested spacings: axes in both directions, and anisotropic voxels.
const std::vector<Point> all_signs = [] {
  std::vector<Point> result;
  for (const double x : {0.5, -0.5})
    for (const double y : {1.25, -1.25})
      for (const double z : {3.0, -3.0}) result.push_back({x, y, z});
  return result;
}();

SampleVolume<int> noise(Size size, int least, int most, Chance& chance) {
  SampleVolume<int> volume{size, {}};
  for (std::size_t i = 0; i < std::size_t{size.width} * size.height * size.depth; ++i)
    volume.samples.push_back(
        least + static_cast<int>(chance.next() % static_cast<std::uint64_t>(most - least)));
  return volume;
}

Surface polygons_of(const SampleVolume<int>& volume, int threshold, const Point& spacing_mm,
                    SampleType type = SampleType::u8) {
  SampleReader reader(volume.size, volume.samples, spacing_mm, type);
  return surface_of(reader, threshold);
}

void set_gradient_normals_of(const SampleVolume<int>& volume, SampleType type, FaceMesh& mesh) {
  SampleReader reader(volume.size, volume.samples, mesh.spacing_mm, type);
  set_gradient_normals(reader, mesh);
}

// A polygon's area vector, computed from its rings in space. Units: square millimetres.
Point area_in_space(const Polygon& polygon, const Point& spacing_mm) {
  const auto in_space = [&](const Vertex& v) {
    return Point{v.x * spacing_mm[0] / 2, v.y * spacing_mm[1] / 2, v.z * spacing_mm[2] / 2};
  };
  Point sum{};
  for (const Ring& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point area = cross(in_space(ring[i]), in_space(ring[(i + 1) % ring.size()]));
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += area[axis] / 2;
    }
  const bool is_mirrored = spacing_mm[0] * spacing_mm[1] * spacing_mm[2] < 0;
  return is_mirrored ? Point{-sum[0], -sum[1], -sum[2]} : sum;
}

std::size_t vertex_at(const FaceMesh& mesh, const Vertex& position) {
  const auto found = std::find(mesh.lattice.begin(), mesh.lattice.end(), position);
  REQUIRE(found != mesh.lattice.end());
  return static_cast<std::size_t>(found - mesh.lattice.begin());
}

void check_along(const Point& normal, const Point& direction) {
  CHECK(degrees_between(normal, direction) < 0.006);
  CHECK(std::hypot(normal[0], normal[1], normal[2]) == doctest::Approx(1).epsilon(1e-4));
}

}  // namespace

TEST_CASE("the vertices of a mesh keep their lattice positions") {
  for (const bool is_conforming : {true, false}) {
    const FaceMesh mesh =
        build_mesh(box_with_hole({0.5, -2, 3}), {is_conforming, Faces::triangles});
    REQUIRE(mesh.lattice.size() == mesh.vertices_mm.size());
    for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
      const Vertex& at = mesh.lattice[i];
      CHECK(mesh.vertices_mm[i] == Point{at.x * 0.25, at.y * -1.0, at.z * 1.5});
    }
  }
}

TEST_CASE("the polygon normals of an octahedron are exactly its axes in both directions") {
  for (const Point& spacing : all_signs) {
    const Surface surface = octahedron(spacing);
    FaceMesh mesh = build_mesh(surface);
    set_polygon_normals(surface, mesh);
    REQUIRE(mesh.normals.size() == 6);
    for (std::size_t i = 0; i < 6; ++i) CHECK(mesh.normals[i] == unit_or_zero(mesh.vertices_mm[i]));
  }
}

TEST_CASE("polygon normals weight each polygon by its area without holes, for any triangulation") {
  for (const Point& spacing : all_signs)
    for (const Faces faces : {Faces::polygons, Faces::triangles}) {
      const Surface surface = box_with_hole(spacing);
      FaceMesh mesh = build_mesh(surface, {true, faces});
      set_polygon_normals(surface, mesh);
      // Side walls of 8 x 8 half-steps, lids of 8 x 8 without 4 x 4, and walls of 4 x 8 in the
      // hole.
      const auto in_space = [&](double x, double y, double z) {
        return Point{x / spacing[0], y / spacing[1], z / spacing[2]};
      };
      check_along(mesh.normals[vertex_at(mesh, {9, 8, 8})], in_space(64, 64, 48));
      check_along(mesh.normals[vertex_at(mesh, {1, 0, 0})], in_space(-64, -64, -48));
      check_along(mesh.normals[vertex_at(mesh, {7, 6, 8})], in_space(-32, -32, 48));
      check_along(mesh.normals[vertex_at(mesh, {3, 6, 0})], in_space(32, -32, -48));
    }
}

TEST_CASE(
    "polygon normals are the normalized sum of the area vectors at a vertex, on any surface") {
  Chance chance(21);
  for (const Point& spacing : all_signs) {
    const Surface surface = polygons_of(noise({7, 6, 8}, 0, 255, chance), 128, spacing);
    for (const bool is_conforming : {true, false}) {
      FaceMesh mesh = build_mesh(surface, {is_conforming, Faces::polygons});
      set_polygon_normals(surface, mesh);
      std::vector<std::set<std::uint32_t>> polygons(mesh.lattice.size());
      for (std::size_t face = 0; face < mesh.face_count(); ++face)
        for (std::size_t i = 0; i < mesh.face_size(face); ++i)
          polygons[mesh.face(face)[i]].insert(mesh.polygons[face]);
      for (std::size_t i = 0; i < polygons.size(); ++i) {
        Point sum{};
        for (const std::uint32_t polygon : polygons[i]) {
          const Point area = area_in_space(surface.polygons[polygon], spacing);
          for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += area[axis];
        }
        REQUIRE(degrees_between(mesh.normals[i], sum) < 0.006);
      }
    }
  }
}

TEST_CASE("gradient normals are at most 0.1 degree from double precision, for all samples") {
  struct Kind {
    SampleType type;
    int least, most;
  };
  Chance chance(22);
  for (const Kind& kind : {Kind{SampleType::u8, 0, 255},
                           {SampleType::u16, 0, 65535},
                           {SampleType::i16, -32768, 32767},
                           {SampleType::u16, 500, 560}})
    for (const Point& spacing : all_signs) {
      const SampleVolume<int> volume = noise({14, 13, 12}, kind.least, kind.most, chance);
      const int middle = (kind.least + kind.most) / 2;
      FaceMesh mesh = build_mesh(polygons_of(volume, middle, spacing, kind.type));
      set_gradient_normals_of(volume, kind.type, mesh);
      const NormalAngles angles = compare(mesh, volume);
      CHECK(angles.fixed_point.count > mesh.lattice.size() / 3);
      CHECK(angles.fixed_point.worst > 0.001);  // otherwise nothing was measured
      CHECK(angles.fixed_point.worst <= 0.1);
      CHECK(angles.octahedral.worst < 1);
    }
}

TEST_CASE("normals of a ball of radius 40 are within 3 degrees of its radii on a distance ramp") {
  struct Kind {
    SampleType type;
    discmc::reference::Ramp ramp;
  };
  for (const Kind& kind : {Kind{SampleType::u8, {16, 128, 255}},
                           {SampleType::u8, {32, 128, 255}},
                           {SampleType::u16, {500, 32768, 65535}}}) {
    const SampleVolume<int> volume = ramp_ball(90, 40, kind.ramp);
    FaceMesh mesh = build_mesh(polygons_of(volume, kind.ramp.threshold, {1, 1, 1}, kind.type));
    set_gradient_normals_of(volume, kind.type, mesh);
    const Angles angles = compare_with_radii(mesh, 90);
    CHECK(angles.count > 5000);  // none had a normal before
    CHECK(angles.worst < 3);
    CHECK(compare(mesh, volume).fixed_point.worst <= 0.1);
  }
}

TEST_CASE("a vertex in constant samples or outside the volume keeps its polygon normal") {
  // Within a checkerboard central differences are zero; at its border they are not.
  const auto board = discmc::reference::checkerboard({6, 5, 4});
  SampleVolume<int> volume{{6, 5, 4}, {}};
  for (const std::uint8_t on : board.on) volume.samples.push_back(on != 0 ? 200 : 10);
  const Surface surface = polygons_of(volume, 100, {1, 1, 1});
  FaceMesh mesh = build_mesh(surface);
  set_polygon_normals(surface, mesh);
  const FaceMesh before = mesh;
  set_gradient_normals_of(volume, SampleType::u8, mesh);
  std::size_t outside = 0, level = 0, steep_vertices = 0;
  for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
    const Vertex& at = mesh.lattice[i];
    const auto up = gradient(volume, at);
    if (std::hypot(up[0], up[1], up[2]) > 0) {
      ++steep_vertices;
      check_along(mesh.normals[i], {-up[0], -up[1], -up[2]});
      continue;
    }
    const bool is_outside = std::min({at.x, at.y, at.z}) < 0 || at.x > 10 || at.y > 8 || at.z > 6;
    ++(is_outside ? outside : level);
    CHECK(mesh.normals[i] == before.normals[i]);
  }
  CHECK(outside > 0);
  CHECK(level > 0);
  CHECK(steep_vertices > 0);
}

TEST_CASE("computing gradient normals reports progress after every slice") {
  const SampleVolume<int> volume = ramp_ball(12, 4, {32, 128, 255});
  FaceMesh mesh = build_mesh(polygons_of(volume, 128, {1, 1, 1}));
  SampleReader reader(volume.size, volume.samples);
  std::vector<std::uint32_t> progress;
  set_gradient_normals(reader, mesh,
                       [&progress](std::uint32_t slices) { progress.push_back(slices); });
  CHECK(progress == std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
}

TEST_CASE(
    "normals depend only on ratios of the spacing, also for spacings that a stream cannot "
    "represent") {
  const auto normals_of = [](const Point& spacing) {
    const Surface surface = octahedron(spacing);
    FaceMesh mesh = build_mesh(surface);
    set_polygon_normals(surface, mesh);
    return mesh.normals;
  };
  CHECK(normals_of({1, 5000, 1}) == normals_of({0.1, 500, 0.1}));
  CHECK(normals_of({2e-6, 5e-6, 3e-6}) == normals_of({20, 50, 30}));
}
