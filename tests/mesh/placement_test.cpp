// Spacing and placement: the position of the mesh.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

namespace {

using Matrix = std::array<std::array<double, 4>, 3>;

std::array<double, 3> placed(const Matrix& matrix, const std::array<double, 3>& point) {
  std::array<double, 3> at{};
  for (std::size_t row = 0; row < 3; ++row)
    at[row] = matrix[row][3] + matrix[row][0] * point[0] + matrix[row][1] * point[1] +
              matrix[row][2] * point[2];
  return at;
}

constexpr double c = 0.6, s = 0.8;  // a rotation about z
constexpr Matrix rotated{{{2 * c, -3 * s, 0, 100}, {2 * s, 3 * c, 0, -20}, {0, 0, 4, 7}}};
constexpr Matrix mirrored{{{0, 3, 0, 1}, {2, 0, 0, 2}, {0, 0, 4, 3}}};

}  // namespace

TEST_CASE(
    "the spacing scales the mesh, and a negative spacing mirrors the mesh with outward triangles") {
  const auto array = ball<float>();
  const double volume = measures_of(mesh_of(array.view(), ball_level)).volume;
  MeshOptions options;
  options.spacing = {2, -3, 0.5};
  for (const bool interpolates : {false, true}) {
    options.interpolates = interpolates;
    const Mesh mesh = mesh_of(array.view(), ball_level, options);
    CHECK(signed_volume(mesh) == doctest::Approx(measures_of(mesh).volume));
    CHECK(measures_of(mesh).least[1] < -3 * 16);
    if (!interpolates) CHECK(measures_of(mesh).volume == doctest::Approx(3 * volume));
  }
}

TEST_CASE("a placement matrix transforms vertices, normals and polygons") {
  const auto array = ball<float>();
  const Mesh lattice = mesh_of(array.view(), ball_level);
  for (const Matrix& matrix : {rotated, mirrored}) {
    MeshOptions options;
    options.spacing = {9, 9, 9};  // the placement replaces the spacing
    options.placement = matrix;
    options.polygons = true;
    options.normals = Normals::gradient;
    const Mesh mesh = mesh_of(array.view(), ball_level, options);
    std::vector<std::array<double, 3>> expected;
    for (const auto& vertex : lattice.vertices) expected.push_back(placed(matrix, vertex));
    const auto found = sorted(mesh.vertices);
    expected = sorted(expected);
    REQUIRE(found.size() == expected.size());
    for (const auto& vertex : found) {  // rounding may change the order
      const bool is_there = std::any_of(expected.begin(), expected.end(), [&](const auto& other) {
        const auto apart = difference(vertex, other);
        return dot(apart, apart) < 1e-18;
      });
      CHECK(is_there);
    }
    const MeshMeasures measures = measures_of(mesh);
    CHECK(measures.is_closed);
    CHECK(measures.volume == doctest::Approx(24 * measures_of(lattice).volume));
    CHECK(signed_volume(mesh) > 0);
    const auto centre = placed(matrix, ball_centre);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      CHECK(dot(mesh.normals[i], difference(mesh.vertices[i], centre)) > 0);
    for (std::size_t i = 0; i < mesh.polygons.size(); ++i) {
      const std::size_t corner = mesh.polygons.corner_begin[mesh.polygons.ring_begin[i]];
      const auto& vertex = mesh.vertices[mesh.polygons.corners[corner]];
      CHECK(dot(mesh.polygons.normals[i], difference(vertex, centre)) > 0);
    }
  }
}

TEST_CASE("a mesh has the same vertices and triangles with normals as without, at any placement") {
  for (const auto& array : bit_volumes())
    for (const Matrix& matrix : {rotated, mirrored}) {
      MeshOptions options;
      options.placement = matrix;
      options.polygons = true;
      const Mesh mesh = mesh_of(array.view(), 1, options);
      options.normals = Normals::surface;
      const Mesh with_normals = mesh_of(array.view(), 1, options);
      CHECK(mesh.normals.empty());
      CHECK(mesh.vertices == with_normals.vertices);
      CHECK(mesh.triangles == with_normals.triangles);
      CHECK(mesh.polygons.corners == with_normals.polygons.corners);
    }
}

TEST_CASE("normals depend only on the ratios of the spacings") {
  const auto array = ball<float>();
  MeshOptions options;
  for (const Normals normals : {Normals::surface, Normals::gradient}) {
    options.normals = normals;
    for (const double unit : {1e-6, 1e-3, 1e5}) {
      options.spacing = {1, 1, 1.4};
      const Mesh expected = mesh_of(array.view(), ball_level, options);
      options.spacing = {unit, unit, 1.4 * unit};
      const Mesh mesh = mesh_of(array.view(), ball_level, options);
      REQUIRE(mesh.normals.size() == expected.normals.size());
      for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        CHECK(dot(mesh.normals[i], expected.normals[i]) > 1 - 1e-7);
    }
  }
}
