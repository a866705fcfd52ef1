// FreeSurfer's volumes, field by field. container_table_test reads the files of nibabel.
#include "volume_files.hpp"

namespace {

using namespace volume_files;

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

TEST_CASE_FIXTURE(Folder, "the MGH header places the centre between the middle voxels") {
  const auto file = write("a.mgh", mgh(0, u8, conformed));
  check_volume(file, "MGH");
  const VolumeInfo info = read_info(file);
  REQUIRE(info.placement);
  CHECK(info.placement->space == Space::ras);
  CHECK(info.placement->axes_mm == Axes{{{-0.5, 0, 0}, {0, 0, -0.7}, {0, 2, 0}}});
  CHECK(info.placement->origin_mm == Vector{10 + 2.5 * 0.5, 20 - 2 * 2.0, 30 + 1.5 * 0.7});
  CHECK(info.notes.empty());
}

TEST_CASE_FIXTURE(
    Folder, "an MGH file without a placement gets FreeSurfer's default placement, with a note") {
  const VolumeInfo info = read_info(write("a.mgh", mgh(0, u8, {})));
  CHECK(noted(info, "no directions given, coronal slices of 1 mm assumed"));
  check_axes(info, {{{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}, {2.5, -2, 1.5});
}

// container_table_test reads the types that nibabel writes.
TEST_CASE_FIXTURE(Folder, "MGH samples of u16 are read, and an unsupported type is refused") {
  check_volume(write("a.mgh", mgh(10, stored(SampleType::u16, true), conformed)), SampleType::u16,
               "MGH");
  check_refused(write("a.mgh", mgh(2, stored(SampleType::i64, true), conformed)),
                "type 2 are not supported; convert it, e.g. with: mri_convert -odt float");
}

TEST_CASE_FIXTURE(Folder,
                  "a frame of MGH is chosen, and metadata behind the samples leaves no note") {
  const std::string first(60, '\0');
  const std::string tags = "TR and commands";
  const auto file = write("a.mgz", gzip(mgh(0, first + u8 + tags, conformed, 2)));
  check_refused(file, "holds 2 volumes");
  const VolumeOptions options = of_frame(1);
  check_volume(file, "MGH, gzip", options);
  const auto reader = open_volume(file, options);
  read_all(*reader);
  CHECK(reader->notes().empty());
}

TEST_CASE_FIXTURE(Folder,
                  "MGH files with another version, a short header or missing samples are refused") {
  const std::string samples = stored(SampleType::u8);
  check_refused(write("a.mgh", mgh(0, samples, conformed, 1, 2)), "version 2");
  check_refused(write("a.mgh", mgh(0, samples, conformed).substr(0, 283)),
                "header of 284 bytes is incomplete");
  check_refused(write("a.mgh", mgh(0, samples.substr(1), conformed)), "1 bytes of it are missing");
}

}  // namespace
