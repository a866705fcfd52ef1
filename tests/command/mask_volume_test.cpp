// Masks: the voxels that they keep, and whether they match the placement of their volume.
#include "volumes/filters/filters.hpp"

#include "volume_files.hpp"
#include "volumes/volume_offset.hpp"

namespace {

using namespace volume_files;
using discmc::command::offset_mm;
using discmc::command::open_mask;

VolumeInfo volume_of(const VolumeOptions& options = {}, const std::string& lines = "") {
  const Folder folder;
  const auto file = folder.write("v.nrrd", nrrd(nrrd_u8 + lines) + "\n" + u8);
  return read_info(file, options);
}

std::vector<double> mask_of(const std::string& nifti, const VolumeOptions& options = {}) {
  const Folder folder;
  const auto mask = open_mask(folder.write("m.nii", nifti), options, volume_of(options));
  CHECK(mask->info().type == SampleType::u8);
  return read_all(*mask);
}

double offset(const std::string& lines_of_mask, const std::string& lines_of_volume) {
  return offset_mm(volume_of({}, lines_of_mask), volume_of({}, lines_of_volume));
}

}  // namespace

TEST_CASE("a mask selects voxels whose values are numbers other than 0") {
  std::vector<double> all_but_first(60, 1);
  all_but_first[0] = 0;
  CHECK(mask_of(Nifti().file(u8)) == all_but_first);
  // Sample 30 of f32 is 0. Here two more are NaN.
  std::string samples = stored(SampleType::f32);
  samples.replace(4, 4, "\xff\xff\xff\x7f");
  samples.replace(8, 4, "\xff\xff\xff\xff");
  std::vector<double> expected(60, 1);
  expected[1] = expected[2] = expected[30] = 0;
  CHECK(mask_of(Nifti().type(16).integer(72, 2, 32).file(samples)) == expected);
  // The scaled value is decisive: it is 0 at sample 8.
  std::vector<double> all_but_third(60, 1);
  all_but_third[2] = 0;
  CHECK(mask_of(Nifti().scale(0.5F, -4).file(u8)) == all_but_third);
}

TEST_CASE_FIXTURE(Folder, "a mask of several volumes is refused for any frame of the volume") {
  const auto mask =
      write("m.nii", Nifti().dims({4, 5, 3, 4, 2}).file(std::string(2 * u8.size(), 1)));
  CHECK_THROWS_WITH(open_mask(mask, of_frame(1), volume_of()),
                    doctest::Contains("the mask holds 2 volumes; store the mask in a file"));
}

TEST_CASE(
    "--crop and --shrink apply to the mask, and a shrunk mask has the majority of each block") {
  // All labels differ. 0 is the most frequent in the second block, but most of the block is on.
  std::string labels = stored(SampleType::u8);
  for (const std::size_t off : {1U, 2U, 3U, 8U}) labels[off] = '\0';
  VolumeOptions options;
  options.crop = {{{1, 4}, {0, 1}, {0, 1}}};
  std::vector<double> cropped(16, 1);
  cropped[0] = cropped[1] = cropped[2] = cropped[6] = 0;
  CHECK(mask_of(Nifti().file(labels), options) == cropped);
  options.shrink = 2;
  CHECK(mask_of(Nifti().file(labels), options) == std::vector<double>{1, 1});
  labels[16] = labels[17] = '\0';
  CHECK(mask_of(Nifti().file(labels), options) == std::vector<double>{0, 1});
}

TEST_CASE_FIXTURE(Folder, "a mask must have the extents of the whole volume, even with --crop") {
  const auto file = write("m.nrrd", nrrd(nrrd_u8, "5 4 3") + "\n" + u8);
  VolumeOptions options;
  for (const bool is_part : {false, true}) {
    if (is_part) options.crop = {{{1, 2}, {1, 2}, {1, 2}}};
    try {
      open_mask(file, options, volume_of(options));
      FAIL("not refused");
    } catch (const VolumeError& error) {
      check_refusal(error.what(),
                    "m.nrrd: the mask has 5 x 4 x 3 voxels, and the volume 5 x 3 x 4;");
    }
  }
}

TEST_CASE("a displaced mask is detected if volume and mask have a placement") {
  const std::string directions = "space directions: (1,0,0) (0,2,0) (0,0,3)\n";
  const std::string lps = "space: LPS\n" + directions + "space origin: (10,20,30)\n";
  CHECK(offset(lps, lps) == 0);
  CHECK(offset("", "") == 0);
  CHECK(offset("space: LPS\n" + directions + "space origin: (13,20,26)\n", lps) == 5);
  CHECK(offset("space: LPS\n" + directions + "space origin: (10.05,20,30)\n", lps) == 0);
  // The same position in the other space.
  CHECK(offset("space: RAS\nspace directions: (-1,0,0) (0,-2,0) (0,0,3)\n"
               "space origin: (-10,-20,30)\n",
               lps) == 0);
  CHECK(offset("space: RAS\n" + directions + "space origin: (10,20,30)\n", lps) > 40);
  // If one of them has no patient space, the spacings are compared.
  CHECK(offset("spacings: 1 2 3\n", lps) == 0);
  CHECK(offset("spacings: 1 2 4\n", lps) == 3);
  CHECK(offset("spacings: 1 2 4\n", "spacings: 1 2 3\n") == 3);
}

TEST_CASE_FIXTURE(Folder, "--spacing applies to the mask as well as to the volume") {
  const auto file = write("m.nrrd", nrrd(nrrd_u8) + "\n" + u8);
  VolumeOptions options;
  options.spacing_mm = {0.5, 2, 3};
  const VolumeInfo volume = volume_of(options);
  CHECK(offset_mm(open_mask(file, options, volume)->info(), volume) == 0);
}

TEST_CASE_FIXTURE(Folder, "--axes applies to a mask whose file names no axes") {
  const std::string header =
      std::string("\x93NUMPY\1\0\x4a\0", 10) +
      "{'descr': '|u1', 'fortran_order': False, 'shape': (5, 3, 4), }           \n";
  std::string samples(60, '\1');
  samples[59] = samples[1] = '\0';  // (4, 2, 3) and (0, 0, 1)
  const auto file = write("m.npy", header + samples);
  const VolumeOptions options = with_axes("cxyzt");
  const auto mask = read_all(*open_mask(file, options, volume_of()));
  std::vector<double> expected(60, 1);
  expected[59] = expected[15] = 0;
  CHECK(mask == expected);
  const auto nifti = write("m.nii", Nifti().file(u8));
  CHECK(open_mask(nifti, options, volume_of())->info().dims == volume_of().dims);
}
