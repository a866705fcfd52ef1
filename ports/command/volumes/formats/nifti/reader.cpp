// NIfTI-1 and -2, one file or a pair, after the NIfTI library's own descriptions of the headers.
// And Analyze 7.5, whose header NIfTI-1 took over, without an orientation and without a magic
// number.
//
// The library does not open the files: it loads data only whole, and given a.nii.gz it reads a.nii
// where both are there.
#include <nifti1_io.h>
#include <nifti2.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>
#include <utility>

#include "label_extension.hpp"
#include "text/words.hpp"
#include "types.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/filters/component_volume.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_bytes.hpp"
#include "volumes/header_text.hpp"

namespace discmc::command {
namespace {

static_assert(sizeof(nifti_1_header) == 348 && sizeof(nifti_2_header) == 540, "as in the file");

// Returns the other file of a pair: a.img or a packed one, such as a.img.gz, for a.hdr, and the
// other way round.
std::filesystem::path partner(const std::filesystem::path& asked, const char* extension) {
  const std::filesystem::path file = without_packing(asked).replace_extension(extension);
  for (const std::string_view ending : packed_endings) {
    std::filesystem::path packed = file;
    packed += ending;
    std::error_code ignored;
    if (std::filesystem::exists(packed, ignored)) return packed;
  }
  fail(asked, std::string("there is no ") + extension + " or " + extension + ".gz beside it",
       "put the other file of the pair there");
}

// The fields of every version, in those of NIfTI-2, which hold them all.
struct Header {
  nifti_2_header fields{};
  std::string format;
  bool one_file = false;
  bool big_endian = false;
  std::array<int, 3> origin{};  ///< SPM's, all 0 where there is none
};

template <class Field>
void turn(Field& field) {
  auto* bytes = reinterpret_cast<unsigned char*>(&field);
  std::reverse(bytes, bytes + sizeof field);
}

template <class Field, std::size_t count>
void turn(Field (&fields)[count]) {
  for (Field& field : fields) turn(field);
}

// Turns the bytes of the fields that are read.
template <class Fields>
void turn_fields(Fields& fields) {
  const auto turn_all = [](auto&... field) { (turn(field), ...); };
  turn_all(fields.datatype, fields.dim, fields.pixdim, fields.vox_offset, fields.scl_slope,
           fields.scl_inter, fields.qform_code, fields.sform_code, fields.quatern_b,
           fields.quatern_c, fields.quatern_d, fields.qoffset_x, fields.qoffset_y, fields.qoffset_z,
           fields.srow_x, fields.srow_y, fields.srow_z);
}

std::int64_t whole_offset(const std::filesystem::path& file, float vox_offset) {
  constexpr float most = 0x1p30F;
  if (!(vox_offset >= 0 && vox_offset <= most) || std::floor(vox_offset) != vox_offset)
    fail(file, "vox_offset is " + std::to_string(vox_offset), "correct the header");
  return static_cast<std::int64_t>(vox_offset);
}

nifti_2_header widened(const std::filesystem::path& file, const nifti_1_header& one) {
  nifti_2_header two{};
  two.datatype = one.datatype;
  std::copy(std::begin(one.dim), std::end(one.dim), two.dim);
  std::copy(std::begin(one.pixdim), std::end(one.pixdim), two.pixdim);
  two.vox_offset = whole_offset(file, one.vox_offset);
  two.scl_slope = decimal(one.scl_slope);
  two.scl_inter = decimal(one.scl_inter);
  two.xyzt_units = static_cast<unsigned char>(one.xyzt_units);
  two.qform_code = one.qform_code;
  two.sform_code = one.sform_code;
  two.quatern_b = static_cast<double>(one.quatern_b);
  two.quatern_c = static_cast<double>(one.quatern_c);
  two.quatern_d = static_cast<double>(one.quatern_d);
  two.qoffset_x = static_cast<double>(one.qoffset_x);
  two.qoffset_y = static_cast<double>(one.qoffset_y);
  two.qoffset_z = static_cast<double>(one.qoffset_z);
  std::copy(std::begin(one.srow_x), std::end(one.srow_x), two.srow_x);
  std::copy(std::begin(one.srow_y), std::end(one.srow_y), two.srow_y);
  std::copy(std::begin(one.srow_z), std::end(one.srow_z), two.srow_z);
  return two;
}

// What Analyze has in the fields of its own that NIfTI-1 gave another meaning is dropped. Only SPM
// writes a slope, and where NIfTI-1 has it.
void drop_what_analyze_has_not(nifti_2_header& fields) {
  fields.qform_code = 0;
  fields.sform_code = 0;
  fields.xyzt_units = NIFTI_UNITS_MM;
  fields.scl_inter = 0;
  if (!std::isfinite(fields.scl_slope) || fields.scl_slope < 0) fields.scl_slope = 0;
}

template <class Fields>
Fields taken(ByteStream& stream, bool is_turned) {
  Fields fields{};
  if (stream.read(&fields, sizeof fields) < sizeof fields)
    fail(stream.file(), "the header of " + std::to_string(sizeof fields) + " bytes is incomplete",
         "copy or export the file again");
  if (is_turned) turn_fields(fields);
  return fields;
}

Header read_header(ByteStream& stream) {
  std::int32_t size = 0;
  const std::string_view start = stream.peek(sizeof size);
  std::memcpy(&size, start.data(), start.size());
  constexpr std::int32_t size_of_1 = sizeof(nifti_1_header);
  constexpr std::int32_t size_of_2 = sizeof(nifti_2_header);
  std::int32_t other_order = size;
  turn(other_order);
  const bool is_turned = other_order == size_of_1 || other_order == size_of_2;
  if (is_turned) size = other_order;
  if (size != size_of_1 && size != size_of_2)
    fail(stream.file(),
         "the header has size " + std::to_string(size) + ", which is not a size of NIfTI",
         "check that it is a NIfTI or Analyze file");
  Header header;
  header.big_endian = is_native_big_endian() != is_turned;
  if (size == size_of_2) {
    header.fields = taken<nifti_2_header>(stream, is_turned);
    if (is_turned) turn(header.fields.xyzt_units);
    const std::string_view magic(header.fields.magic, 4);
    header.one_file = magic == std::string_view("n+2\0", 4);
    header.format = "NIfTI-2";
    if (!header.one_file && magic != std::string_view("ni2\0", 4))
      fail(stream.file(), "the magic of NIfTI-2 is " + shown(magic), "copy the file again");
    return header;
  }
  const auto fields = taken<nifti_1_header>(stream, is_turned);
  header.fields = widened(stream.file(), fields);
  header.one_file = NIFTI_ONEFILE(fields);
  const bool is_analyze = NIFTI_VERSION(fields) != 1;
  header.format = is_analyze ? "Analyze 7.5" : "NIfTI-1";
  if (!is_analyze) return header;
  drop_what_analyze_has_not(header.fields);
  // SPM has its origin, a voxel counted from 1, over fields of NIfTI.
  constexpr std::size_t originator_at = 253;
  std::array<std::int16_t, 3> originator{};
  std::memcpy(originator.data(), reinterpret_cast<const char*>(&fields) + originator_at,
              sizeof originator);
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_turned) turn(originator[i]);
    header.origin[i] = originator[i];
  }
  return header;
}

SampleType sample_type(const std::filesystem::path& file, int datatype) {
  if (const auto type = type_of_nifti(datatype)) return *type;
  fail_type(file, std::string(nifti_datatype_to_string(datatype)) + " (datatype " +
                      std::to_string(datatype) + ")");
}

// Bytes side by side in colours, or 1.
std::uint64_t channels_of(int datatype) {
  return datatype == DT_RGB24 ? 3 : datatype == DT_RGBA32 ? 4 : 1;
}

void set_samples(VolumeInfo& info, const std::filesystem::path& file, const nifti_2_header& header,
                 const VolumeOptions& options) {
  const std::uint64_t channels = channels_of(header.datatype);
  info.type = channels > 1 ? SampleType::u8 : sample_type(file, header.datatype);
  const std::int64_t dimensions = header.dim[0];
  if (dimensions < 1 || dimensions > 7)
    fail(file, "the header gives " + std::to_string(dimensions) + " dimensions", "correct dim[0]");
  std::vector<std::int64_t> sizes(header.dim + 1, header.dim + 1 + dimensions);
  // Some leave 0 for axes behind the third that they do not have.
  if (sizes.size() > 3)
    std::replace(sizes.begin() + 3, sizes.end(), std::int64_t{0}, std::int64_t{1});
  set_dims(info, file, sizes, options.frame);
  set_channels(info, file, channels, options.channel, {"red", "green", "blue"});
}

std::string unit_of(int code) {
  switch (XYZT_TO_SPACE(code)) {
    case NIFTI_UNITS_METER:
      return "m";
    case NIFTI_UNITS_MM:
      return "mm";
    case NIFTI_UNITS_MICRON:
      return "um";
    default:
      return {};
  }
}

// Rows of a matrix that leads from voxels to space.
using Rows = std::array<std::array<double, 4>, 3>;

Rows sform_of(const nifti_2_header& header) {
  Rows rows{};
  std::copy(std::begin(header.srow_x), std::end(header.srow_x), rows[0].begin());
  std::copy(std::begin(header.srow_y), std::end(header.srow_y), rows[1].begin());
  std::copy(std::begin(header.srow_z), std::end(header.srow_z), rows[2].begin());
  return rows;
}

Rows qform_of(const nifti_2_header& header) {
  const auto real = [](double value) { return static_cast<float>(value); };
  const auto length = [&](int axis) { return real(std::fabs(header.pixdim[axis])); };
  const mat44 matrix =
      nifti_quatern_to_mat44(real(header.quatern_b), real(header.quatern_c), real(header.quatern_d),
                             real(header.qoffset_x), real(header.qoffset_y), real(header.qoffset_z),
                             length(1), length(2), length(3), real(header.pixdim[0]));
  Rows rows{};
  for (std::size_t row = 0; row < 3; ++row)
    std::copy(std::begin(matrix.m[row]), std::end(matrix.m[row]), rows[row].begin());
  return rows;
}

// Returns whether they span a space.
bool take(const Rows& rows, DeclaredPlace& place) {
  Axes steps{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis) steps[axis][row] = rows[row][axis];
  if (!is_usable(steps)) return false;
  place.space = Space::ras;
  place.steps = steps;
  for (std::size_t row = 0; row < 3; ++row) place.origin[row] = rows[row][3];
  return true;
}

// Otherwise the sides of the qform are not used.
void note_mirrored(VolumeInfo& info, const nifti_2_header& header, const DeclaredPlace& place) {
  DeclaredPlace other;
  if (header.qform_code > 0 && take(qform_of(header), other) &&
      (determinant(*other.steps) < 0) != (determinant(*place.steps) < 0))
    note(info, "the qform is mirrored against the sform, and ignored; check which side is left");
}

// As SPM and nibabel read it: x runs from right to left.
bool take_origin(VolumeInfo& info, const Header& header, DeclaredPlace& place) {
  for (std::size_t i = 0; i < 3; ++i)
    if (header.origin[i] < 1 || header.origin[i] > static_cast<int>(info.dims[i])) return false;
  place.space = Space::ras;
  Axes& steps = place.steps.emplace();
  for (std::size_t i = 0; i < 3; ++i) {
    steps[i][i] = place.spacing[i].value_or(1) * (i == 0 ? -1 : 1);
    place.origin[i] = (1 - header.origin[i]) * steps[i][i];
  }
  note(info, "the origin is SPM's, and x runs from right to left as SPM reads Analyze");
  return true;
}

void set_geometry(VolumeInfo& info, const Header& whole, const VolumeOptions& options) {
  const nifti_2_header& header = whole.fields;
  DeclaredPlace place;
  place.set_unit(unit_of(header.xyzt_units));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place.spacing[axis] = std::fabs(header.pixdim[axis + 1]);
    if (header.pixdim[axis + 1] < 0)
      note(info, "pixdim " + std::to_string(axis + 1) + " is negative, and read as positive");
  }
  bool is_placed = header.sform_code > 0 && take(sform_of(header), place);
  if (is_placed) note_mirrored(info, header, place);
  if (header.sform_code > 0 && !is_placed) note(info, "the sform spans no space, and is ignored");
  if (!is_placed && header.qform_code > 0) {
    is_placed = take(qform_of(header), place);
    if (!is_placed) note(info, "the qform spans no space, and is ignored");
  }
  if (!is_placed) is_placed = take_origin(info, whole, place);
  if (!is_placed) note(info, "no orientation (sform, qform); left and right are unknown");
  set_place(info, place, options);
}

// A slope that is no number is none, as for nibabel and FSL.
void set_values(VolumeInfo& info, const std::filesystem::path& file, const nifti_2_header& header) {
  const bool has_slope = std::isfinite(header.scl_slope) && header.scl_slope != 0;
  if (!std::isfinite(header.scl_slope))
    note(info, "scl_slope is " + std::to_string(header.scl_slope) + ", and is ignored");
  set_scale(info, file, has_slope ? header.scl_slope : 0, has_slope ? header.scl_inter : 0);
}

std::uint64_t data_offset(const std::filesystem::path& file, const Header& header) {
  if (header.fields.vox_offset < 0)
    fail(file, "vox_offset is " + std::to_string(header.fields.vox_offset), "correct the header");
  const auto offset = static_cast<std::uint64_t>(header.fields.vox_offset);
  // Some programs leave 0 for "right after the header".
  const std::uint64_t least = header.format == "NIfTI-2" ? 544 : 352;
  return header.one_file && offset < least ? least : offset;
}

}  // namespace

std::unique_ptr<VolumeReader> open_nifti(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const bool is_data = lower(without_packing(file).extension().string()) == ".img";
  if (is_data) stream = open_content(partner(file, ".hdr"));
  const Header header = read_header(stream);
  const nifti_2_header& fields = header.fields;
  VolumeInfo info;
  set_samples(info, file, fields, options);
  set_geometry(info, header, options);
  set_values(info, file, fields);
  info.format = header.format;

  const std::uint64_t offset = data_offset(file, header);
  constexpr auto no_end = std::numeric_limits<std::uint64_t>::max();
  if (header.format != "Analyze 7.5")
    read_label_extensions(stream, header.one_file ? offset : no_end, header.big_endian, info);
  if (header.one_file) {
    stream.skip(offset - stream.position());
  } else {
    info.format += " pair";
    stream = open_content(is_data ? file : partner(file, ".img"));
    stream.skip(offset);
  }
  return channel_of(file, std::move(info), options.channel, [&](VolumeInfo all) {
    return std::make_unique<SliceStream>(std::move(all), std::move(stream), header.big_endian,
                                         options.frame);
  });
}

}  // namespace discmc::command
