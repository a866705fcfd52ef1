// FreeSurfer's volumes, field by field. container_table_test reads the files of nibabel.
#include "volume_files.hpp"

namespace {

using namespace volume_files;
using discmc::Space;
using discmc::meshing::Axes;

// A file of 5 x 3 x 4 voxels. geometry: spacing, directions and centre; or none.
std::string mgh(std::int32_t type, const std::string& samples, const std::vector<float>& geometry,
                std::int32_t frames = 1, std::int32_t version = 1) {
  std::string bytes;
  for (const std::int32_t field : {version, 5, 3, 4, frames, type, 0})
    bytes += bytes_of(field, true);
  bytes += bytes_of(static_cast<std::int16_t>(geometry.empty() ? 0 : 1), true);
  for (const float number : geometry) bytes += bytes_of(number, true);
  bytes.resize(284);
  return bytes + samples;
}

// Sagittal, like FreeSurfer's conformed volumes, but with another centre.
const std::vector<float> conformed = {0.5F, 0.7F, 2, -1, 0, 0, 0, 0, -1, 0, 1, 0, 10, 20, 30};

TEST_CASE_FIXTURE(Folder,
                  "the place is that of the header: the centre lies between the middle voxels") {
  const auto file = write("a.mgh", mgh(0, stored(SampleType::u8), conformed));
  check_volume(file, SampleType::u8, "MGH");
  const auto reader = open_volume(file);
  REQUIRE(reader->info().placement);
  CHECK(reader->info().placement->space == Space::ras);
  CHECK(reader->info().placement->axes_mm == Axes{{{-0.5, 0, 0}, {0, 0, -0.7}, {0, 2, 0}}});
  CHECK(reader->info().placement->origin_mm ==
        Vector{10 + 2.5 * 0.5, 20 - 2 * 2.0, 30 + 1.5 * 0.7});
  CHECK(reader->info().notes.empty());
}

TEST_CASE_FIXTURE(Folder, "the default place of FreeSurfer replaces a missing one, with a note") {
  const auto reader = open_volume(write("a.mgh", mgh(0, stored(SampleType::u8), {})));
  CHECK(noted(reader->info(), "no directions given, coronal slices of 1 mm assumed"));
  REQUIRE(reader->info().placement);
  CHECK(reader->info().placement->axes_mm == Axes{{{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}});
  CHECK(reader->info().placement->origin_mm == Vector{2.5, -2, 1.5});
}

TEST_CASE_FIXTURE(Folder,
                  "every type of sample is read, or refused with the program that converts it") {
  const std::pair<std::int32_t, SampleType> types[] = {{0, SampleType::u8},
                                                       {1, SampleType::i32},
                                                       {3, SampleType::f32},
                                                       {4, SampleType::i16},
                                                       {10, SampleType::u16}};
  for (const auto& [number, type] : types)
    check_volume(write("a.mgh", mgh(number, stored(type, true), conformed)), type, "MGH");
  check_refused(write("a.mgh", mgh(2, stored(SampleType::i64, true), conformed)),
                "type 2 are not supported; convert it, e.g. with: mri_convert -odt float");
}

TEST_CASE_FIXTURE(Folder, "a frame is chosen, and bytes behind the samples leave no note") {
  const std::string first(60, '\0');
  const std::string tags = "TR and commands";
  const auto file =
      write("a.mgz", gzip(mgh(0, first + stored(SampleType::u8) + tags, conformed, 2)));
  check_refused(file, "holds 2 volumes");
  const VolumeOptions options = with(&VolumeOptions::frame, 1);
  check_volume(file, SampleType::u8, "MGH, gzip", options);
  const auto reader = open_volume(file, options);
  read_all(*reader);
  CHECK(reader->notes().empty());
}

TEST_CASE_FIXTURE(Folder, "another version, a short header and missing samples are refused") {
  const std::string samples = stored(SampleType::u8);
  check_refused(write("a.mgh", mgh(0, samples, conformed, 1, 2)), "version 2");
  check_refused(write("a.mgh", mgh(0, samples, conformed).substr(0, 283)),
                "header of 284 bytes is incomplete");
  check_refused(write("a.mgh", mgh(0, samples.substr(1), conformed)), "1 bytes of it are missing");
}

}  // namespace
