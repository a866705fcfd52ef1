// discmc extract and render with a mask.
#include "command.hpp"
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

// Noise as v.raw, and a mask of blocks of 2 x 2 x 2 voxels as m.nrrd.
struct Masked : Workshop {
  std::string samples, mask;

  Masked() {
    discmc::test::Chance chance(7);
    std::vector<char> blocks(5 * 4 * 4);
    for (char& block : blocks) block = static_cast<char>(chance.below(3));
    for (std::size_t i = 0; i < voxels; ++i) {
      samples += static_cast<char>(chance.below(256));
      const std::size_t x = i % size.width, y = i / size.width % size.height,
                        z = i / (size.width * size.height);
      mask += blocks[(z / 2 * 4 + y / 2) * 5 + x / 2];
    }
    write("v.raw", samples);
    write("m.nrrd", nrrd_of(mask));
  }

  std::string with_value(unsigned char value) const {
    std::string result = samples;
    for (std::size_t i = 0; i < voxels; ++i)
      if (mask[i] == 0) result[i] = static_cast<char>(value);
    return result;
  }
};

}  // namespace

TEST_CASE_FIXTURE(Masked, "--labels all with --mask writes the same meshes as each --label") {
  for (char& sample : samples) sample = static_cast<char>(sample & 3);
  write("v.nrrd", nrrd_of(samples));
  done("extract v.nrrd --labels all --mask m.nrrd -o 'all-{name}.stl'");
  done("extract v.nrrd --label 1 --label 2 --label 3 --mask m.nrrd -o 'one-{name}.stl'");
  for (const std::string label : {"1.stl", "2.stl", "3.stl"})
    CHECK(read("all-" + label) == read("one-" + label));
  const std::string refused = "extract v.nrrd --labels all --mask m.nrrd -o '{name}.stl' ";
  fails(refused + "--median 3", 2, {"grow labels over the mask"});
  // Values from 1 on. Masked voxels become 0, which no sample has.
  const auto nifti = [] { return volume_files::Nifti().dims({3, 9, 8, 7}); };
  for (char& sample : samples) sample = static_cast<char>(sample - 1);
  write("above.nii", nifti().type(256).scale(1, 1).file(samples));
  for (char& sample : samples) sample = static_cast<char>(sample + 1);
  // The largest sample and one half replace 0.
  std::string floats;
  for (char& sample : samples) {
    floats += volume_files::bytes_of(static_cast<float>(sample) + 0.5F);
    sample = static_cast<char>(255 - sample);
  }
  write("255.nii", nifti().scale(1, -255).file(samples));
  write("half.nii", nifti().type(16).scale(1, -0.5F).file(floats));
  for (const std::string name : {"255", "half", "above"})
    done("extract " + name + ".nii --labels all --mask m.nrrd --space voxel -o '" + name +
         "-{name}.stl'");
  CHECK(read("half-1.stl") == read("all-1.stl"));
  CHECK(read("above-1.stl") == read("all-1.stl"));
  CHECK(shell("ls 255-*").out == "255--1.stl\n255--2.stl\n255--3.stl\n");
}

TEST_CASE_FIXTURE(Masked, "voxels outside --mask are off for any selection") {
  write("least.raw", with_value(0));
  write("most.raw", with_value(255));
  const auto same = [&](const std::string& options, const std::string& other) {
    INFO(options);
    done("extract v.raw --mask m.nrrd -q -o masked.jsonl" + layout + options);
    done("extract " + other + " -q -o v.jsonl" + layout + options);
    CHECK(read("masked.jsonl") == read("v.jsonl"));
    CHECK(!read("v.jsonl").empty());
  };
  same("--iso 100", "least.raw");
  same("--iso 100 --border open", "least.raw");
  same("--range 0..99", "most.raw");
  same("--iso 100 --crop 2..7,1..,..5", "least.raw");
  same("--iso 100 --shrink 2", "least.raw");
  same("--iso 100 --crop 2..,2..,2.. --shrink 2", "least.raw");
}

TEST_CASE_FIXTURE(Masked, "--mask applies to streams of regions, streams of slices and pictures") {
  write("least.raw", with_value(0));
  const std::string with_mask = "v.raw --mask m.nrrd --iso 100 ", without = "least.raw --iso 100 ";
  for (const std::string wire : {"regions", "slices"}) {
    const std::string options = layout + "--iso 50 --wire " + wire;
    const std::string output = done("extract " + with_mask + "-o v.dmc" + options);
    const std::string masked_stream = read("v.dmc");
    CHECK(output == done("extract " + without + "-o v.dmc" + options));
    CHECK(masked_stream == read("v.dmc"));
  }
  done("render " + with_mask + "--size 64,64 -o masked.png" + layout);
  done("render " + without + "--size 64,64 -o v.png" + layout);
  CHECK(read("masked.png") == read("v.png"));
  done("render " + with_mask + "--size 64,64 --shade smooth -o smooth.png" + layout);
}

TEST_CASE_FIXTURE(Workshop, "--median does not turn on voxels outside the mask") {
  const auto box = discmc::reference::box({12, 12, 12}, {2, 2, 2}, {9, 9, 9});
  write("v.nrrd", box);
  std::string mask(12 * 12 * 12, '\1');
  mask[(6 * 12 + 5) * 12 + 5] = '\0';
  write("m.nrrd", nrrd_of(mask, "12 12 12"));
  const auto lines = [&](const std::string& options) {
    done("extract v.nrrd --iso 100 --median 3 -q -o v.jsonl " + options);
    return lines_in(read("v.jsonl"));
  };
  constexpr std::size_t of_voxel = 8;
  CHECK(lines("--mask m.nrrd") == lines("") + of_voxel);
}

TEST_CASE_FIXTURE(
    Workshop,
    "a mask cuts an interpolated surface flat and leaves the remaining surface unchanged") {
  std::string samples, mask;
  for (const int sample : sampled_field::ball(14, 5.3).samples)
    samples += static_cast<char>(sample);
  for (int i = 0; i < 14 * 14 * 14; ++i) mask += i % 14 < 6 ? '\1' : '\0';
  write("v.nrrd", nrrd_of(samples, "14 14 14"));
  write("m.nrrd", nrrd_of(mask, "14 14 14"));
  done("extract v.nrrd --mask m.nrrd --iso 50 --surface interpolated -q -o v.obj");
  const FileMesh mesh = mesh_in("v.obj");
  CHECK(check_mesh(mesh).is_closed());
  constexpr double cap = 4.3;  // the top of a ball of radius 5.3
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

TEST_CASE_FIXTURE(Masked, "a mask of another size is refused, and a displaced mask is reported") {
  write("other.nrrd", nrrd_of(mask, "7 8 9"));
  write("far.nrrd",
        volume_files::nrrd(volume_files::nrrd_u8 + "spacings: 1 1 2\n", "9 8 7") + "\n" + mask);
  const std::string extract = "extract v.raw --iso 100 -q" + layout;
  fails(extract + "-o v.stl --mask other.nrrd", 1, {"other.nrrd", "7 x 8 x 9", "9 x 8 x 7"});
  fails(extract + "-o v.stl --mask none.nrrd", 1, {"none.nrrd"});
  fails(extract + "-o v.stl --mask -", 2, {"--mask", "standard input"});
  for (const std::string name : {"v.dmc", "v.ply"})
    fails(extract + "--mask m.nrrd --normals gradient -o " + name, 2,
          {"--mask", "--normals surface"});
  fails("render v.raw --iso 1 --classic --mask m.nrrd -o v.png" + layout, 2,
        {"--classic", "--mask"});
  const Result far = run(extract + "--mask far.nrrd -o far.jsonl");
  CHECK(far.code == 0);
  CHECK(contains(far.error, "far.nrrd: the mask lies up to 6 mm away"));
  done(extract + "--mask m.nrrd -o v.jsonl");
  CHECK(read("far.jsonl") == read("v.jsonl"));
}

namespace {

using Vector = std::array<double, 3>;

// An oblique placement: the vectors to the next voxel, and the first voxel.
const std::array<Vector, 3> axes = {{{0.86, 0.27, 0}, {-0.2, 0.67, 0}, {0, 0, 1.5}}};
constexpr Vector origin = {10, -20, 30};

std::string nifti_at(const std::array<Vector, 3>& to_next, const Vector& first,
                     const std::array<int, 3>& extents, const std::string& samples) {
  std::vector<float> rows;
  for (std::size_t row = 0; row < 3; ++row)
    for (const double number : {to_next[0][row], to_next[1][row], to_next[2][row], first[row]})
      rows.push_back(static_cast<float>(number));
  volume_files::Nifti nifti;
  return nifti.dims({3, extents[0], extents[1], extents[2]}).sform(rows).file(samples);
}

// The same mask, with axis i along axis order[i] of the volume, possibly reversed.
std::string turned(const std::string& mask, const std::array<std::size_t, 3>& order,
                   unsigned against, double moved = 0) {
  const std::array<int, 3> whole = {9, 8, 7};
  std::array<Vector, 3> to_next{};
  std::array<int, 3> extents{};
  Vector first = origin;
  first[2] += moved;
  for (std::size_t i = 0; i < 3; ++i) {
    extents[i] = whole[order[i]];
    const bool is_against = (against >> i & 1) != 0;
    for (std::size_t row = 0; row < 3; ++row) {
      to_next[i][row] = (is_against ? -1 : 1) * axes[order[i]][row];
      if (is_against) first[row] += (extents[i] - 1) * axes[order[i]][row];
    }
  }
  std::string samples;
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] < extents[2]; ++at[2])
    for (at[1] = 0; at[1] < extents[1]; ++at[1])
      for (at[0] = 0; at[0] < extents[0]; ++at[0]) {
        std::array<int, 3> in{};
        for (std::size_t i = 0; i < 3; ++i)
          in[order[i]] = (against >> i & 1) != 0 ? extents[i] - 1 - at[i] : at[i];
        samples += mask[static_cast<std::size_t>((in[2] * 8 + in[1]) * 9 + in[0])];
      }
  return nifti_at(to_next, first, extents, samples);
}

}  // namespace

TEST_CASE_FIXTURE(Masked, "a mask with other directions of axes than the volume is turned") {
  write("v.nii", nifti_at(axes, origin, {9, 8, 7}, samples));
  write("m.nii", turned(mask, {0, 1, 2}, 0));
  const std::string parts[] = {"", "--crop 1..7,2..,..5 ", "--shrink 2 "};
  std::vector<std::string> expected;
  const auto extracted = [&](const std::string& file, const std::string& part) {
    const Result result = run("extract v.nii --iso 100 --mask " + file + " -q -o v.jsonl " + part);
    INFO(result.error);
    REQUIRE(result.code == 0);
    CHECK(contains(result.error, "the axes are turned") == (file != "m.nii"));
    return read("v.jsonl");
  };
  for (const std::string& part : parts) expected.push_back(extracted("m.nii", part));
  std::array<std::size_t, 3> order = {0, 1, 2};
  do
    for (unsigned against = 0; against < 8; ++against) {
      if (against == 0 && order == std::array<std::size_t, 3>{0, 1, 2}) continue;
      INFO("order ", order[0], ", ", order[1], ", against ", against);
      write("turned.nii", turned(mask, order, against));
      for (std::size_t i = 0; i < 3; ++i) CHECK(extracted("turned.nii", parts[i]) == expected[i]);
    }
  while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE_FIXTURE(Masked, "a mask with other directions of axes and another position is refused") {
  write("v.nii", nifti_at(axes, origin, {9, 8, 7}, samples));
  write("flipped.nii", turned(mask, {0, 1, 2}, 1, 0.5));
  fails("extract v.nii --iso 100 --mask flipped.nii -o v.stl", 1,
        {"flipped.nii: the axes of the mask differ from those of the volume"});
}
