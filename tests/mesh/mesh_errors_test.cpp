// Errors: each message names the value and the remedy.
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;

namespace {

const std::vector<int> samples(27);

template <class Call>
std::string message_of(Call call) {
  try {
    (void)call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

std::string mesh_error(const std::array<std::int64_t, 3>& size, const Level& level = 1,
                       const MeshOptions& options = {}) {
  return message_of(
      [&] { return mesh_of(samples, Extents(size[0], size[1], size[2]), level, options); });
}
std::string label_error(const MeshOptions& options) {
  return message_of([&] { return label_meshes({samples, {3, 3, 3}}, options); });
}

template <class Set>
std::string refusal(Set set) {
  MeshOptions options;
  set(options);
  return mesh_error({3, 3, 3}, 1, options);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("wrong extents, a wrong number of samples or a null pointer is refused with the reason") {
  CHECK(mesh_error({0, 3, 3}) == "an extent is 0; give 1 to 1073741823 voxels");
  CHECK(has(mesh_error({3, -3, 3}), "-3"));
  CHECK(mesh_error({3, 3, 4}) == "the vector has 27 samples, and the extents 3 x 3 x 4 need 36");
  const int* const none = nullptr;
  CHECK(message_of([&] {
          return mesh_of(none, {3, 3, 3}, 1);
        }) == "the pointer to the samples is null");
  CHECK(has(mesh_error({1 << 29, 1 << 29, 1 << 29}), "divide the array"));
  const std::vector<char> flat(1);
  const std::string text = message_of([&] {
    return mesh_of(Samples(flat.data(), {40000, 40000, 2}, Strides{0, 0, 0}), 1);
  });
  CHECK(has(text, "40000 x 40000 x 2"));
  CHECK(has(text, "divide the array"));
}

TEST_CASE("a NaN level or a reversed range is refused, and the error contains the value") {
  CHECK(has(mesh_error({3, 3, 3}, {5, 2}), "from 5 to 2"));
  CHECK(has(mesh_error({3, 3, 3}, std::nan("")), "the level is nan; give a number"));
}

TEST_CASE("options out of range are refused by name") {
  CHECK(has(refusal([](auto& options) { options.spacing[1] = 0; }), "spacing is 1, 0, 1;"));
  CHECK(has(refusal([](auto& options) { options.spacing[1] = 1e-7; }), "1, 1e-07, 1"));
  CHECK(has(refusal([](auto& options) { options.spacing[2] = 1e7; }), "1e-6 to 1e6"));
  CHECK(has(refusal([](auto& options) { options.placement.emplace(); }), "span no space"));
  CHECK(has(refusal([](auto& options) {
              options.placement = {{{1, 0, 0, 0}, {0, 1, 0, 2e9}, {0, 0, 1, 0}}};
            }),
            "origin of the placement is 0, 2e+09, 0; give coordinates of -1e9 to 1e9"));
  CHECK(has(refusal([](auto& options) { options.tolerance = -1; }), "tolerance is -1"));
  CHECK(has(refusal([](auto& options) { options.smoothing = std::nan(""); }), "smoothing is nan"));
  CHECK(has(refusal([](auto& options) { options.smoothing = 2e6; }), "smoothing is 2000000; give"));
  CHECK(has(
      refusal([](auto& options) { options.max_error = std::numeric_limits<double>::infinity(); }),
      "max_error is inf"));
}

TEST_CASE("contradictory options are refused by name") {
  CHECK(has(refusal([](auto& options) { options.polygons = options.interpolates = true; }),
            "or the polygons"));
  CHECK(has(refusal([](auto& options) { options.polygons = options.relaxes = true; }),
            "or the polygons"));
  CHECK(has(refusal([](auto& options) { options.interpolates = options.relaxes = true; }),
            "relaxation uses no samples"));
  CHECK(has(refusal([](auto& options) {
              options.smoothing = 1;
              options.normals = Normals::gradient;
            }),
            "ask for surface normals"));
  MeshOptions gradient;
  gradient.normals = Normals::gradient;
  CHECK(has(mesh_error({3, 3, 3}, {1, 2}, gradient), "without a high end"));
  MeshOptions smooth;
  smooth.smoothing = 1;
  CHECK(has(message_of([&] {
              return meshes_of({samples, {3, 3, 3}}, {1, 2}, smooth);
            }),
            "extract each by itself"));
}

TEST_CASE(
    "labels refuse fractional samples, gradient normals, and interpolation without smoothing") {
  const std::vector<float> fractions(27);
  CHECK(has(message_of([&] { return label_meshes({fractions, {3, 3, 3}}); }), "integer type"));
  MeshOptions options;
  options.normals = Normals::gradient;
  CHECK(has(label_error(options), "surface normals"));
  options = {};
  options.interpolates = true;
  CHECK(has(label_error(options), "smoothing"));
  options = {};
  options.relaxes = true;
  CHECK(has(label_error(options), "walls"));
}

TEST_CASE(
    "a builder refuses options that read slices twice, other sample types, and wrong extents") {
  MeshOptions options;
  options.smoothing = 1;
  CHECK(has(message_of([&] { return MeshBuilder(3, 3, 1, options); }),
            "neither smoothing nor gradient"));
  CHECK(has(message_of([] { return MeshBuilder(3, 32767, 1); }), "32767; give 1 to 32766"));
  CHECK(has(message_of([] {
              MeshBuilder builder(3, 3, 1);
              builder.add_slice(samples.data());
              builder.add_slice(std::vector<float>(9).data());
              return builder;
            }),
            "slices of one type"));
  CHECK(has(message_of([] { return MeshBuilder(3, 3, {5, 2}); }), "from 5 to 2"));
  CHECK(has(message_of([] { return MeshBuilder(3, 3, std::nan("")); }), "nan"));
  CHECK(has(message_of([] {
              MeshBuilder builder(3, 3, 1);
              builder.add_slice(static_cast<const float*>(nullptr));
              return builder;
            }),
            "is null"));
}
