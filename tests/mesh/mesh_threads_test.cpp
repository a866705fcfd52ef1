// MeshOptions::threads.
#include <random>

#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

TEST_CASE("a mesh is the same for any number of threads") {
  auto arrays = bit_volumes();
  arrays.push_back(array_of(discmc::reference::random({40, 40, 70}, 128, 9)));
  MeshOptions options;
  options.polygons = true;
  for (const auto& array : arrays) {
    options.threads = 1;
    const Mesh expected = mesh_of(array.view(), 1, options);
    for (const unsigned threads : {2U, 3U, 8U, 0U}) {
      options.threads = threads;
      const Mesh mesh = mesh_of(array.view(), 1, options);
      CHECK(mesh.vertices == expected.vertices);
      CHECK(mesh.triangles == expected.triangles);
      CHECK(rings_of(mesh) == rings_of(expected));
      CHECK(measures_of(mesh).is_closed);
    }
  }
}

TEST_CASE("an interpolated mesh is the same for any number of threads") {
  std::minstd_rand random(5);
  std::vector<std::uint8_t> samples(40 * 40 * 70);
  for (std::uint8_t& sample : samples) sample = static_cast<std::uint8_t>(random() % 256);
  MeshOptions options;
  options.interpolates = true;
  const Mesh expected = mesh_of(samples, {40, 40, 70}, 150, options);
  options.threads = 3;
  const Mesh mesh = mesh_of(samples, {40, 40, 70}, 150, options);
  CHECK(mesh.vertices == expected.vertices);
  CHECK(mesh.triangles == expected.triangles);
}

TEST_CASE("more threads than processor cores are allowed") {
  MeshOptions options;
  const std::vector<int> samples(27, 1);
  for (const unsigned threads : {100U, 1U << 31, std::numeric_limits<unsigned>::max()}) {
    options.threads = threads;
    CHECK(mesh_of(samples, {3, 3, 3}, 1, options).triangles.size() == 44);
  }
}
