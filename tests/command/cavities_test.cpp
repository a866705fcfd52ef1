// Filled cavities: --fill.
#include "command.hpp"
#include "sample_reader.hpp"
#include "surface/components.hpp"

namespace {

using command_tests::Workshop;
using discmc::meshing::Component;
using discmc::meshing::Surface;
using discmc::reference::BitVolume;
using sample_reader::put_box;
using sample_reader::surface_of;

std::vector<double> volumes_after_filling(const BitVolume& volume) {
  Surface surface = surface_of(volume);
  keep_components(surface, {0, 0, true});
  std::vector<double> volumes;
  for (const Component& component : components(surface)) volumes.push_back(component.volume_mm3);
  return volumes;
}

BitVolume block() {
  BitVolume volume({20, 20, 20});
  put_box(volume, {2, 2, 2}, {17, 17, 17}, 1);
  return volume;
}

}  // namespace

TEST_CASE("filling a cavity removes the bodies inside the cavity") {
  const double whole = components(surface_of(block())).at(0).volume_mm3;
  BitVolume volume = block();
  put_box(volume, {4, 4, 4}, {15, 15, 15}, 0);
  put_box(volume, {6, 6, 6}, {13, 13, 13}, 1);
  put_box(volume, {8, 8, 8}, {10, 10, 10}, 0);
  put_box(volume, {9, 9, 9}, {9, 9, 9}, 1);
  REQUIRE(components(surface_of(volume)).size() == 5);
  const std::vector<double> left = volumes_after_filling(volume);
  REQUIRE(left.size() == 1);
  CHECK(left[0] == doctest::Approx(whole));
}

TEST_CASE(
    "filling a cavity keeps a body outside the cavity, even within the cavity's bounding box") {
  BitVolume volume({20, 20, 20});
  // A cavity with three arms, and a body outside, between the arms.
  put_box(volume, {0, 0, 0}, {19, 6, 6}, 1);
  put_box(volume, {0, 0, 0}, {6, 19, 6}, 1);
  put_box(volume, {0, 0, 0}, {6, 6, 19}, 1);
  put_box(volume, {2, 2, 2}, {17, 4, 4}, 0);
  put_box(volume, {2, 2, 2}, {4, 17, 4}, 0);
  put_box(volume, {2, 2, 2}, {4, 4, 17}, 0);
  put_box(volume, {10, 10, 10}, {12, 12, 12}, 1);
  CHECK(components(surface_of(volume)).size() == 3);
  CHECK(volumes_after_filling(volume).size() == 2);
}

TEST_CASE("--fill leaves a hollow that is open at the border of the volume") {
  BitVolume volume = block();
  put_box(volume, {8, 8, 8}, {10, 10, 19}, 0);
  const double before = components(surface_of(volume)).at(0).volume_mm3;
  CHECK(volumes_after_filling(volume) == std::vector<double>{before});
}

TEST_CASE_FIXTURE(Workshop, "--fill removes cavities from a mesh") {
  BitVolume volume = block();
  write("whole.nrrd", volume);
  put_box(volume, {5, 5, 5}, {9, 9, 9}, 0);
  write("v.nrrd", volume);
  done("extract whole.nrrd --iso 100 -o whole.stl");
  const auto result = run("extract v.nrrd --iso 100 --fill -o v.stl");
  CHECK(read("v.stl") == read("whole.stl"));
  CHECK(command_tests::contains(result.error, "1 of 2 bodies and cavities are kept"));
  CHECK(command_tests::contains(run("extract v.nrrd --iso 100 --fill -o v.dmc").error, "--fill"));
  CHECK(command_tests::contains(run("extract v.nrrd --iso 100 --fill --border open -o v.stl").error,
                                "encloses no volume"));
}
