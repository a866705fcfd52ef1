// mesh.h: the C API makes the meshes of the C++ API, and throws no exception.
#include "discmc/mesh.h"

#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Sample>
discmc_samples described(const Array<Sample>& array, std::int32_t type) {
  return {array.samples.data(), type, {array.size[0], array.size[1], array.size[2]}, {0, 0, 0}};
}

template <std::size_t n, class Number>
std::vector<std::array<Number, n>> tuples(const Number* numbers, std::size_t count) {
  std::vector<std::array<Number, n>> all(numbers == nullptr ? 0 : count);
  for (std::size_t i = 0; i < all.size(); ++i) std::copy_n(numbers + n * i, n, all[i].begin());
  return all;
}

void check_same(const discmc_mesh& found, const Mesh& expected) {
  CHECK(tuples<3>(found.vertices, found.vertex_count) == expected.vertices);
  CHECK(tuples<3>(found.triangles, found.triangle_count) == expected.triangles);
  CHECK(tuples<3>(found.normals, found.vertex_count) == expected.normals);
  CHECK(found.polygon_count == expected.polygons.size());
  if (found.polygon_count == 0) return;
  CHECK(tuples<3>(found.polygon_normals, found.polygon_count) == expected.polygons.normals);
  const auto& rings = expected.polygons.ring_begin;
  CHECK(std::equal(rings.begin(), rings.end(), found.ring_begin));
  const auto& begins = expected.polygons.corner_begin;
  CHECK(std::equal(begins.begin(), begins.end(), found.corner_begin));
  const auto& corners = expected.polygons.corners;
  CHECK(std::equal(corners.begin(), corners.end(), found.corners));
}

}  // namespace

TEST_CASE("arrays of each sample type have the same mesh in C as in C++") {
  const auto whole = ball<std::int8_t>();
  const Mesh expected = mesh_of(whole.view(), ball_level);
  const auto check = [&](auto zero, std::int32_t type) {
    using Sample = decltype(zero);
    const Array<Sample> array{whole.size, {whole.samples.begin(), whole.samples.end()}};
    const discmc_samples samples = described(array, type);
    discmc_mesh mesh;
    REQUIRE(discmc_mesh_of(&samples, ball_level, infinity, nullptr, &mesh) == DISCMC_MESH_OK);
    CHECK(std::string(mesh.message).empty());
    check_same(mesh, expected);
    discmc_mesh_free(&mesh);
    CHECK(mesh.vertices == nullptr);
    discmc_mesh_free(&mesh);
  };
  check(std::uint8_t{}, DISCMC_SAMPLES_U8);
  check(std::int8_t{}, DISCMC_SAMPLES_I8);
  check(std::uint16_t{}, DISCMC_SAMPLES_U16);
  check(std::int16_t{}, DISCMC_SAMPLES_I16);
  check(std::uint32_t{}, DISCMC_SAMPLES_U32);
  check(std::int32_t{}, DISCMC_SAMPLES_I32);
  check(std::uint64_t{}, DISCMC_SAMPLES_U64);
  check(std::int64_t{}, DISCMC_SAMPLES_I64);
  check(float{}, DISCMC_SAMPLES_F32);
  check(double{}, DISCMC_SAMPLES_F64);
}

TEST_CASE("each option has the same effect in C as in C++") {
  const auto array = ball<float>();
  constexpr double level = 25;  // crosses the border
  discmc_samples samples = described(array, DISCMC_SAMPLES_F32);
  samples.strides[0] = array.size[0];  // x and y exchanged
  samples.strides[1] = 1;
  samples.strides[2] = array.size[0] * array.size[1];
  samples.extents[0] = array.size[1];
  samples.extents[1] = array.size[0];
  const Samples view(array.samples.data(), Extents(samples.extents[0], samples.extents[1], 24),
                     Strides{samples.strides[0], 1, samples.strides[2]});
  const double placement[12] = {0, 1, 0, 5, -2, 0, 0, 6, 0, 0, 3, 7};
  const auto check = [&](const discmc_mesh_options& in_c, const MeshOptions& options) {
    discmc_mesh mesh;
    REQUIRE(discmc_mesh_of(&samples, level, infinity, &in_c, &mesh) == DISCMC_MESH_OK);
    check_same(mesh, mesh_of(view, level, options));
    discmc_mesh_free(&mesh);
  };
  check({}, {});
  discmc_mesh_options in_c{};
  MeshOptions options;
  in_c.spacing[0] = 2, in_c.spacing[1] = -3, in_c.spacing[2] = 4;
  options.spacing = {2, -3, 4};
  in_c.polygons = 1;
  options.polygons = true;
  in_c.normals = DISCMC_NORMALS_GRADIENT;
  options.normals = Normals::gradient;
  check(in_c, options);
  in_c.has_open_border = 1;
  options.border = Border::open;
  check(in_c, options);
  in_c.polygons = 0;
  options.polygons = false;
  in_c.interpolates = 1;
  options.interpolates = true;
  check(in_c, options);
  in_c.tolerance = 0.3;
  options.tolerance = 0.3;
  in_c.placement = placement;
  options.placement = {{{{0, 1, 0, 5}, {-2, 0, 0, 6}, {0, 0, 3, 7}}}};
  check(in_c, options);
  in_c.normals = DISCMC_NORMALS_SURFACE;
  options.normals = Normals::surface;
  in_c.smoothing = options.smoothing = 2;
  check(in_c, options);
  in_c.smoothing = options.smoothing = 0;
  in_c.interpolates = 0, in_c.relaxes = 1;
  options.interpolates = false, options.relaxes = true;
  check(in_c, options);
}

TEST_CASE("a range of levels in C includes both ends") {
  const auto array = ball<std::uint16_t>();
  const discmc_samples samples = described(array, DISCMC_SAMPLES_U16);
  discmc_mesh mesh;
  REQUIRE(discmc_mesh_of(&samples, 40, 60, nullptr, &mesh) == DISCMC_MESH_OK);
  check_same(mesh, mesh_of(array.view(), {40, 60}));
  discmc_mesh_free(&mesh);
}

TEST_CASE("each label has the same mesh in C as in C++") {
  const auto array = array_of<std::uint8_t>(
      {8, 8, 8}, [](auto x, auto y, auto z) { return x / 4 + y / 4 + z / 4; });
  const discmc_samples samples = described(array, DISCMC_SAMPLES_U8);
  const std::int64_t chosen[] = {3, 1};
  for (const std::size_t count : {std::size_t{0}, std::size_t{2}}) {
    const auto expected =
        label_meshes(array.view(), {}, std::vector<std::int64_t>(chosen, chosen + count));
    discmc_label_meshes meshes;
    REQUIRE(discmc_label_meshes_of(&samples, count > 0 ? chosen : nullptr, count, nullptr,
                                   &meshes) == DISCMC_MESH_OK);
    REQUIRE(meshes.count == expected.size());
    for (std::size_t i = 0; i < meshes.count; ++i) {
      CHECK(meshes.meshes[i].label == expected[i].label);
      CHECK(meshes.meshes[i].voxels == expected[i].voxels);
      check_same(meshes.meshes[i].mesh, expected[i].mesh);
    }
    discmc_label_meshes_free(&meshes);
    CHECK(meshes.count == 0);
  }
}

TEST_CASE("progress in C is called for every slice, and a result of 0 cancels") {
  const auto array = ball<float>();
  const discmc_samples samples = described(array, DISCMC_SAMPLES_F32);
  int left = 1000;
  discmc_mesh_options options{};
  options.user = &left;
  options.progress = [](void* user, const char*, std::uint64_t, std::uint64_t) -> std::int32_t {
    return --*static_cast<int*>(user) > 0 ? 1 : 0;
  };
  discmc_mesh mesh;
  CHECK(discmc_mesh_of(&samples, ball_level, infinity, &options, &mesh) == DISCMC_MESH_OK);
  CHECK(left < 1000 - 20);
  discmc_mesh_free(&mesh);
  left = 5;
  CHECK(discmc_mesh_of(&samples, ball_level, infinity, &options, &mesh) == DISCMC_MESH_CANCELLED);
  CHECK(left == 0);
  CHECK(std::string(mesh.message) == "cancelled");
  CHECK(mesh.vertices == nullptr);
  discmc_mesh_free(&mesh);
}

TEST_CASE("an error in C has a code and a message, and no exception escapes") {
  const auto array = ball<float>();
  const discmc_samples good = described(array, DISCMC_SAMPLES_F32);
  const auto message_of = [](const discmc_samples& samples, const discmc_mesh_options& options,
                             double low = 1) {
    discmc_mesh mesh;
    CHECK(discmc_mesh_of(&samples, low, infinity, &options, &mesh) == DISCMC_MESH_BAD_ARGUMENT);
    discmc_label_meshes meshes;
    CHECK(discmc_label_meshes_of(&samples, nullptr, 0, &options, &meshes) ==
          DISCMC_MESH_BAD_ARGUMENT);
    CHECK(meshes.meshes == nullptr);
    CHECK_FALSE(std::string(meshes.message).empty());
    CHECK(mesh.triangle_count == 0);
    return std::string(mesh.message);
  };
  discmc_samples samples = good;
  samples.type = 10;
  CHECK(message_of(samples, {}) ==
        "the type of the samples is 10; give DISCMC_SAMPLES_U8 to DISCMC_SAMPLES_F64");
  samples = good;
  samples.extents[1] = 0;
  CHECK(message_of(samples, {}) == "an extent is 0; give 1 to 1073741823 voxels");
  samples = good;
  samples.data = nullptr;
  CHECK(message_of(samples, {}) == "the pointer to the samples is null");
  CHECK(message_of(good, {}, std::nan("")).find("nan") != std::string::npos);
  discmc_mesh_options options{};
  options.normals = 3;
  CHECK(message_of(good, options) ==
        "normals is 3; give DISCMC_NORMALS_NONE to DISCMC_NORMALS_GRADIENT");
  options = {};
  options.threads = -2;
  CHECK(message_of(good, options) == "threads is -2; give -1, or the number of threads");
  options = {};
  options.spacing[0] = 1;
  CHECK(message_of(good, options).find("1e-6 to 1e6") != std::string::npos);

  options = {};
  options.progress = [](void*, const char*, std::uint64_t, std::uint64_t) -> std::int32_t {
    throw 1;
  };
  discmc_mesh mesh;
  CHECK(discmc_mesh_of(&good, 1, infinity, &options, &mesh) == DISCMC_MESH_FAILED);
}

TEST_CASE("null pointers are reported by argument name, and freeing a null pointer has no effect") {
  discmc_mesh mesh;
  CHECK(discmc_mesh_of(nullptr, 1, infinity, nullptr, &mesh) == DISCMC_MESH_BAD_ARGUMENT);
  CHECK(std::string(mesh.message) == "the pointer to discmc_samples is null");
  const int one = 1;
  const discmc_samples samples = {&one, DISCMC_SAMPLES_I32, {1, 1, 1}, {0, 0, 0}};
  discmc_label_meshes meshes;
  CHECK(discmc_label_meshes_of(&samples, nullptr, 3, nullptr, &meshes) == DISCMC_MESH_BAD_ARGUMENT);
  CHECK(std::string(meshes.message) == "the pointer to 3 labels is null");
  discmc_mesh_free(nullptr);
  discmc_label_meshes_free(nullptr);
}
