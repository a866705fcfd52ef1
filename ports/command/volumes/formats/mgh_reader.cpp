// FreeSurfer's .mgh, and .mgz, which is the same packed by gzip:
// https://surfer.nmr.mgh.harvard.edu/fswiki/FsTutorial/MghFormat. All numbers are big-endian.
#include <array>
#include <utility>

#include "volumes/header_bytes.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::command {
namespace {

constexpr std::size_t header_bytes = 284;

SampleType sample_type(const std::filesystem::path& file, std::int32_t type) {
  switch (type) {
    case 0:
      return SampleType::u8;
    case 1:
      return SampleType::i32;
    case 3:
      return SampleType::f32;
    case 4:
      return SampleType::i16;
    case 10:
      return SampleType::u16;
    default:
      fail(file, "samples of FreeSurfer's type " + std::to_string(type) + " are not read",
           "convert it, e.g. with: mri_convert -odt float " + file.string() + " OUT.nii.gz");
  }
}

// Directions and the coordinates of the centre; without them FreeSurfer takes coronal slices.
struct Geometry {
  std::array<double, 3> spacing{1, 1, 1};
  Axes directions{{{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
  std::array<double, 3> centre{};
};

Geometry geometry_of(const HeaderBytes& header) {
  Geometry geometry;
  constexpr std::size_t flag = 28;
  if (header.number<std::int16_t>(flag) == 0) return geometry;
  std::size_t at = flag + 2;
  const auto take = [&](std::array<double, 3>& numbers) {
    for (double& number : numbers) {
      number = decimal(header.number<float>(at));
      at += 4;
    }
  };
  take(geometry.spacing);
  for (auto& direction : geometry.directions) take(direction);
  take(geometry.centre);
  return geometry;
}

void set_geometry(VolumeInfo& info, const Geometry& geometry) {
  set_spacing(info, geometry.spacing);
  VolumePlacement placement;
  placement.frame = Frame::ras;
  placement.origin_mm = geometry.centre;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 3; ++i) {
      placement.axes_mm[axis][i] = info.spacing_mm[axis] * geometry.directions[axis][i];
      placement.origin_mm[i] -= info.dims[axis] / 2.0 * placement.axes_mm[axis][i];
    }
  set_placement(info, placement);
}

}  // namespace

std::unique_ptr<VolumeReader> open_mgh(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const HeaderBytes header(stream, header_bytes, true);
  const auto version = header.number<std::int32_t>(0);
  if (version != 1)
    fail(file, "this is version " + std::to_string(version) + " of the format",
         "check that it is a volume of FreeSurfer");
  VolumeInfo info;
  info.format = "MGH";
  info.type = sample_type(file, header.number<std::int32_t>(20));
  std::vector<std::int64_t> sizes;
  for (std::size_t axis = 0; axis < 4; ++axis)
    sizes.push_back(header.number<std::int32_t>(4 + 4 * axis));
  if (sizes.back() == 1) sizes.pop_back();
  set_dims(info, file, sizes, options);
  set_geometry(info, geometry_of(header));
  skip_to_frame(stream, info, options);
  return std::make_unique<SliceStream>(std::move(info), std::move(stream), true);
}

}  // namespace discmc::command
