// MeshBuilder: slices one by one.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;

namespace {

template <class Sample>
Mesh built(const Array<Sample>& array, const Level& level, const MeshOptions& options) {
  MeshBuilder builder(array.size[0], array.size[1], level, options);
  std::vector<Sample> slice;
  for (auto at = array.samples.begin(); at != array.samples.end();) {
    const auto end = at + array.size[0] * array.size[1];
    slice.assign(at, end);  // a slice may be freed when the call returns
    builder.add_slice(slice.data());
    at = end;
  }
  return builder.finish();
}

}  // namespace

TEST_CASE("slices added one by one yield the same mesh as the whole array") {
  MeshOptions options;
  for (const auto& array : bit_volumes())
    CHECK(triangles_of(built(array, 1, options)) == triangles_of(mesh_of(array.view(), 1)));
  const auto array = ball<float>();
  options.relaxes = true;
  CHECK(triangles_of(built(array, ball_level, options)) ==
        triangles_of(mesh_of(array.view(), ball_level, options)));
  options.relaxes = false;
  options.interpolates = true;
  options.spacing = {1, 2, -3};
  options.border = Border::open;
  const Level level(30, 60);
  CHECK(triangles_of(built(array, level, options)) ==
        triangles_of(mesh_of(array.view(), level, options)));
}

TEST_CASE("a builder without slices yields an empty mesh") {
  CHECK(MeshBuilder(4, 5, 1).finish().triangles.empty());
}

TEST_CASE("a builder refuses slice 32,761, and still finishes the surface of those before") {
  constexpr int most = 32760;
  MeshBuilder builder(1, 1, 1);
  const std::uint8_t on = 1;
  for (int z = 0; z < most; ++z) builder.add_slice(&on);
  CHECK_THROWS_WITH_AS(builder.add_slice(&on), doctest::Contains("at most 32760; finish it"),
                       std::length_error);
  const MeshMeasures measures = measures_of(builder.finish());
  CHECK(measures.is_closed);
  CHECK(measures.greatest[2] == most - 0.5);
}

TEST_CASE("a finished or moved-from builder refuses every call") {
  const std::vector<float> slice(20);
  MeshBuilder builder(4, 5, 1);
  builder.add_slice(slice.data());
  MeshBuilder other = std::move(builder);
  (void)other.finish();
  for (MeshBuilder* const each : {&builder, &other}) {
    CHECK_THROWS_WITH_AS(each->add_slice(slice.data()), doctest::Contains("construct another"),
                         std::logic_error);
    CHECK_THROWS_WITH_AS((void)each->finish(), doctest::Contains("construct another"),
                         std::logic_error);
  }
}

TEST_CASE("a builder moved between slices continues its mesh") {
  const auto array = array_of(discmc::reference::box({5, 5, 2}, {1, 1, 0}, {3, 3, 1}));
  MeshBuilder first(5, 5, 1);
  first.add_slice(array.samples.data());
  MeshBuilder second = std::move(first);
  second.add_slice(array.samples.data() + 25);
  CHECK(triangles_of(second.finish()) == triangles_of(mesh_of(array.view(), 1)));
}
