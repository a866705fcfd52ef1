// Masks with closed gaps: extract --close.
#include "smoothing/closed_volume.hpp"

#include "command.hpp"
#include "oracle/volume.hpp"
#include "sample_reader.hpp"

namespace {

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

// Dilates and erodes by definition, in a volume that is larger by the distance on all sides.
struct Space {
  int margin;
  int extent[3];
  std::vector<std::uint8_t> on;

  std::size_t place(int x, int y, int z) const {
    return static_cast<std::size_t>(((z + margin) * (extent[1] + 2 * margin) + y + margin) *
                                        (extent[0] + 2 * margin) +
                                    x + margin);
  }
  bool holds(int x, int y, int z) const {
    const int at[] = {x, y, z};
    for (int axis = 0; axis < 3; ++axis)
      if (at[axis] < -margin || at[axis] >= extent[axis] + margin) return false;
    return true;
  }
  template <class Call>
  void for_each(int beyond, const Call& call) const {
    for (int z = -beyond; z < extent[2] + beyond; ++z)
      for (int y = -beyond; y < extent[1] + beyond; ++y)
        for (int x = -beyond; x < extent[0] + beyond; ++x) call(x, y, z);
  }
};

std::vector<std::uint8_t> expected(const BitVolume& volume, const Point& spacing_mm,
                                   double radius_mm) {
  const int margin = 6;
  Space before{margin,
               {static_cast<int>(volume.width), static_cast<int>(volume.height),
                static_cast<int>(volume.depth)},
               {}};
  before.on.resize((volume.width + 2 * margin) * (volume.height + 2 * margin) *
                   (volume.depth + 2 * margin));
  Space dilated = before;
  const auto for_each_near = [&](const auto& call) {
    for (int z = -margin; z <= margin; ++z)
      for (int y = -margin; y <= margin; ++y)
        for (int x = -margin; x <= margin; ++x)
          if (std::hypot(x * spacing_mm[0], y * spacing_mm[1], z * spacing_mm[2]) <=
              radius_mm + 1e-9)
            call(x, y, z);
  };
  before.for_each(0, [&](int x, int y, int z) {
    before.on[before.place(x, y, z)] =
        volume.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                  static_cast<std::uint32_t>(z));
  });
  before.for_each(0, [&](int x, int y, int z) {
    if (before.on[before.place(x, y, z)] == 0) return;
    for_each_near([&](int i, int j, int k) {
      if (dilated.holds(x + i, y + j, z + k)) dilated.on[dilated.place(x + i, y + j, z + k)] = 1;
    });
  });
  std::vector<std::uint8_t> result;
  before.for_each(0, [&](int x, int y, int z) {
    std::uint8_t on = 1;
    for_each_near([&](int i, int j, int k) {
      if (dilated.on[dilated.place(x + i, y + j, z + k)] == 0) on = 0;
    });
    result.push_back(on);
  });
  return result;
}

}  // namespace

TEST_CASE("closing equals its definition for any spacing and width of a row") {
  using discmc::reference::random;
  for (const double radius : {0.5, 1.0, 1.5, 2.3, 3.0}) {
    CHECK(closed(random({13, 9, 8}, 40, 1), {1, 1, 1}, radius) ==
          expected(random({13, 9, 8}, 40, 1), {1, 1, 1}, radius));
    CHECK(closed(random({70, 6, 5}, 25, 2), {1, -1.5, 0.8}, radius) ==
          expected(random({70, 6, 5}, 25, 2), {1, 1.5, 0.8}, radius));
    CHECK(closed(random({62, 3, 1}, 30, 3), {0.7, 1, 3}, radius) ==
          expected(random({62, 3, 1}, 30, 3), {0.7, 1, 3}, radius));
  }
  CHECK(closed(random({58, 4, 4}, 20, 4), {0.1, 1, 1}, 0.3) ==
        expected(random({58, 4, 4}, 20, 4), {0.1, 1, 1}, 0.3));
}

TEST_CASE("--close joins nearby parts before they are smoothed") {
  using command_tests::contains;
  const command_tests::Workshop workshop;
  BitVolume volume({24, 12, 12});
  sample_reader::put_box(volume, {3, 3, 3}, {10, 8, 8}, 1);
  sample_reader::put_box(volume, {13, 3, 3}, {20, 8, 8}, 1);
  workshop.write("v.nrrd", volume);
  const auto bodies = [&](const std::string& options) {
    workshop.done("extract v.nrrd --iso 100 -q " + options + " -o v.csv");
    const std::string table = workshop.read("v.csv");
    const std::string line = table.substr(table.find('\n') + 1);
    std::size_t at = 0;
    for (int comma = 0; comma < 3; ++comma) at = line.find(',', at) + 1;
    return line.substr(at, line.find(',', at) - at);
  };
  CHECK(bodies("") == "2");
  CHECK(bodies("--close 0.5") == "2");
  CHECK(bodies("--close 1") == "1");
  CHECK(bodies("--close 1 --smooth auto") == "1");
  workshop.done("extract v.nrrd --iso 100 --close 1 -o v.dmc");
  workshop.done("extract v.nrrd --iso 100 --close 1 --jobs 2 -o v.stl");
  for (const std::string refused :
       {"--close 0", "--close 1 --median 3", "--close 1 --surface interpolated",
        "--close 1 --iso 50", "--close 1 --normals gradient"})
    CHECK(workshop.run("extract v.nrrd --iso 100 " + refused + " -o '{name}.ply'").code == 2);
  CHECK(workshop.run("extract v.nrrd --labels all --close 1 -o '{name}.ply'").code == 2);
}
