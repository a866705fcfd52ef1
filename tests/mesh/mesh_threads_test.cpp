// MeshOptions::threads.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

TEST_CASE("any number of threads yields the same vertices, polygons and number of triangles") {
  auto arrays = bit_volumes();
  arrays.push_back(array_of(discmc::reference::random({20, 20, 60}, 128, 9)));
  MeshOptions options;
  options.polygons = true;
  for (const auto& array : arrays) {
    options.threads = 1;
    const Mesh expected = mesh_of(array.view(), 1, options);
    for (const unsigned threads : {2U, 3U, 8U, 0U}) {
      options.threads = threads;
      const Mesh mesh = mesh_of(array.view(), 1, options);
      CHECK(sorted(mesh.vertices) == sorted(expected.vertices));
      CHECK(rings_of(mesh) == rings_of(expected));
      CHECK(mesh.triangles.size() == expected.triangles.size());
      CHECK(measures_of(mesh).area == doctest::Approx(measures_of(expected).area));
      CHECK(measures_of(mesh).is_closed);
    }
  }
}

TEST_CASE("any number of threads interpolates equally") {
  const auto array = ball<float>();
  MeshOptions options;
  options.interpolates = true;
  const std::vector<Triangle> expected = triangles_of(mesh_of(array.view(), ball_level, options));
  options.threads = 3;
  CHECK(triangles_of(mesh_of(array.view(), ball_level, options)) == expected);
}

TEST_CASE("more threads than the system has are allowed") {
  MeshOptions options;
  const std::vector<int> samples(27, 1);
  for (const unsigned threads : {100U, 1U << 31, std::numeric_limits<unsigned>::max()}) {
    options.threads = threads;
    CHECK(mesh_of(samples, {3, 3, 3}, 1, options).triangles.size() == 44);
  }
}
