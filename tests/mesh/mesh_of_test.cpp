// mesh_of() and meshes_of(): levels, sample types, and positions of vertices.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

TEST_CASE("a single voxel has an octahedron as its surface") {
  std::vector<int> samples(27);
  samples[13] = 5;
  const Mesh mesh = mesh_of(samples, {3, 3, 3}, 5);
  CHECK(mesh.vertices.size() == 6);
  CHECK(mesh.triangles.size() == 8);
  const MeshMeasures measures = measures_of(mesh);
  CHECK(measures.is_closed);
  CHECK(measures.volume == doctest::Approx(1.0 / 6));
  CHECK(measures.area == doctest::Approx(std::sqrt(3.0)));
  CHECK(measures.least == std::array<double, 3>{0.5, 0.5, 0.5});
  CHECK(measures.centre[0] == doctest::Approx(1));
}

TEST_CASE_TEMPLATE("equal samples of every type yield the same triangles", Sample, std::int8_t,
                   std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t,
                   std::int64_t, std::uint64_t, float, double, long long, char) {
  // Whole numbers, so that no type rounds them.
  const auto whole = ball<std::int8_t>();
  Array<Sample> array{whole.size, {whole.samples.begin(), whole.samples.end()}};
  const std::vector<Triangle> expected = triangles_of(mesh_of(whole.view(), ball_level));
  REQUIRE(expected.size() > 100);
  CHECK(triangles_of(mesh_of(array.samples, array.extents(), ball_level)) == expected);
  CHECK(triangles_of(mesh_of(array.samples.data(), array.extents(), ball_level)) == expected);
  // With fractions, values lie between samples of 49 and 50.
  MeshOptions options;
  options.interpolates = true;
  const double level = std::is_integral_v<Sample> ? ball_level : ball_level - 0.5;
  const Mesh mesh = mesh_of(array.view(), level, options);
  const Mesh of_whole = mesh_of(whole.view(), ball_level, options);
  CHECK(mesh.triangles.size() == of_whole.triangles.size());
  CHECK(measures_of(mesh).volume == doctest::Approx(measures_of(of_whole).volume));
}

TEST_CASE("a volume of more than 32,760 slices has a closed mesh, and so has a label in it") {
  // A column, and a voxel beside it at either end.
  const auto measured = [](std::int64_t depth, unsigned threads) {
    std::vector<std::uint8_t> samples(static_cast<std::size_t>(2 * depth));
    for (std::size_t i = 0; i < samples.size(); i += 2) samples[i] = 1;
    samples[1] = samples.back() = 1;
    MeshOptions options;
    options.threads = threads;
    return measures_of(mesh_of(samples, {2, 1, depth}, 1, options));
  };
  const MeshMeasures low = measured(100, 1), high = measured(200, 1);
  constexpr std::int64_t depth = 33000;
  for (const unsigned threads : {1U, 2U}) {
    const MeshMeasures deep = measured(depth, threads);
    CHECK(deep.is_closed);
    CHECK(deep.greatest[2] == depth - 0.5);
    CHECK(deep.volume == doctest::Approx(low.volume + (high.volume - low.volume) * 329));
  }
  const Array<std::uint8_t> column{{1, 1, depth}, std::vector<std::uint8_t>(depth, 1)};
  const MeshMeasures label = measures_of(label_meshes(column.view()).at(0).mesh);
  CHECK(label.is_closed);
  CHECK(label.greatest[2] == depth - 0.5);
}

TEST_CASE("every test volume has a closed mesh with outward triangles") {
  for (const auto& array : bit_volumes()) {
    const Mesh mesh = mesh_of(array.view(), 1);
    const MeshMeasures measures = measures_of(mesh);
    CHECK(measures.is_closed);
    CHECK(measures.volume > 0);
    CHECK(signed_volume(mesh) == doctest::Approx(measures.volume));
  }
}

TEST_CASE("vertices of an interpolated ball are within the tolerance of the exact sphere") {
  const auto array = ball<double>();
  MeshOptions options;
  options.interpolates = true;
  options.tolerance = 0.02;
  const Mesh mesh = mesh_of(array.view(), ball_level, options);
  CHECK(measures_of(mesh).is_closed);
  for (const auto& vertex : mesh.vertices) {
    const auto from = difference(vertex, ball_centre);
    // Linear interpolation between voxels has an error of 1 / (8 radius).
    CHECK(std::abs(std::sqrt(dot(from, from)) - ball_radius) < 0.02 + 1 / (8 * ball_radius));
  }
  const double sphere = 4 / 3.0 * std::acos(-1) * std::pow(ball_radius, 3);
  CHECK(measures_of(mesh).volume == doctest::Approx(sphere).epsilon(0.02));
}

TEST_CASE("a range of levels encloses the samples from low to high, both ends included") {
  const auto array = array_of<std::int16_t>(
      {9, 3, 3}, [](auto x, auto y, auto z) { return y == 1 && z == 1 ? x : -1; });
  const auto extent = [&](const Level& level) {
    const MeshMeasures measures = measures_of(mesh_of(array.view(), level));
    return std::array<double, 2>{measures.least[0], measures.greatest[0]};
  };
  CHECK(extent({3, 5}) == std::array<double, 2>{2.5, 5.5});
  CHECK(extent({2.5, 4.5}) == std::array<double, 2>{2.5, 4.5});
  CHECK(extent({7, 7}) == std::array<double, 2>{6.5, 7.5});
  CHECK(extent(7) == std::array<double, 2>{6.5, 8.5});
}

TEST_CASE("NaN samples are outside for a level and for a range") {
  std::vector<float> samples(27, std::numeric_limits<float>::quiet_NaN());
  samples[13] = 1;
  CHECK(mesh_of(samples, {3, 3, 3}, 0).triangles.size() == 8);
  CHECK(mesh_of(samples, {3, 3, 3}, {0, 2}).triangles.size() == 8);
}

TEST_CASE("several levels in one pass yield the mesh of each level, in the given order") {
  const auto array = ball<float>();
  for (const bool interpolates : {false, true}) {
    MeshOptions options;
    options.interpolates = interpolates;
    const std::vector<Level> levels{50, {40, 60}, 30};
    const std::vector<Mesh> meshes = meshes_of(array.view(), levels, options);
    REQUIRE(meshes.size() == 3);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(triangles_of(meshes[i]) == triangles_of(mesh_of(array.view(), levels[i], options)));
  }
  CHECK(meshes_of(array.view(), {}).empty());
}

TEST_CASE("a level above all samples yields an empty mesh") {
  const Mesh mesh = mesh_of(std::vector<int>(27), {3, 3, 3}, 1);
  CHECK(mesh.vertices.empty());
  CHECK(mesh.triangles.empty());
  CHECK(measures_of(mesh).area == 0);
}

TEST_CASE("a mesh is open at the ends of the array with an open border, and closed otherwise") {
  const std::vector<int> samples(8, 1);
  MeshOptions options;
  CHECK(measures_of(mesh_of(samples, {2, 2, 2}, 1)).is_closed);
  options.border = Border::open;
  CHECK(mesh_of(samples, {2, 2, 2}, 1, options).triangles.empty());
  std::vector<int> half{1, 0, 1, 0, 1, 0, 1, 0};
  CHECK(mesh_of(half, {2, 2, 2}, 1, options).triangles.size() == 2);
}

TEST_CASE("decimation yields the requested number of triangles and a closed mesh") {
  const auto array = ball<float>();
  MeshOptions options;
  options.interpolates = true;
  const Mesh whole = mesh_of(array.view(), ball_level, options);
  options.triangles = 300;
  const Mesh mesh = mesh_of(array.view(), ball_level, options);
  CHECK(mesh.triangles.size() <= 300);
  CHECK(mesh.triangles.size() >= 299);
  CHECK(measures_of(mesh).is_closed);
  CHECK(measures_of(mesh).volume == doctest::Approx(measures_of(whole).volume).epsilon(1e-5));
}

TEST_CASE("smoothing removes the steps of a mask and preserves the volume") {
  const auto mask = array_of<std::uint8_t>(ball_size, [](auto x, auto y, auto z) {
    const std::array<double, 3> voxel{static_cast<double>(x), static_cast<double>(y),
                                      static_cast<double>(z)};
    const auto from = difference(voxel, ball_centre);
    return dot(from, from) <= ball_radius * ball_radius ? 1 : 0;
  });
  const double sphere = 4 / 3.0 * std::acos(-1) * std::pow(ball_radius, 3);
  MeshOptions options;
  options.smoothing = 1;
  const MeshMeasures measures = measures_of(mesh_of(mask.view(), 1, options));
  CHECK(measures.is_closed);
  CHECK(measures.volume == doctest::Approx(sphere).epsilon(0.03));
  const double area = 4 * std::acos(-1) * ball_radius * ball_radius;
  CHECK(measures.area == doctest::Approx(area).epsilon(0.03));
}

TEST_CASE("surface normals and gradient normals are unit vectors that point outwards") {
  const auto array = ball<float>();
  for (const Normals normals : {Normals::surface, Normals::gradient})
    for (const bool interpolates : {false, true}) {
      MeshOptions options;
      options.normals = normals;
      options.interpolates = interpolates;
      const Mesh mesh = mesh_of(array.view(), ball_level, options);
      REQUIRE(mesh.normals.size() == mesh.vertices.size());
      for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        CHECK(dot(mesh.normals[i], mesh.normals[i]) == doctest::Approx(1));
        const auto from = difference(mesh.vertices[i], ball_centre);
        const double cosine = dot(mesh.normals[i], from) / std::sqrt(dot(from, from));
        CHECK(cosine > (normals == Normals::gradient ? 0.99 : 0.8));
      }
    }
}

TEST_CASE("smoothing by a tiny distance leaves the mesh unchanged") {
  MeshOptions options;
  options.smoothing = 1e-300;
  const std::vector<int> samples(27, 1);
  const Mesh mesh = mesh_of(samples, {3, 3, 3}, 1, options);
  CHECK(triangles_of(mesh) == triangles_of(mesh_of(samples, {3, 3, 3}, 1)));
}

TEST_CASE("gradient normals of infinite samples and levels are unit vectors") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values{1, std::nan(""), infinity, -infinity, 1e308, -1e308};
  std::vector<double> samples;
  for (std::size_t i = 0; i < 64; ++i) samples.push_back(values[i * i % 7 % 6]);
  MeshOptions options;
  options.normals = Normals::gradient;
  for (const double level : {-infinity, infinity, 1e308, -1e308, 0.0})
    for (const auto& normal : mesh_of(samples, {4, 4, 4}, level, options).normals)
      CHECK(dot(normal, normal) == doctest::Approx(1));
}

TEST_CASE(
    "a Gaussian far wider than the array yields a closed mesh with the volume of the voxels") {
  const auto array = ball<std::uint8_t>();
  std::vector<std::uint8_t> mask;
  double voxels = 0;
  for (const auto& sample : array.samples) {
    mask.push_back(sample >= ball_level ? 1 : 0);
    voxels += mask.back();
  }
  for (const double deviation : {1.0, 30.0, 1e4, 1e6}) {
    MeshOptions options;
    options.smoothing = deviation;
    const MeshMeasures measures = measures_of(mesh_of(mask, array.extents(), 1, options));
    CHECK(measures.is_closed);
    CHECK(measures.bodies == 1);
    CHECK(measures.volume == doctest::Approx(voxels).epsilon(0.01));
  }
}
