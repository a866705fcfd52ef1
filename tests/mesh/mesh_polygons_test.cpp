// Mesh::polygons: merged polygons with holes, over the vertices of the mesh.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

namespace {

// Returns the area of a ring as a vector, by Newell's method.
std::array<double, 3> area_of(const Mesh& mesh, std::size_t ring) {
  const MeshPolygons& polygons = mesh.polygons;
  const std::size_t begin = polygons.corner_begin[ring], end = polygons.corner_begin[ring + 1];
  std::array<double, 3> area{};
  for (std::size_t i = begin; i < end; ++i) {
    const auto& a = mesh.vertices[polygons.corners[i]];
    const auto& b = mesh.vertices[polygons.corners[i + 1 < end ? i + 1 : begin]];
    const auto part = cross(a, b);
    for (std::size_t axis = 0; axis < 3; ++axis) area[axis] += part[axis] / 2;
  }
  return area;
}

void check_polygons(const Mesh& mesh) {
  const MeshPolygons& polygons = mesh.polygons;
  REQUIRE(polygons.ring_begin.size() == polygons.size() + 1);
  REQUIRE(polygons.ring_begin.back() == polygons.corner_begin.size() - 1);
  REQUIRE(polygons.corner_begin.back() == polygons.corners.size());
  double area = 0;
  for (std::size_t polygon = 0; polygon < polygons.size(); ++polygon) {
    const auto& normal = polygons.normals[polygon];
    CHECK(dot(normal, normal) == doctest::Approx(1));
    for (std::size_t ring = polygons.ring_begin[polygon]; ring < polygons.ring_begin[polygon + 1];
         ++ring) {
      const auto of_ring = area_of(mesh, ring);
      const double along = dot(of_ring, normal);
      // The ring is flat if its area vector has no component across the normal. Holes turn the
      // other way.
      CHECK(std::abs(along) == doctest::Approx(std::sqrt(dot(of_ring, of_ring))));
      CHECK((along > 0) == (ring == polygons.ring_begin[polygon]));
      area += along;
    }
  }
  CHECK(area == doctest::Approx(measures_of(mesh).area));
}

}  // namespace

TEST_CASE(
    "polygons are plane, have the orientation of their normals and the area of their triangles") {
  MeshOptions options;
  options.polygons = true;
  for (const auto& array : bit_volumes()) {
    const Mesh mesh = mesh_of(array.view(), 1, options);
    REQUIRE(mesh.polygons.size() > 0);
    check_polygons(mesh);
  }
  options.spacing = {0.3, -2, 5};
  check_polygons(mesh_of(ball<float>().view(), ball_level, options));
}

TEST_CASE("a box with a pit has a polygon with a hole") {
  auto array = array_of<std::uint8_t>({12, 12, 8}, [](auto x, auto y, auto z) {
    const bool is_in_pit = x >= 5 && x < 7 && y >= 5 && y < 7 && z >= 4;
    return x >= 1 && x < 11 && y >= 1 && y < 11 && z >= 1 && z < 7 && !is_in_pit ? 1 : 0;
  });
  MeshOptions options;
  options.polygons = true;
  const Mesh mesh = mesh_of(array.view(), 1, options);
  check_polygons(mesh);
  std::size_t with_hole = 0;
  for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
    if (mesh.polygons.ring_begin[i + 1] - mesh.polygons.ring_begin[i] == 2) ++with_hole;
  CHECK(with_hole == 1);
}

TEST_CASE("a mesh contains polygons only on request") {
  const Mesh mesh = mesh_of(ball<float>().view(), ball_level);
  CHECK(mesh.polygons.size() == 0);
  CHECK(mesh.polygons.ring_begin.size() == 1);
  CHECK(mesh.normals.empty());
}
