// The smoothest surface between the voxels.
#include "smoothing/relaxed_crossings.hpp"

#include <stdexcept>

#include "meshes/surface_normals.hpp"
#include "sampled_field.hpp"
#include "test.hpp"

namespace {

using namespace sampled_field;

std::array<std::uint32_t, 3> dims_of(const Field& field) {
  return {field.size.width, field.size.height, field.size.depth};
}

Crossings relaxed(const Field& field, const Extracted& of, double tolerance) {
  Crossings crossings(dims_of(field), of.surface.polygons);
  relax(crossings, of.surface, {Border::closed, tolerance, {}});
  return crossings;
}

FaceMesh mesh_of(const Extracted& of, const Crossings* crossings, double tolerance) {
  return build_mesh(of.surface, {true, Faces::triangles, crossings, tolerance});
}

// A slope of one voxel in many, as in scans: the steps that are hardest to smooth.
Field slope(double x, double y) {
  return field_of({24, 20, 12}, [=](double at_x, double at_y, double at_z) {
    return level + 9 * (6 + x * (at_x - 12) + y * (at_y - 10) - at_z);
  });
}

double mean_angle(const FaceMesh& mesh, double middle) {
  const std::vector<Point> normals = surface_normals(mesh);
  double sum = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Point radius = unit_or_zero(difference(mesh.vertices_mm[i], {middle, middle, middle}));
    sum += std::acos(std::clamp(dot(normals[i], radius), -1.0, 1.0));
  }
  return sum / static_cast<double>(normals.size()) * 180 / 3.14159265;
}

double mean_distance(const FaceMesh& mesh, double middle, double radius) {
  double sum = 0;
  for (const Point& vertex : mesh.vertices_mm)
    sum +=
        std::abs(std::hypot(vertex[0] - middle, vertex[1] - middle, vertex[2] - middle) - radius);
  return sum / static_cast<double>(mesh.vertices_mm.size());
}

}  // namespace

TEST_CASE("crossings of polygons are in the middle of the edges that the samples cross") {
  for (const Border border : {Border::closed, Border::open})
    for (const Field& field : {noise({9, 7, 6}, 1), ball(12, 4), noise({2, 5, 4}, 2)}) {
      const Extracted of = extracted(field, SampleType::u8, {1, 1, 1}, border);
      const Crossings crossings(dims_of(field), of.surface.polygons);
      const Crossings& of_samples = of.finder.crossings();
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(crossings.count(axis) == of_samples.count(axis));
      crossings.for_each([&](Crossings::Id id, const Vertex& middle) {
        const auto same = of_samples.find(middle);
        REQUIRE(same);
        REQUIRE(same->axis == id.axis);
        REQUIRE(crossings.falls(id) == of_samples.falls(*same));
        REQUIRE(crossings.at(id) == 1);
      });
    }
}

TEST_CASE(
    "a relaxed surface is closed, keeps every voxel on its side and does not intersect itself") {
  for (const double tolerance : {0.0, 0.05})
    for (const Field& field :
         {noise({9, 8, 7}, 3), noise({14, 5, 8}, 4), ball(13, 4.7), slope(0.3, 0.1)}) {
      const Extracted of = extracted(field);
      const Crossings crossings = relaxed(field, of, tolerance);
      std::size_t moved = 0;
      crossings.for_each([&](Crossings::Id id, const Vertex&) {
        const double at = static_cast<double>(crossings.at(id));
        REQUIRE(at >= Crossings::margin);
        REQUIRE(at <= 2 - Crossings::margin);
        if (std::abs(at - 1) > 0.05) ++moved;
      });
      CHECK(moved > 50);
      const FaceMesh mesh = mesh_of(of, &crossings, tolerance);
      CHECK(check_mesh(mesh).is_closed());
      CHECK(crossing_pairs(mesh) == 0);
    }
}

TEST_CASE("crossings in the middle of edges cause no intersections in any cell configuration") {
  for (int configuration = 1; configuration < 256; ++configuration) {
    const Field field = field_of({2, 2, 2}, [=](double x, double y, double z) {
      const int corner = static_cast<int>(x + 2 * y + 4 * z);
      return (configuration >> corner & 1) != 0 ? 100 : 0;
    });
    const Extracted of = extracted(field);
    const Crossings middle(dims_of(field), of.surface.polygons);
    REQUIRE(crossing_pairs(mesh_of(of, &middle, 0)) == 0);
    const Crossings crossings = relaxed(field, of, 0);
    REQUIRE(crossing_pairs(mesh_of(of, &crossings, 0)) == 0);
  }
}

TEST_CASE("separate() removes all intersections between faces of a noisy surface") {
  // With all crossings far from the middle, some faces of noise intersect.
  const Field field = noise({12, 12, 12}, 8);
  const Extracted of = extracted(field);
  Crossings crossings(dims_of(field), of.surface.polygons);
  discmc::test::Chance chance(1);
  crossings.for_each([&](Crossings::Id id, const Vertex&) {
    crossings.move(id, chance.below(2) == 0 ? 0.02F : 1.98F);
  });
  REQUIRE(crossing_pairs(mesh_of(of, &crossings, 0)) > 0);
  separate(crossings, of.surface, {Border::closed, 0, {}});
  CHECK(crossing_pairs(mesh_of(of, &crossings, 0)) == 0);
}

TEST_CASE("relaxing keeps a flat surface flat") {
  for (const Field& field : {slope(0, 0), slope(1, 0), slope(-1, 1)}) {
    const Extracted of = extracted(field);
    const Crossings crossings = relaxed(field, of, 0);
    crossings.for_each([&](Crossings::Id id, const Vertex& middle) {
      const bool is_inner = middle.x > 8 && middle.x < 38 && middle.y > 8 && middle.y < 30 &&
                            middle.z > 8 && middle.z < 14;
      if (is_inner) CHECK(crossings.at(id) == doctest::Approx(1).epsilon(1e-3));
    });
  }
}

TEST_CASE(
    "relaxing rounds the rim of a surface at a closed border, and keeps an open border flat") {
  for (const Border border : {Border::closed, Border::open}) {
    const Field field = slope(0, 0);
    const Extracted of = extracted(field, SampleType::u8, {1, 1, 1}, border);
    Crossings crossings(dims_of(field), of.surface.polygons);
    relax(crossings, of.surface, {border, 0, {}});
    const auto at_rim = crossings.find({0, 20, 13});
    REQUIRE(at_rim);
    if (border == Border::open)
      CHECK(crossings.at(*at_rim) == doctest::Approx(1).epsilon(1e-3));
    else
      CHECK(crossings.at(*at_rim) < 0.9F);
  }
}

TEST_CASE("a relaxed ball is closer to the sphere than midpoints, in position and direction") {
  const Field field = ball(44, 17.3);
  const Extracted of = extracted(field);
  const Crossings crossings = relaxed(field, of, 0);
  const FaceMesh relaxed = mesh_of(of, &crossings, 0), merged = mesh_of(of, nullptr, 0);
  constexpr double middle = 21.5, radius = 17.3;
  CHECK(mean_distance(relaxed, middle, radius) < 0.6 * mean_distance(merged, middle, radius));
  CHECK(mean_angle(relaxed, middle) < 0.7 * mean_angle(merged, middle));
}

TEST_CASE("relaxing refuses polygons that span too many rows") {
  Polygons polygons;
  polygons.add_polygon(discmc::incidence_of({1, 1, 1}));
  const Vertex corners[] = {{1, 0, 0}, {1, 60000, 0}, {1, 0, 60000}};
  polygons.add_ring({corners, corners + 3});
  CHECK_THROWS_AS(Crossings({30000, 30000, 30000}, polygons), std::length_error);
}
