// discmc extract and render with a mask.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "command.hpp"
#include "oracle/stream.hpp"
#include "oracle/volume.hpp"
#include "sampled_field.hpp"

namespace {

using namespace command_tests;
using discmc::reference::Size;

constexpr Size size = {9, 8, 7};
constexpr std::size_t voxels = 9 * 8 * 7;
const std::string layout = " --dims 9,8,7 --type u8 ";

std::string nrrd_of(const std::string& samples, const std::string& sizes = "9 8 7") {
  return volume_files::nrrd(volume_files::nrrd_u8, sizes) + "\n" + samples;
}

// Noise, and a mask of blocks of 2 x 2 x 2 voxels; as v.raw and m.nrrd.
struct Masked {
  std::string samples, mask;

  explicit Masked(const Workshop& workshop) {
    discmc::test::Chance chance(7);
    std::vector<char> blocks(5 * 4 * 4);
    for (char& block : blocks) block = static_cast<char>(chance.below(3));
    for (std::size_t i = 0; i < voxels; ++i) {
      samples += static_cast<char>(chance.below(256));
      const std::size_t x = i % size.width, y = i / size.width % size.height,
                        z = i / (size.width * size.height);
      mask += blocks[(z / 2 * 4 + y / 2) * 5 + x / 2];
    }
    workshop.write("v.raw", samples);
    workshop.write("m.nrrd", nrrd_of(mask));
  }

  // The volume in which what is masked has another value.
  std::string with_value(unsigned char value) const {
    std::string result = samples;
    for (std::size_t i = 0; i < voxels; ++i)
      if (mask[i] == 0) result[i] = static_cast<char>(value);
    return result;
  }
};

}  // namespace

TEST_CASE("all labels with a mask are as many meshes as if each were asked for with it") {
  const Workshop workshop;
  Masked masked(workshop);
  for (char& sample : masked.samples) sample = static_cast<char>(sample & 3);
  workshop.write("v.nrrd", nrrd_of(masked.samples));
  workshop.done("extract v.nrrd --labels all --mask m.nrrd -o 'all-{name}.stl'");
  workshop.done("extract v.nrrd --label 1 --label 2 --label 3 --mask m.nrrd -o 'one-{name}.stl'");
  for (const std::string label : {"1.stl", "2.stl", "3.stl"})
    CHECK(workshop.read("all-" + label) == workshop.read("one-" + label));
  const std::string refused = "extract v.nrrd --labels all --mask m.nrrd -o '{name}.stl' ";
  check_failure(workshop.run(refused + "--median 3"), 2, {"labels are masked before"});
  // Values from 1 on: none of them is 0.
  std::string samples = masked.samples;
  workshop.write("v.nii", volume_files::Nifti().dims({3, 9, 8, 7}).scale(1, 1).file(samples));
  check_failure(workshop.run("extract v.nii --labels all --mask m.nrrd -o '{name}.stl'"), 1,
                {"no sample has the value 0"});
  // The largest sample, and a half, stand for 0.
  std::string floats;
  for (char& sample : samples) {
    const float value = static_cast<float>(sample) + 0.5F;
    floats.append(reinterpret_cast<const char*>(&value), sizeof value);
    sample = static_cast<char>(255 - sample);
  }
  const auto nifti = [] { return volume_files::Nifti().dims({3, 9, 8, 7}); };
  workshop.write("255.nii", nifti().scale(1, -255).file(samples));
  workshop.write("half.nii", nifti().type(16).scale(1, -0.5F).file(floats));
  for (const std::string name : {"255", "half"})
    workshop.done("extract " + name + ".nii --labels all --mask m.nrrd --space voxel -o '" + name +
                  "-{name}.stl'");
  CHECK(workshop.read("half-1.stl") == workshop.read("all-1.stl"));
  CHECK(workshop.shell("ls 255-*").out == "255--1.stl\n255--2.stl\n255--3.stl\n");
}

TEST_CASE("what the mask has as 0 is off, whatever is selected") {
  const Workshop workshop;
  const Masked masked(workshop);
  workshop.write("least.raw", masked.with_value(0));
  workshop.write("most.raw", masked.with_value(255));
  const auto same = [&](const std::string& options, const std::string& other) {
    INFO(options);
    workshop.done("extract v.raw --mask m.nrrd -q -o masked.jsonl" + layout + options);
    workshop.done("extract " + other + " -q -o v.jsonl" + layout + options);
    CHECK(workshop.read("masked.jsonl") == workshop.read("v.jsonl"));
    CHECK(!workshop.read("v.jsonl").empty());
  };
  same("--iso 100", "least.raw");
  same("--iso 100 --border open", "least.raw");
  same("--range 0..99", "most.raw");
  same("--iso 100 --crop 2..7,1..,..5", "least.raw");
  same("--iso 100 --shrink 2", "least.raw");
  same("--iso 100 --crop 2..,2..,2.. --shrink 2", "least.raw");
}

TEST_CASE("a mask is of streams of both kinds, of all surfaces and of pictures") {
  const Workshop workshop;
  const Masked masked(workshop);
  workshop.write("least.raw", masked.with_value(0));
  const std::string with_mask = "v.raw --mask m.nrrd --iso 100 ", without = "least.raw --iso 100 ";
  for (const std::string wire : {"regions", "slices"}) {
    const std::string options = layout + "--iso 50 --wire " + wire;
    const std::string told = workshop.done("extract " + with_mask + "-o v.dmc" + options);
    const std::string masked_stream = workshop.read("v.dmc");
    CHECK(told == workshop.done("extract " + without + "-o v.dmc" + options));
    CHECK(masked_stream == workshop.read("v.dmc"));
  }
  workshop.done("render " + with_mask + "--size 64,64 -o masked.png" + layout);
  workshop.done("render " + without + "--size 64,64 -o v.png" + layout);
  CHECK(workshop.read("masked.png") == workshop.read("v.png"));
  workshop.done("render " + with_mask + "--size 64,64 --shade smooth -o smooth.png" + layout);
}

TEST_CASE("the filter of bits does not fill what the mask has as 0") {
  const Workshop workshop;
  const auto box = discmc::reference::box({12, 12, 12}, {2, 2, 2}, {9, 9, 9});
  workshop.write("v.nrrd", box);
  std::string mask(12 * 12 * 12, '\1');
  mask[(6 * 12 + 5) * 12 + 5] = '\0';
  workshop.write("m.nrrd", nrrd_of(mask, "12 12 12"));
  const auto lines = [&](const std::string& options) {
    workshop.done("extract v.nrrd --iso 100 --median 3 -q -o v.jsonl " + options);
    const std::string text = workshop.read("v.jsonl");
    return std::count(text.begin(), text.end(), '\n');
  };
  constexpr int of_voxel = 8;
  CHECK(lines("--mask m.nrrd") == lines("") + of_voxel);
}

TEST_CASE("an interpolated surface is flat where the mask ends, and where it was otherwise") {
  const Workshop workshop;
  std::string samples, mask;
  for (const int sample : sampled_field::ball(14, 5.3).samples)
    samples += static_cast<char>(sample);
  for (int i = 0; i < 14 * 14 * 14; ++i) mask += i % 14 < 6 ? '\1' : '\0';
  workshop.write("v.nrrd", nrrd_of(samples, "14 14 14"));
  workshop.write("m.nrrd", nrrd_of(mask, "14 14 14"));
  workshop.done("extract v.nrrd --mask m.nrrd --iso 50 --surface interpolated -q -o v.obj");
  const Mesh mesh = mesh_of_obj(workshop.read("v.obj"));
  CHECK(check_mesh(mesh).closed());
  constexpr double cap = 4.3;  // high, of a ball of 5.3
  CHECK(volume_of(mesh) == doctest::Approx(3.14159 * cap * cap * (5.3 - cap / 3)).epsilon(0.05));
  std::size_t flat = 0;
  for (const Point& vertex : mesh.vertices_mm) {
    CHECK(vertex[0] <= 5.5);
    if (vertex[0] == 5.5) ++flat;
    const double radius = std::hypot(vertex[0] - 6.5, vertex[1] - 6.5, vertex[2] - 6.5);
    if (vertex[0] < 4.9) CHECK(std::fabs(radius - 5.3) < 0.15);
  }
  CHECK(flat > 4);
}

TEST_CASE("a mask that does not fit is refused, and one that lies elsewhere told") {
  const Workshop workshop;
  const Masked masked(workshop);
  workshop.write("other.nrrd", nrrd_of(masked.mask, "7 8 9"));
  workshop.write("far.nrrd",
                 volume_files::nrrd(volume_files::nrrd_u8 + "spacings: 1 1 2\n", "9 8 7") + "\n" +
                     masked.mask);
  const auto names = workshop.names();
  const std::string extract = "extract v.raw --iso 100 -q" + layout;
  check_failure(workshop.run(extract + "-o v.stl --mask other.nrrd"), 1,
                {"other.nrrd", "7 x 8 x 9", "9 x 8 x 7"});
  check_failure(workshop.run(extract + "-o v.stl --mask none.nrrd"), 1, {"none.nrrd"});
  check_failure(workshop.run(extract + "-o v.stl --mask -"), 2, {"--mask", "standard input"});
  for (const std::string name : {"v.dmc", "v.ply"})
    check_failure(workshop.run(extract + "--mask m.nrrd --normals gradient -o " + name), 2,
                  {"--mask", "--normals surface"});
  check_failure(workshop.run("render v.raw --iso 1 --classic --mask m.nrrd -o v.png" + layout), 2,
                {"--classic", "--mask"});
  CHECK(workshop.names() == names);
  const Result far = workshop.run(extract + "--mask far.nrrd -o far.jsonl");
  CHECK(far.code == 0);
  CHECK(contains(far.error, "far.nrrd: its voxels lie up to 6 mm from those of the volume"));
  workshop.done(extract + "--mask m.nrrd -o v.jsonl");
  CHECK(workshop.read("far.jsonl") == workshop.read("v.jsonl"));
}
