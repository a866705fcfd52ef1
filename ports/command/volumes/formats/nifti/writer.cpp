#include "writer.hpp"

#include <nifti1.h>
#include <nifti2.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "samples/volume_placement.hpp"
#include "types.hpp"

namespace discmc::command {
namespace {

constexpr std::uint64_t header_bytes = sizeof(nifti_2_header) + 4;  // and that nothing follows it

bool has_space(const VolumeInfo& info) {
  return info.placement && info.placement->space != Space::scanner;
}

VolumePlacement placement_of(const VolumeInfo& info) {
  if (has_space(info)) return in_space(*info.placement, Space::ras);
  return info.placement.value_or(along_coordinates(info.spacing_mm));
}

nifti_2_header header_of(const VolumeInfo& info) {
  nifti_2_header header{};
  header.sizeof_hdr = sizeof header;
  std::memcpy(header.magic, "n+2\0\r\n\x1a\n", sizeof header.magic);
  header.datatype = nifti_type_of(info.type);
  header.bitpix = static_cast<std::int16_t>(8 * sample_bytes(info.type));
  header.dim[0] = 3;
  header.pixdim[0] = 1;
  const VolumePlacement placement = placement_of(info);
  double* const rows[] = {header.srow_x, header.srow_y, header.srow_z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.dim[axis + 1] = info.dims[axis];
    header.pixdim[axis + 1] = std::fabs(info.spacing_mm[axis]);
    for (std::size_t row = 0; row < 3; ++row) rows[row][axis] = placement.axes_mm[axis][row];
    rows[axis][3] = placement.origin_mm[axis];
  }
  for (std::size_t further = 4; further < 8; ++further) header.dim[further] = 1;
  header.vox_offset = header_bytes;
  header.scl_slope = info.slope;
  header.scl_inter = info.intercept;
  // The code that claims least about the directions.
  header.sform_code = has_space(info) ? NIFTI_XFORM_SCANNER_ANAT : NIFTI_XFORM_TEMPLATE_OTHER;
  header.xyzt_units = NIFTI_UNITS_MM;
  return header;
}

}  // namespace

void write_nifti(VolumeReader& volume, const std::function<void(std::uint32_t)>& progress,
                 std::ostream& out) {
  const VolumeInfo& info = volume.info();
  std::vector<char> bytes(header_bytes);
  const nifti_2_header header = header_of(info);
  std::memcpy(bytes.data(), &header, sizeof header);
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
