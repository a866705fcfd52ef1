#include "writer.hpp"

#include <cmath>
#include <cstring>
#include <vector>

#include "header.hpp"
#include "samples/volume_placement.hpp"

namespace discmc::command {
namespace {

constexpr std::uint64_t header_bytes = nifti2::bytes + 4;  // 4 bytes: no extension follows

bool has_space(const VolumeInfo& info) {
  return info.placement && info.placement->space != Space::scanner;
}

VolumePlacement placement_of(const VolumeInfo& info) {
  if (has_space(info)) return in_space(*info.placement, Space::ras);
  return info.placement.value_or(along_coordinates(info.spacing_mm));
}

// Writes the header in the byte order of this machine.
std::vector<char> header_of(const VolumeInfo& info) {
  std::vector<char> header(header_bytes);
  const auto put = [&header](std::size_t offset, auto value) {
    std::memcpy(&header[offset], &value, sizeof value);
  };
  put(0, static_cast<std::int32_t>(nifti2::bytes));
  std::memcpy(&header[nifti2::magic], "n+2\0\r\n\x1a\n", 8);
  put(nifti2::datatype, nifti_type_of(info.type));
  put(nifti2::bitpix, static_cast<std::int16_t>(8 * sample_bytes(info.type)));
  const VolumePlacement placement = placement_of(info);
  put(nifti2::dim, std::int64_t{3});
  put(nifti2::pixdim, 1.0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(nifti2::dim + 8 * (axis + 1), std::int64_t{info.dims[axis]});
    put(nifti2::pixdim + 8 * (axis + 1), std::fabs(info.spacing_mm[axis]));
    for (std::size_t row = 0; row < 3; ++row)
      put(nifti2::srow + 32 * row + 8 * axis, placement.axes_mm[axis][row]);
    put(nifti2::srow + 32 * axis + 24, placement.origin_mm[axis]);
  }
  for (std::size_t further = 4; further < 8; ++further)
    put(nifti2::dim + 8 * further, std::int64_t{1});
  put(nifti2::vox_offset, static_cast<std::int64_t>(header_bytes));
  put(nifti2::slope, info.slope);
  put(nifti2::intercept, info.intercept);
  // The code that claims least about the directions.
  constexpr std::int32_t scanner = 1, other_template = 5;
  put(nifti2::sform_code, has_space(info) ? scanner : other_template);
  put(nifti2::units, static_cast<std::int32_t>(NiftiUnit::millimetre));
  return header;
}

}  // namespace

void write_nifti(VolumeReader& volume, const std::function<void(std::uint32_t)>& progress,
                 std::ostream& out) {
  const VolumeInfo& info = volume.info();
  std::vector<char> bytes = header_of(info);
  out.write(bytes.data(), header_bytes);
  bytes.resize(info.slice_bytes());
  for (std::uint32_t slice = 0; slice < info.dims[2]; ++slice) {
    volume.read_slice(bytes.data());
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    progress(slice + 1);
  }
}

std::uint64_t nifti_bytes(const VolumeInfo& info) {
  return header_bytes + info.slice_bytes() * info.dims[2];
}

}  // namespace discmc::command
