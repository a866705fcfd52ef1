// label_meshes(): one mesh per label in one pass.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

namespace {

Array<std::int32_t> blocks() {
  return array_of<std::int32_t>({10, 11, 12}, [](auto x, auto y, auto z) {
    return (x / 4 + 2 * (y / 5) + 3 * (z / 7)) % 6 - 1;
  });
}

}  // namespace

TEST_CASE("each label has the mesh of its own mask, in ascending order of labels without label 0") {
  const auto array = blocks();
  const std::vector<LabelMesh> meshes = label_meshes(array.view());
  std::set<std::int32_t> labels(array.samples.begin(), array.samples.end());
  labels.erase(0);
  REQUIRE(meshes.size() == labels.size());
  auto label = labels.begin();
  for (const LabelMesh& each : meshes) {
    CHECK(each.label == *label);
    CHECK(each.voxels == static_cast<std::uint64_t>(
                             std::count(array.samples.begin(), array.samples.end(), *label)));
    CHECK(measures_of(each.mesh).is_closed);
    ++label;
  }
}

TEST_CASE("meshes of neighbouring labels have exactly the same vertices on their common wall") {
  const auto array =
      array_of<std::uint8_t>({6, 5, 5}, [](auto x, auto, auto) { return x < 3 ? 1 : 2; });
  for (const double smoothing : {0.0, 1.0}) {
    MeshOptions options;
    options.smoothing = smoothing;
    const auto meshes = label_meshes(array.view(), options);
    REQUIRE(meshes.size() == 2);
    const auto wall = [](const Mesh& mesh) {
      std::set<std::array<double, 3>> vertices;
      for (const auto& vertex : mesh.vertices)
        if (std::abs(vertex[0] - 2.5) < 0.01 && vertex[1] > 1 && vertex[1] < 3 && vertex[2] > 1 &&
            vertex[2] < 3)
          vertices.insert(vertex);
      return vertices;
    };
    CHECK(wall(meshes[0].mesh) == wall(meshes[1].mesh));
    if (smoothing == 0) CHECK(measures_of(meshes[0].mesh).greatest[0] == 2.5);
    if (smoothing == 0) CHECK(measures_of(meshes[1].mesh).least[0] == 2.5);
  }
}

TEST_CASE("only requested labels are extracted, including label 0 and labels above 2^63") {
  const auto array = blocks();
  const auto meshes = label_meshes(array.view(), {}, {3, -1, 77});
  REQUIRE(meshes.size() >= 2);
  CHECK(meshes[0].label == -1);
  CHECK(meshes[1].label == 3);
  const std::vector<std::uint64_t> large{1, std::uint64_t{1} << 63};
  const auto found =
      label_meshes({large, {2, 1, 1}}, {}, {std::numeric_limits<std::int64_t>::min()});
  REQUIRE(found.size() == 1);
  CHECK(found[0].label == std::numeric_limits<std::int64_t>::min());
  CHECK(measures_of(found[0].mesh).least[0] == 0.5);
}
