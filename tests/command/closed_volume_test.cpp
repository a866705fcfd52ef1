// Masks with closed gaps: extract --close.
#include "smoothing/closed_volume.hpp"

#include "command.hpp"
#include "sample_reader.hpp"

namespace {

using command_tests::Workshop;
using discmc::meshing::ClosedVolume;
using discmc::meshing::Point;
using discmc::reference::BitVolume;
using sample_reader::bit_threshold;
using sample_reader::SampleReader;

std::vector<std::uint8_t> closed(const BitVolume& volume, const Point& spacing_mm,
                                 double radius_mm) {
  SampleReader reader(volume, spacing_mm);
  ClosedVolume closing(reader, {bit_threshold}, nullptr, radius_mm);
  std::vector<std::uint8_t> samples(volume.voxels());
  const std::size_t slice = std::size_t{volume.width} * volume.height;
  for (std::size_t at = 0; at < samples.size(); at += slice)
    closing.read_slice(samples.data() + at);
  return samples;
}

// Dilates and erodes by definition, also beyond the border.
std::vector<std::uint8_t> expected(const BitVolume& volume, const Point& spacing_mm,
                                   double radius_mm) {
  using Voxel = std::array<int, 3>;
  constexpr int farthest = 6;
  const auto for_each_near = [&](const Voxel& at, const auto& call) {
    for (int z = -farthest; z <= farthest; ++z)
      for (int y = -farthest; y <= farthest; ++y)
        for (int x = -farthest; x <= farthest; ++x)
          if (std::hypot(x * spacing_mm[0], y * spacing_mm[1], z * spacing_mm[2]) <=
              radius_mm + 1e-9)
            call({at[0] + x, at[1] + y, at[2] + z});
  };
  const auto for_each_voxel = [&](const auto& call) {
    for (int z = 0; z < static_cast<int>(volume.depth); ++z)
      for (int y = 0; y < static_cast<int>(volume.height); ++y)
        for (int x = 0; x < static_cast<int>(volume.width); ++x) call(Voxel{x, y, z});
  };
  std::set<Voxel> dilated;
  for_each_voxel([&](const Voxel& at) {
    if (volume.on[volume.index(at[0], at[1], at[2])] != 0)
      for_each_near(at, [&](const Voxel& near) { dilated.insert(near); });
  });
  std::vector<std::uint8_t> result;
  for_each_voxel([&](const Voxel& at) {
    std::uint8_t on = 1;
    for_each_near(at, [&](const Voxel& near) {
      if (dilated.count(near) == 0) on = 0;
    });
    result.push_back(on);
  });
  return result;
}

}  // namespace

TEST_CASE("closed() equals the definition of morphological closing for any spacing and row width") {
  using discmc::reference::random;
  const auto check = [](const BitVolume& volume, const Point& spacing_mm, double radius_mm) {
    CHECK(closed(volume, spacing_mm, radius_mm) == expected(volume, spacing_mm, radius_mm));
  };
  for (const double radius : {0.5, 1.0, 1.5, 2.3, 3.0}) {
    check(random({13, 9, 8}, 40, 1), {1, 1, 1}, radius);
    check(random({70, 6, 5}, 25, 2), {1, -1.5, 0.8}, radius);
    check(random({62, 3, 1}, 30, 3), {0.7, 1, 3}, radius);
  }
  check(random({58, 4, 4}, 20, 4), {0.1, 1, 1}, 0.3);
}

TEST_CASE_FIXTURE(Workshop, "--close joins nearby parts before they are smoothed") {
  using command_tests::contains;
  BitVolume volume({24, 12, 12});
  sample_reader::put_box(volume, {3, 3, 3}, {10, 8, 8}, 1);
  sample_reader::put_box(volume, {13, 3, 3}, {20, 8, 8}, 1);
  write("v.nrrd", volume);
  const auto bodies = [&](const std::string& options) {
    done("extract v.nrrd --iso 100 -q " + options + " -o v.csv");
    const std::string table = read("v.csv");
    const std::string line = table.substr(table.find('\n') + 1);
    std::size_t at = 0;
    for (int comma = 0; comma < 3; ++comma) at = line.find(',', at) + 1;
    return line.substr(at, line.find(',', at) - at);
  };
  CHECK(bodies("") == "2");
  CHECK(bodies("--close 0.5") == "2");
  CHECK(bodies("--close 1") == "1");
  CHECK(bodies("--close 1 --smooth auto") == "1");
  done("extract v.nrrd --iso 100 --close 1 -o v.dmc");
  done("extract v.nrrd --iso 100 --close 1 --jobs 2 -o v.stl");
  for (const std::string refused :
       {"--close 0", "--close 1 --median 3", "--close 1 --surface interpolated",
        "--close 1 --iso 50", "--close 1 --normals gradient"})
    CHECK(run("extract v.nrrd --iso 100 " + refused + " -o '{name}.ply'").code == 2);
  CHECK(run("extract v.nrrd --labels all --close 1 -o '{name}.ply'").code == 2);
}
