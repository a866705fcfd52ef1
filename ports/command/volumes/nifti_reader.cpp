// NIfTI-1, one file or a pair, after the NIfTI library's own description of the header.
//
// The library does not open the files: it loads data only whole, and given a.nii.gz it reads a.nii
// where both are there.
#include <nifti1_io.h>

#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>
#include <system_error>
#include <utility>

#include "volume_format.hpp"

namespace discmc::host {
namespace {

static_assert(sizeof(nifti_1_header) == 348, "the bytes of the file");

ByteStream open_content(const std::filesystem::path& file) {
  ByteStream stream(file);
  unsigned char magic[2] = {};
  stream.read(magic, 2);
  stream.seek(0);
  if (magic[0] == 0x1f && magic[1] == 0x8b) stream.start_inflate();
  return stream;
}

std::filesystem::path without_gz(std::filesystem::path file) {
  return lower(file.extension().string()) == ".gz" ? file.replace_extension() : file;
}

// Returns the other file of a pair: a.img or a.img.gz for a.hdr, and the other way round.
std::filesystem::path partner(const std::filesystem::path& asked, const char* extension) {
  std::filesystem::path file = without_gz(asked).replace_extension(extension);
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) return file;
  file += ".gz";
  if (std::filesystem::exists(file, ignored)) return file;
  fail(asked, std::string("there is no ") + extension + " or " + extension + ".gz beside it",
       "put the other file of the pair there");
}

struct Header {
  nifti_1_header fields;
  bool big_endian;
};

Header read_header(ByteStream& stream) {
  Header header{};
  if (stream.read(&header.fields, sizeof header.fields) < sizeof header.fields)
    fail(stream.file(), "the header of 348 bytes is not whole", "copy or export the file again");
  nifti_1_header other_order = header.fields;
  swap_nifti_header(&other_order, 1);
  const bool turned = other_order.sizeof_hdr == 348;
  if (turned) header.fields = other_order;
  if (header.fields.sizeof_hdr != 348 || NIFTI_VERSION(header.fields) != 1)
    fail(stream.file(),
         "the header has size " + std::to_string(header.fields.sizeof_hdr) + " and magic " +
             shown({header.fields.magic, 3}) + ", not those of NIfTI-1",
         "convert NIfTI-2 and Analyze files to NIfTI-1, e.g. with SimpleITK");
  header.big_endian = is_native_big_endian() != turned;
  return header;
}

SampleType sample_type(const std::filesystem::path& file, int datatype) {
  switch (datatype) {
    case DT_UINT8:
      return SampleType::u8;
    case DT_INT8:
      return SampleType::i8;
    case DT_UINT16:
      return SampleType::u16;
    case DT_INT16:
      return SampleType::i16;
    case DT_UINT32:
      return SampleType::u32;
    case DT_INT32:
      return SampleType::i32;
    case DT_UINT64:
      return SampleType::u64;
    case DT_INT64:
      return SampleType::i64;
    case DT_FLOAT32:
      return SampleType::f32;
    case DT_FLOAT64:
      return SampleType::f64;
    default:
      fail_type(file, std::string(nifti_datatype_to_string(datatype)) + " (datatype " +
                          std::to_string(datatype) + ")");
  }
}

void set_sizes(VolumeInfo& info, const std::filesystem::path& file, const short (&dim)[8]) {
  if (dim[0] < 1 || dim[0] > 7)
    fail(file, "the header gives " + std::to_string(dim[0]) + " dimensions", "correct dim[0]");
  set_dims(info, file, std::vector<std::int64_t>(dim + 1, dim + 1 + dim[0]));
}

// The sform needs no pixdim, and some programs leave it at 1.
void prefer_sform(VolumeInfo& info, const Axes& axes_mm) {
  constexpr double rounding = 1e-3;
  std::array<double, 3> lengths{};
  bool is_same = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lengths[axis] = std::hypot(axes_mm[axis][0], axes_mm[axis][1], axes_mm[axis][2]);
    is_same =
        is_same && std::fabs(lengths[axis] - info.spacing_mm[axis]) <= rounding * lengths[axis];
  }
  if (is_same || !is_usable(axes_mm)) return;
  info.notes.emplace_back("pixdim contradicts the sform, whose spacing is taken");
  set_spacing(info, lengths);
}

void set_geometry(VolumeInfo& info, const nifti_1_header& header) {
  const int unit = XYZT_TO_SPACE(header.xyzt_units);
  const double unit_mm = unit == NIFTI_UNITS_METER    ? 1000.0
                         : unit == NIFTI_UNITS_MICRON ? 1e-3
                                                      : 1.0;
  std::array<double, 3> spacing{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    spacing[axis] = unit_mm * std::fabs(static_cast<double>(header.pixdim[axis + 1]));
  set_spacing(info, spacing);

  mat44 to_space{};
  if (header.sform_code > 0) {
    for (int column = 0; column < 4; ++column) {
      to_space.m[0][column] = header.srow_x[column];
      to_space.m[1][column] = header.srow_y[column];
      to_space.m[2][column] = header.srow_z[column];
    }
  } else if (header.qform_code > 0) {
    to_space = nifti_quatern_to_mat44(header.quatern_b, header.quatern_c, header.quatern_d,
                                      header.qoffset_x, header.qoffset_y, header.qoffset_z,
                                      std::fabs(header.pixdim[1]), std::fabs(header.pixdim[2]),
                                      std::fabs(header.pixdim[3]), header.pixdim[0]);
  } else {
    return;
  }
  VolumePlacement placement;
  placement.frame = Frame::ras;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      placement.axes_mm[axis][row] = unit_mm * static_cast<double>(to_space.m[row][axis]);
    placement.origin_mm[row] = unit_mm * static_cast<double>(to_space.m[row][3]);
  }
  if (header.sform_code > 0) prefer_sform(info, placement.axes_mm);
  set_placement(info, placement);
}

// Returns the decimal number that the program meant which wrote the float: 0.01f is 0.01.
double decimal(float value) {
  for (int digits = 6; digits <= 9 && std::isfinite(value); ++digits) {
    std::stringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    text << value;
    double result = 0;
    if (text >> result && static_cast<float>(result) == value) return result;
  }
  return static_cast<double>(value);
}

std::uint64_t data_offset(const std::filesystem::path& file, float vox_offset, bool one_file) {
  constexpr float most = 0x1p30F;
  if (!(vox_offset >= 0 && vox_offset <= most) || std::floor(vox_offset) != vox_offset)
    fail(file, "vox_offset is " + std::to_string(vox_offset), "correct the header");
  // Some programs leave 0 for "right after the header".
  constexpr std::uint64_t least_in_one_file = 352;
  const auto offset = static_cast<std::uint64_t>(vox_offset);
  return one_file && offset < least_in_one_file ? least_in_one_file : offset;
}

}  // namespace

std::unique_ptr<VolumeReader> open_nifti(const std::filesystem::path& file) {
  const bool is_data = lower(without_gz(file).extension().string()) == ".img";
  ByteStream stream = open_content(is_data ? partner(file, ".hdr") : file);
  const auto [header, big_endian] = read_header(stream);
  VolumeInfo info;
  info.type = sample_type(file, header.datatype);
  set_sizes(info, file, header.dim);
  set_geometry(info, header);
  set_scale(info, file, decimal(header.scl_slope), decimal(header.scl_inter));

  const std::uint64_t offset = data_offset(file, header.vox_offset, NIFTI_ONEFILE(header));
  info.format = "NIfTI-1";
  if (NIFTI_ONEFILE(header)) {
    stream.skip(offset - sizeof header);
  } else {
    info.format += " pair";
    stream = open_content(is_data ? file : partner(file, ".img"));
    stream.skip(offset);
  }
  if (stream.inflating()) info.format += ", gzip";
  return std::make_unique<SliceStream>(std::move(info), std::move(stream), big_endian);
}

}  // namespace discmc::host
