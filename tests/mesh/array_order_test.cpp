// Strides: an array in any order of axes, or with reversed axes, has the surface of the contiguous
// array.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

namespace {

// Copies samples to memory in which the axes have another order, some reversed, with gaps between.
template <class Sample>
struct Rearranged {
  Rearranged(const Array<Sample>& array, const std::array<std::size_t, 3>& order,
             unsigned backwards, std::ptrdiff_t gap) {
    std::ptrdiff_t distance = gap;
    for (const std::size_t axis : order) {
      strides[axis] = distance;
      distance *= array.size[axis] + 1;
    }
    memory.resize(static_cast<std::size_t>(distance));
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((backwards >> axis & 1) != 0) {
        first += strides[axis] * (array.size[axis] - 1);
        strides[axis] = -strides[axis];
      }
    auto sample = array.samples.begin();
    for (std::int64_t z = 0; z < array.size[2]; ++z)
      for (std::int64_t y = 0; y < array.size[1]; ++y)
        for (std::int64_t x = 0; x < array.size[0]; ++x)
          memory[static_cast<std::size_t>(first + strides[0] * x + strides[1] * y +
                                          strides[2] * z)] = *sample++;
  }
  Samples view(const Extents& extents) const { return {memory.data() + first, extents, strides}; }

  std::vector<Sample> memory;
  Strides strides{};
  std::ptrdiff_t first = 0;
};

template <class Sample>
void check_all_orders(const Array<Sample>& array, const Level& level, const MeshOptions& options) {
  const MeshMeasures expected = measures_of(mesh_of(array.view(), level, options));
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (unsigned backwards = 0; backwards < 8; ++backwards) {
      const Rearranged<Sample> other(array, order, backwards, backwards % 3 + 1);
      const Mesh mesh = mesh_of(other.view(array.extents()), level, options);
      const MeshMeasures measures = measures_of(mesh);
      CHECK(measures.is_closed == expected.is_closed);
      CHECK(measures.area == doctest::Approx(expected.area));
      CHECK(measures.volume == doctest::Approx(expected.volume));
      CHECK(signed_volume(mesh) > 0);
      CHECK(measures.least == expected.least);
      CHECK(measures.greatest == expected.greatest);
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(measures.centre[axis] == doctest::Approx(expected.centre[axis]));
      CHECK(measures.bodies == expected.bodies);
      CHECK(measures.cavities == expected.cavities);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

}  // namespace

TEST_CASE("arrays in any order of axes, reversed axes included, yield the same surface") {
  for (const auto& array : bit_volumes()) check_all_orders(array, 1, {});
  check_all_orders(ball<std::int16_t>(), ball_level, {});
}

TEST_CASE("interpolation of double arrays yields the same mesh in any order of axes") {
  const auto array = ball<double>();
  MeshOptions options;
  options.interpolates = true;
  const Mesh expected = mesh_of(array.view(), ball_level, options);
  const Rearranged<double> other(array, {2, 0, 1}, 5, 2);
  const Mesh mesh = mesh_of(other.view(array.extents()), ball_level, options);
  CHECK(measures_of(mesh).is_closed);
  CHECK(measures_of(mesh).volume == doctest::Approx(measures_of(expected).volume).epsilon(0.001));
}

TEST_CASE("arrays in any order of axes yield the same spacing, normals and polygons") {
  const auto array = ball<float>();
  MeshOptions options;
  options.spacing = {0.5, 2, 3};
  options.polygons = true;
  options.normals = Normals::gradient;
  const Mesh expected = mesh_of(array.view(), ball_level, options);
  const Rearranged<float> other(array, {1, 2, 0}, 2, 1);
  const Mesh mesh = mesh_of(other.view(array.extents()), ball_level, options);
  CHECK(measures_of(mesh).volume == doctest::Approx(measures_of(expected).volume));
  CHECK(mesh.polygons.size() == expected.polygons.size());
  REQUIRE(mesh.vertices.size() == expected.vertices.size());
  const auto by_place = [](const Mesh& of) {
    std::vector<std::array<std::array<double, 3>, 2>> vertices;
    for (std::size_t i = 0; i < of.vertices.size(); ++i)
      vertices.push_back({of.vertices[i], of.normals[i]});
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  const auto found = by_place(mesh), wanted = by_place(expected);
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i][0] == wanted[i][0]);
    CHECK(dot(found[i][1], wanted[i][1]) > 0.9999);
  }
}

TEST_CASE("label meshes have the same measures in any order of axes") {
  const auto array = array_of<std::uint16_t>(
      {8, 9, 10}, [](auto x, auto y, auto z) { return (x / 3 + 2 * (y / 4) + z / 5) % 4; });
  const auto expected = label_meshes(array.view());
  const Rearranged<std::uint16_t> other(array, {2, 1, 0}, 3, 1);
  const auto found = label_meshes(other.view(array.extents()));
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i].label == expected[i].label);
    CHECK(found[i].voxels == expected[i].voxels);
    CHECK(measures_of(found[i].mesh).volume ==
          doctest::Approx(measures_of(expected[i].mesh).volume));
  }
}

TEST_CASE("an array with one long axis is swept along that axis") {
  std::vector<std::uint8_t> samples(40000, 0);
  samples[39999] = 1;
  const Mesh along_x = mesh_of(samples, {40000, 1, 1}, 1);
  CHECK(measures_of(along_x).greatest[0] == 39999.5);
  CHECK(signed_volume(along_x) > 0);
}

TEST_CASE("the stride of an axis with a single sample is ignored") {
  const std::vector<int> samples(100, 1);
  constexpr auto most = std::numeric_limits<std::ptrdiff_t>::max();
  const Samples far(samples.data(), {10, 1, 10}, Strides{1, most, 10});
  CHECK(triangles_of(mesh_of(far, 1)) == triangles_of(mesh_of(samples, {10, 1, 10}, 1)));
}
