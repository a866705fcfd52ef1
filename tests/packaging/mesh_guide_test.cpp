// The code of docs/cpp.md: guide_test.cpp compares the page with it.
#include <doctest/doctest.h>

#include <cstdio>
#include <optional>
#include <string>

#include <discmc/mesh.hpp>

#include "oracle/slice_stream.hpp"

using namespace discmc;

namespace {

constexpr std::int64_t nx = 20, ny = 18, nz = 16;

std::vector<float> ball() {
  std::vector<float> samples;
  for (std::int64_t z = 0; z < nz; ++z)
    for (std::int64_t y = 0; y < ny; ++y)
      for (std::int64_t x = 0; x < nx; ++x)
        samples.push_back(
            static_cast<float>(549 - (x - 10) * (x - 10) - (y - 9) * (y - 9) - (z - 8) * (z - 8)));
  return samples;
}

// ---- the code of the guide ----

Mesh placed_mesh(const std::vector<float>& samples) {
  MeshOptions options;
  options.spacing = {0.5, 0.5, 1.25};  // millimetres
  options.interpolates = true;         // vertices where the samples cross the level
  options.normals = Normals::gradient;
  return mesh_of(samples, {nx, ny, nz}, 500, options);
}

Mesh mesh_of_slowest_x(const float* samples) {  // C order of an array [x][y][z]: z runs fastest
  return mesh_of(Samples(samples, {nx, ny, nz}, Strides{ny * nz, nz, 1}), 500);
}

Mesh mesh_of_slices(bool (*read)(float* slice)) {
  MeshBuilder builder(nx, ny, 500);
  std::vector<float> slice(nx * ny);
  while (read(slice.data())) builder.add_slice(slice.data());
  return builder.finish();
}

double label_volume(const std::vector<std::uint16_t>& samples, std::int64_t wanted) {
  for (const LabelMesh& each : label_meshes({samples, {nx, ny, nz}}))
    if (each.label == wanted) return measures_of(each.mesh).volume;
  return 0;
}

// Returns the mesh of each scan that has ended.
std::vector<Mesh> receive(MeshReceiver& receiver, const std::uint8_t* bytes, std::size_t count) {
  std::vector<Mesh> scans;
  for (std::size_t at = 0; at < count;) {
    at += receiver.push(bytes + at, count - at);
    if (!receiver.has_ended()) continue;
    if (!receiver.report().is_complete()) std::puts("a part of this scan was lost");
    scans.push_back(receiver.mesh());
  }
  return scans;  // receiver.mesh() is that of the scan so far
}

std::optional<Mesh> mesh_or_reason(const std::vector<float>& samples, std::string& reason) {
  try {
    return mesh_of(samples, {nx, ny, nz}, 500);
  } catch (const std::invalid_argument& error) {
    reason = error.what();  // "the vector has 5 samples, and the extents 20 x 18 x 16 need 5760"
  } catch (const std::bad_alloc&) {
    reason = "out of memory";
  }
  return std::nullopt;
}

// ---- the end of the code of the guide ----

int slices_read = 0;

}  // namespace

TEST_CASE("the page on C++: options, strides and slices yield meshes of the same volume") {
  const std::vector<float> samples = ball();
  const double volume = measures_of(mesh_of(samples, {nx, ny, nz}, 500)).volume;
  const Mesh placed = placed_mesh(samples);
  CHECK(measures_of(placed).volume / (0.5 * 0.5 * 1.25) == doctest::Approx(volume).epsilon(0.05));
  CHECK(placed.normals.size() == placed.vertices.size());

  std::vector<float> slowest_x;
  for (std::int64_t x = 0; x < nx; ++x)
    for (std::int64_t y = 0; y < ny; ++y)
      for (std::int64_t z = 0; z < nz; ++z)
        slowest_x.push_back(samples[static_cast<std::size_t>(x + nx * (y + ny * z))]);
  CHECK(measures_of(mesh_of_slowest_x(slowest_x.data())).volume == doctest::Approx(volume));

  slices_read = 0;
  const Mesh built = mesh_of_slices([](float* slice) {
    if (slices_read == nz) return false;
    const std::vector<float> all = ball();
    std::copy_n(all.begin() + nx * ny * slices_read++, nx * ny, slice);
    return true;
  });
  CHECK(measures_of(built).volume == doctest::Approx(volume));
}

TEST_CASE("the page on C++: a label has a volume") {
  std::vector<std::uint16_t> labels(nx * ny * nz, 0);
  labels[nx * ny + nx + 1] = 7;
  CHECK(label_volume(labels, 7) == doctest::Approx(1.0 / 6));
  CHECK(label_volume(labels, 8) == 0);
}

TEST_CASE("the page on C++: a receiver returns the mesh of each scan") {
  const auto volume = reference::random({8, 8, 8}, 128, 1);
  test::Bytes link = test::encode_slices(volume);
  const std::size_t first = link.size();
  link.insert(link.end(), link.begin(), link.begin() + static_cast<std::ptrdiff_t>(first));
  MeshReceiver receiver;
  CHECK(receive(receiver, link.data(), first / 2).empty());
  CHECK(receive(receiver, link.data() + first / 2, link.size() - first / 2).size() == 2);
}

TEST_CASE("the page on C++: an error contains the value and the remedy") {
  std::string reason;
  CHECK_FALSE(mesh_or_reason(std::vector<float>(5), reason));
  CHECK(reason == "the vector has 5 samples, and the extents 20 x 18 x 16 need 5760");
  CHECK(mesh_or_reason(ball(), reason));
}
