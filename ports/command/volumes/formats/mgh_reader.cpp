// FreeSurfer's .mgh, and .mgz, which is .mgh packed by gzip:
// https://surfer.nmr.mgh.harvard.edu/fswiki/FsTutorial/MghFormat. All numbers are big-endian.
#include <array>
#include <utility>

#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_bytes.hpp"

namespace discmc::command {
namespace {

constexpr std::size_t header_bytes = 284;

SampleType sample_type(const std::filesystem::path& file, std::int32_t type) {
  constexpr std::pair<std::int32_t, SampleType> types[] = {{0, SampleType::u8},
                                                           {1, SampleType::i32},
                                                           {3, SampleType::f32},
                                                           {4, SampleType::i16},
                                                           {10, SampleType::u16}};
  for (const auto& [number, of_number] : types)
    if (type == number) return of_number;
  fail(file, "samples of FreeSurfer's type " + std::to_string(type) + " are not supported",
       "convert it, e.g. with: mri_convert -odt float " + file.string() + " OUT.nii.gz");
}

// Without directions, FreeSurfer assumes coronal slices of 1 mm about the origin.
DeclaredPlace place_of(VolumeInfo& info, const HeaderBytes& header) {
  constexpr std::size_t flag = 28;
  std::array<double, 3> spacing{1, 1, 1}, centre{};
  Axes directions{{{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
  if (header.number<std::int16_t>(flag) != 0) {
    spacing = header.reals(flag + 2);
    for (std::size_t axis = 0; axis < 3; ++axis)
      directions[axis] = header.reals(flag + 14 + 12 * axis);
    centre = header.reals(flag + 50);
  } else {
    note(info, "no directions given, coronal slices of 1 mm assumed, as by FreeSurfer");
  }
  DeclaredPlace place;
  place.set_unit("mm");
  place.space = Space::ras;
  place.spacing = {spacing[0], spacing[1], spacing[2]};
  place.directions = directions;
  place.origin = centre;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 3; ++i)
      place.origin[i] -= info.dims[axis] / 2.0 * spacing[axis] * directions[axis][i];
  return place;
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
  set_dims(info, file, sizes, options.frame);
  set_place(info, place_of(info, header), options);
  // Scan parameters and commands may follow.
  const auto no_note = [](ByteStream&) { return std::string(); };
  return std::make_unique<SliceStream>(std::move(info), std::move(stream), true, options.frame,
                                       no_note);
}

}  // namespace discmc::command
