#include "meshes/mesh.hpp"

#include <random>
#include <stdexcept>

#include "hand_made.hpp"
#include "test.hpp"

namespace {

using namespace discmc::meshing;
using namespace hand_made;

const Faces both_kinds[] = {Faces::polygons, Faces::triangles};

double six_volumes(const FaceMesh& mesh) {
  double sum = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    for (std::size_t i = 2; i < mesh.face_size(face); ++i) {
      const std::uint32_t* corners = mesh.face(face);
      sum += dot(mesh.vertices_mm[corners[0]],
                 cross(mesh.vertices_mm[corners[i - 1]], mesh.vertices_mm[corners[i]]));
    }
  return sum;
}

// The faces of each polygon have its area, and therefore its normal.
void check_areas(const Surface& surface, const FaceMesh& mesh) {
  std::vector<Point> missing;
  for (const Polygon& polygon : surface.polygons) {
    Vertex doubled{};
    for (const Ring& ring : polygon.rings)
      for (std::size_t i = 2; i < ring.size(); ++i)
        doubled = doubled + cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
    missing.push_back({doubled.x / 2.0, doubled.y / 2.0, doubled.z / 2.0});
  }
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    Point& of_polygon = missing[mesh.polygons[face]];
    of_polygon = difference(of_polygon, area_vector(mesh, face));
  }
  CHECK(std::count(missing.begin(), missing.end(), Point{}) ==
        static_cast<std::ptrdiff_t>(surface.polygons.size()));
}

// With a spacing of two the mesh is in half-steps, so all values are exact.
void check_closed_and_exact(const Surface& surface) {
  for (const Faces faces : both_kinds) {
    const FaceMesh mesh = build_mesh(surface, {true, faces});
    const MeshReport report = check_mesh(mesh);
    CHECK(report.open_edges == 0);
    CHECK(report.non_manifold_edges == 0);
    CHECK(report.wrongly_oriented == 0);
    CHECK(report.degenerate_faces == 0);
    CHECK(six_volumes(mesh) == static_cast<double>(hand_made::six_volumes(surface)));
    check_areas(surface, mesh);
  }
}

bool is_vertex(const FaceMesh& mesh, const Point& point) {
  return std::find(mesh.vertices_mm.begin(), mesh.vertices_mm.end(), point) !=
         mesh.vertices_mm.end();
}

}  // namespace

TEST_CASE("the mesh of a single voxel is an octahedron with vertices at half the spacing") {
  const Surface surface = octahedron({1, 2, 3});
  CHECK(hand_made::six_volumes(surface) == 8);
  for (const Faces faces : both_kinds) {
    const FaceMesh mesh = build_mesh(surface, {true, faces});
    CHECK(mesh.vertices_mm.size() == 6);
    CHECK(mesh.face_count() == 8);
    CHECK(check_mesh(mesh).is_closed());
    CHECK(check_mesh(mesh).edges == 12);
    CHECK(is_vertex(mesh, {0.5, 0, 0}));
    CHECK(is_vertex(mesh, {0, -1, 0}));
    CHECK(is_vertex(mesh, {0, 0, 1.5}));
    CHECK(six_volumes(mesh) == doctest::Approx(8 * 6 / 8.0));
  }
  check_closed_and_exact(octahedron());
}

TEST_CASE("polygons with holes are triangulated, and polygons without holes stay whole") {
  const Surface surface = box_with_hole();
  CHECK(hand_made::six_volumes(surface) == 6 * (8 * 8 * 8 - 4 * 4 * 8));
  check_closed_and_exact(surface);
  const FaceMesh polygons = build_mesh(surface, {true, Faces::polygons});
  CHECK(polygons.vertices_mm.size() == 16);
  CHECK(polygons.face_count() == 8 + 2 * 8);
  const FaceMesh triangles = build_mesh(surface, {true, Faces::triangles});
  CHECK(triangles.face_count() == 2 * 8 + 2 * 8);
  for (std::size_t face = 0; face < triangles.face_count(); ++face) {
    CHECK(triangles.face_size(face) == 3);
    const std::uint32_t polygon = triangles.polygons[face];
    CHECK(triangles.incidences[face] == surface.polygons[polygon].incidence);
  }
}

TEST_CASE("a polygon with more than 255 corners is triangulated, and one with 255 stays whole") {
  const FaceMesh whole = build_mesh(saw(255), {true, Faces::polygons});
  CHECK(whole.face_count() == 1);
  CHECK(whole.face_size(0) == 255);
  const FaceMesh cut = build_mesh(saw(257), {true, Faces::polygons});
  CHECK(cut.vertices_mm.size() == 257);
  CHECK(cut.face_count() == 257 - 2);
  CHECK(check_mesh(cut).open_edges == 257);
}

TEST_CASE("faces of a mesh look outside for axes in either direction") {
  for (const double x : {1.0, -1.0})
    for (const double y : {2.0, -2.0})
      for (const double z : {0.7, -0.7})
        for (const Faces faces : both_kinds) {
          const Surface surface = box_with_hole({x, y, z});
          const FaceMesh mesh = build_mesh(surface, {true, faces});
          CHECK(check_mesh(mesh).is_closed());
          CHECK(six_volumes(mesh) == doctest::Approx(6 * 384 * 1.4 / 8));
          for (std::size_t face = 0; face < mesh.face_count(); ++face) {
            const Point& a = mesh.vertices_mm[mesh.face(face)[0]];
            const Point area = cross(difference(mesh.vertices_mm[mesh.face(face)[1]], a),
                                     difference(mesh.vertices_mm[mesh.face(face)[2]], a));
            const Point normal = outward_normal(mesh.incidences[face], mesh.spacing_mm);
            CHECK(dot(area, normal) == doctest::Approx(std::sqrt(dot(area, area))));
          }
        }
}

TEST_CASE("polygons with any choice of touching holes give a closed mesh that keeps the volume") {
  std::minstd_rand random(1);
  for (int round = 0; round < 100; ++round) {
    std::vector<Pit> pits;
    for (int place = 0; place < 16; ++place)
      if (random() % 2 == 0) pits.push_back({place % 4, place / 4});
    const Surface surface = pitted_block(pits);
    const auto count = static_cast<std::int64_t>(pits.size());
    CHECK(hand_made::six_volumes(surface) == 6 * 16 * 16 * 8 - 32 * count);
    check_closed_and_exact(surface);
  }
}

TEST_CASE("a conforming mesh has a vertex where a side of another polygon ends") {
  const Surface surface = leaning_wall();
  check_closed_and_exact(surface);
  for (const Faces faces : both_kinds) {
    const FaceMesh conforming = build_mesh(surface, {true, faces});
    const FaceMesh plain = build_mesh(surface, {false, faces});
    CHECK(conforming.vertices_mm.size() == plain.vertices_mm.size());
    CHECK(check_mesh(plain).open_edges == 3);
    CHECK(check_mesh(plain).degenerate_faces == 0);
    CHECK(six_volumes(plain) == static_cast<double>(hand_made::six_volumes(surface)));
  }
  CHECK(build_mesh(surface, {true, Faces::polygons}).face_size(0) == 5);
  CHECK(build_mesh(surface, {false, Faces::polygons}).face_size(0) == 4);
}

TEST_CASE("a conforming mesh is closed even if a side of the surface is cut into two polygons") {
  Surface surface = leaning_wall();
  surface.polygons = only(surface.polygons, {0, 1, 2, 3, 4, 6, 7});
  surface.polygons.append(polygon({0, 1, 0}, {{{1, 8, 0}, {5, 8, 0}, {5, 8, 4}, {1, 8, 4}}}));
  surface.polygons.append(polygon({0, 1, 0}, {{{5, 8, 0}, {9, 8, 0}, {9, 8, 4}, {5, 8, 4}}}));
  check_closed_and_exact(surface);
}

TEST_CASE(
    "in a mesh that is not conforming, a hole may touch a straight side between its corners") {
  const Surface surface = pitted_block({{0, 0}, {1, 0}, {1, 1}});
  const FaceMesh mesh = build_mesh(surface, {false, Faces::triangles});
  CHECK(check_mesh(mesh).degenerate_faces == 0);
  CHECK(six_volumes(mesh) == static_cast<double>(hand_made::six_volumes(surface)));
}

TEST_CASE("building a mesh skips invalid polygons and keeps valid ones") {
  const Surface whole = box_with_hole();
  CHECK(build_mesh(whole, {true, Faces::triangles}).left_out.empty());
  // change(rings): modifies the polygon.
  const auto check = [&whole](std::uint32_t polygon, auto change) {
    const Surface surface{whole.spacing_mm,
                          changed(whole.polygons, [&](std::size_t place, auto& rings) {
                            if (place == polygon) change(rings);
                          })};
    const FaceMesh mesh = build_mesh(surface, {true, Faces::triangles});
    CHECK(mesh.left_out == std::vector<std::uint32_t>{polygon});
    std::set<std::uint32_t> rest(mesh.polygons.begin(), mesh.polygons.end());
    CHECK(rest.size() == surface.polygons.size() - 1);
    CHECK(rest.count(polygon) == 0);
    return surface;
  };
  check(8, [](auto& crossing) {
    for (Vertex& vertex : crossing[1]) vertex = vertex + Vertex{3, 1, 0};
  });
  check(3, [](auto& none) { none.clear(); });
  const Surface slit = check(2, [](auto& rings) { rings = {{{1, 0, 0}, {3, 0, 0}}}; });
  CHECK(build_mesh(slit, {true, Faces::polygons}).left_out == std::vector<std::uint32_t>{2});
  check(9, [](auto& huge) {
    for (Vertex& vertex : huge[1]) vertex.x += 1 << 30;
  });
}

TEST_CASE("a spacing of 0, infinity or NaN is refused") {
  for (const double wrong : {0.0, std::numeric_limits<double>::infinity(), std::nan("")})
    CHECK_THROWS_AS(build_mesh(octahedron({1, wrong, 1})), std::invalid_argument);
}

TEST_CASE("a surface without polygons is an empty closed mesh") {
  const FaceMesh mesh = build_mesh({{1, 1, 1}, {}});
  CHECK(mesh.face_count() == 0);
  CHECK(check_mesh(mesh).is_closed());
  CHECK(is_closed(mesh));
}

TEST_CASE("mesh vertices at large coordinates neither overflow nor lose a half-step") {
  Surface surface = box_with_hole();
  const std::int32_t far = 2000000000;
  surface.polygons = changed(surface.polygons, [](std::size_t, auto& rings) {
    for (Corners& ring : rings)
      for (Vertex& vertex : ring) vertex.z += far;
  });
  const FaceMesh mesh = build_mesh(surface, {true, Faces::triangles});
  CHECK(check_mesh(mesh).is_closed());
  CHECK(is_vertex(mesh, {1, 0, 2000000008.0}));
}

TEST_CASE("the mesh report counts each kind of defect") {
  const FaceMesh whole = build_mesh(octahedron());
  REQUIRE(check_mesh(whole).is_closed());
  CHECK(is_closed(whole));

  Surface surface = octahedron();
  surface.polygons = only(surface.polygons, {0, 1, 2, 3, 4, 5, 6});
  const FaceMesh lacking = build_mesh(surface);
  MeshReport report = check_mesh(lacking);
  CHECK(report.open_edges == 3);
  CHECK(report.edges == 12);
  CHECK_FALSE(report.is_closed());
  CHECK_FALSE(is_closed(lacking));

  FaceMesh reversed = whole;
  std::swap(reversed.corners[0], reversed.corners[1]);
  report = check_mesh(reversed);
  CHECK(report.wrongly_oriented == 3);
  CHECK(report.open_edges == 0);
  CHECK_FALSE(is_closed(reversed));

  surface = octahedron();
  surface.polygons.append(only(surface.polygons, {0}));
  const FaceMesh doubled = build_mesh(surface);
  CHECK(check_mesh(doubled).non_manifold_edges == 3);
  CHECK_FALSE(is_closed(doubled));

  FaceMesh repeated = build_mesh(leaning_wall());
  repeated.corners[4] = repeated.corners[0];
  CHECK(check_mesh(repeated).degenerate_faces == 1);

  // Rounding gives these three collinear corners a small area.
  FaceMesh flat = build_mesh({{1, 1, 1}, polygon({0, 0, 1}, {{{1, 0, 0}, {3, 0, 0}, {2, 1, 0}}})});
  CHECK(check_mesh(flat).degenerate_faces == 0);
  flat.vertices_mm = {{0.1, 0.3, 0}, {0.2, 0.6, 0}, {0.3, 0.9, 0}};
  CHECK(check_mesh(flat).degenerate_faces == 1);
}

TEST_CASE("a face has the normal of its plane, with and without an incidence") {
  FaceMesh mesh = build_mesh(octahedron({1, -2, 3}));
  std::vector<Point> expected;
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    expected.push_back(face_normal(mesh, face));
  mesh.incidences.clear();
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    CHECK(dot(expected[face], expected[face]) == doctest::Approx(1));
    CHECK(dot(face_normal(mesh, face), expected[face]) == doctest::Approx(1));
  }
  mesh.vertices_mm.assign(mesh.vertices_mm.size(), {1, 1, 1});
  CHECK(face_normal(mesh, 0) == Point{});
}
