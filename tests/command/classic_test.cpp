#include "extraction/classic.hpp"

#include "command.hpp"
#include "sampled_field.hpp"

namespace {

using command_tests::volume_of;
using discmc::reference::BitVolume;
using namespace sampled_field;

bool contains(const Field& field, const int (&at)[3]) {
  const std::uint32_t end[] = {field.size.width, field.size.height, field.size.depth};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (at[axis] < 0 || at[axis] >= static_cast<int>(end[axis])) return false;
  return true;
}

Field bits(const BitVolume& volume) {
  Field field{{volume.width, volume.height, volume.depth}, {}};
  for (const std::uint8_t on : volume.on) field.samples.push_back(on != 0 ? 100 : 0);
  return field;
}

FaceMesh classic_of(const Field& field, Border border = Border::closed,
                    const Point& spacing = {1, 1, 1}, SampleType type = SampleType::u8) {
  SampleReader reader(field.size, field.samples, spacing, type);
  return classic_mesh(reader, {{threshold}, border});
}

Extraction extraction(const Field& field, Border border) {
  SampleReader reader(field.size, field.samples);
  SurfaceBuilder builder;
  return extract(reader, {{threshold}, border}, discmc::make_sink(builder));
}

// A vertex lies strictly between an on and an off voxel, where the line through their samples
// reaches the level. Next to the halo it is in the middle.
void check_vertex(const Field& field, const Point& vertex) {
  int low[3], high[3], broken = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<int>(std::floor(vertex[axis]));
    high[axis] = static_cast<int>(std::ceil(vertex[axis]));
    broken += high[axis] - low[axis];
  }
  REQUIRE(broken == 1);
  double part = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) part += vertex[axis] - low[axis];
  const bool low_inside = contains(field, low), high_inside = contains(field, high);
  REQUIRE((low_inside || high_inside));
  if (low_inside && high_inside) {
    const int from = field.at(low[0], low[1], low[2]), to = field.at(high[0], high[1], high[2]);
    CHECK((from >= threshold) != (to >= threshold));
    CHECK(from + part * (to - from) == doctest::Approx(level));
  } else {
    CHECK(part == 0.5);
    const int* inside = low_inside ? low : high;
    CHECK(field.at(inside[0], inside[1], inside[2]) >= threshold);
  }
}

void check_classic(const Field& field, Border border) {
  const FaceMesh mesh = classic_of(field, border);
  const Extraction extracted = extraction(field, border);
  CHECK(mesh.face_count() == extracted.statistics.classic_triangles);
  const MeshReport report = check_mesh(mesh);
  CHECK(report.non_manifold_edges + report.wrongly_oriented + report.degenerate_faces == 0);
  CHECK((border == Border::open || report.is_closed()));
  for (const Point& vertex : mesh.vertices_mm) check_vertex(field, vertex);
}

}  // namespace

TEST_CASE(
    "a mesh of classic Marching Cubes is closed, manifold, and has the triangles that the "
    "statistics count") {
  for (const Border border : {Border::closed, Border::open}) {
    check_classic(ball(13, 4.3), border);
    check_classic(bits(discmc::reference::checkerboard({6, 5, 4})), border);
    for (std::uint32_t seed = 1; seed <= 6; ++seed) check_classic(noise({9, 8, 7}, seed), border);
  }
}

TEST_CASE("classic Marching Cubes gives a closed mesh for tilings of every cell configuration") {
  for (int configuration = 0; configuration < discmc::configurations; ++configuration) {
    INFO(configuration);
    const auto code = static_cast<discmc::Configuration>(configuration);
    check_classic(bits(discmc::reference::tiling({4, 4, 4}, code)), Border::closed);
  }
}

TEST_CASE("vertices of classic Marching Cubes lie on the sampled ball") {
  const double radius = 9.2;
  const FaceMesh mesh = classic_of(ball(26, radius));
  for (const Point& vertex : mesh.vertices_mm)
    CHECK(std::hypot(vertex[0] - 12.5, vertex[1] - 12.5, vertex[2] - 12.5) ==
          doctest::Approx(radius).epsilon(0.02));
}

TEST_CASE("triangles of Marching Cubes face outside for axes in either direction") {
  const Field field = ball(15, 5);
  const double expected = volume_of(classic_of(field));
  CHECK(expected == doctest::Approx(4.19 * 5 * 5 * 5).epsilon(0.05));
  for (const double x : {2.0, -2.0})
    for (const double y : {0.5, -0.5})
      for (const double z : {3.0, -3.0}) {
        const FaceMesh mesh = classic_of(field, Border::closed, {x, y, z});
        CHECK(check_mesh(mesh).is_closed());
        CHECK(volume_of(mesh) == doctest::Approx(3 * expected));
      }
}

TEST_CASE("classic Marching Cubes gives the same triangles for samples of every type") {
  const Field field = noise({7, 6, 5}, 4);
  const FaceMesh expected = classic_of(field);
  for (const SampleType type : {SampleType::u16, SampleType::i16}) {
    const FaceMesh mesh = classic_of(field, Border::closed, {1, 1, 1}, type);
    CHECK(mesh.vertices_mm == expected.vertices_mm);
    CHECK(mesh.corners == expected.corners);
  }
  Field negative = field;
  for (int& sample : negative.samples) sample -= 400;
  SampleReader reader(negative.size, negative.samples, {1, 1, 1}, SampleType::i16);
  CHECK(classic_mesh(reader, {{threshold - 400}, Border::closed}).vertices_mm ==
        expected.vertices_mm);
}
