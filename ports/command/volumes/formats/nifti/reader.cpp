// NIfTI-1 and -2, and Analyze 7.5, as one file or as a pair of header and data.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "header.hpp"
#include "text/words.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"

namespace discmc::command {
namespace {

// Returns the other file of a pair: for a.hdr, a.img or a packed one such as a.img.gz, and vice
// versa.
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

struct Unread {
  int datatype;
  const char* name;
};
constexpr Unread unread_types[] = {{1, "BINARY"},
                                   {32, "COMPLEX64"},
                                   {1536, "FLOAT128"},
                                   {1792, "COMPLEX128"},
                                   {2048, "COMPLEX256"}};

SampleType sample_type(const std::filesystem::path& file, int datatype) {
  if (const auto type = type_of_nifti(datatype)) return *type;
  std::string name = "datatype " + std::to_string(datatype);
  for (const Unread& unread : unread_types)
    if (unread.datatype == datatype) name = std::string(unread.name) + " (" + name + ")";
  fail_type(file, name);
}

// Returns the number of adjacent bytes per voxel for colours, or 1.
std::uint64_t channels_of(int datatype) {
  constexpr int rgb = 128, rgba = 2304;
  return datatype == rgb ? 3 : datatype == rgba ? 4 : 1;
}

void set_samples(VolumeInfo& info, const std::filesystem::path& file, const NiftiHeader& header,
                 const VolumeOptions& options) {
  const std::uint64_t channels = channels_of(header.datatype);
  info.type = channels > 1 ? SampleType::u8 : sample_type(file, header.datatype);
  const std::int64_t dimensions = header.dim[0];
  if (dimensions < 1 || dimensions > 7)
    fail(file, "the header gives " + std::to_string(dimensions) + " dimensions", "correct dim[0]");
  std::vector<std::int64_t> sizes(header.dim.begin() + 1, header.dim.begin() + 1 + dimensions);
  // Some programs leave 0 for unused axes behind the third.
  if (sizes.size() > 3)
    std::replace(sizes.begin() + 3, sizes.end(), std::int64_t{0}, std::int64_t{1});
  set_dims(info, file, sizes, options.frame);
  set_channels(info, file, channels, options.channel, {"red", "green", "blue"});
}

const char* name_of(NiftiUnit unit) {
  constexpr const char* names[8] = {"", "m", "mm", "um", "", "", "", ""};
  return names[static_cast<std::size_t>(unit)];
}

// The rows of a matrix from voxels to space.
using Rows = decltype(NiftiHeader::srow);

// Sets the place. Returns whether the rows span a space.
bool set_place(const Rows& rows, DeclaredPlace& place) {
  Axes steps{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis) steps[axis][row] = rows[row][axis];
  if (!is_usable(steps)) return false;
  place.space = Space::ras;
  place.steps = steps;
  for (std::size_t row = 0; row < 3; ++row) place.origin[row] = rows[row][3];
  return true;
}

// Notes that the qform is mirrored against the sform. It is not used otherwise.
void note_mirrored(VolumeInfo& info, const NiftiHeader& header, const DeclaredPlace& place) {
  DeclaredPlace other;
  if (header.qform_code > 0 && set_place(qform_of(header), other) &&
      (determinant(*other.steps) < 0) != (determinant(*place.steps) < 0))
    note(info, "the qform is mirrored against the sform, and ignored; check which side is left");
}

// Returns a 4 x 4 variable of a MATLAB file of version 4, by columns, or nothing if the file has no
// such variable. https://www.mathworks.com/help/pdf_doc/matlab/matfile_format.pdf
std::optional<std::array<double, 16>> matrix_of(std::string_view bytes, std::string_view name) {
  constexpr std::size_t head_bytes = 20, matrix_bytes = 16 * sizeof(double);
  while (bytes.size() >= head_bytes) {
    std::array<std::uint32_t, 5> head{};  // type, rows, columns, whether complex, bytes of the name
    std::memcpy(head.data(), bytes.data(), head_bytes);
    bytes.remove_prefix(head_bytes);
    constexpr std::uint32_t little_endian_doubles = 0;
    if (head[0] != little_endian_doubles || head[1] != 4 || head[2] != 4 || head[3] != 0 ||
        head[4] == 0 || bytes.size() < head[4] || bytes.size() - head[4] < matrix_bytes)
      return std::nullopt;
    const std::string_view called = bytes.substr(0, head[4] - 1);
    bytes.remove_prefix(head[4]);
    std::array<double, 16> matrix{};
    std::memcpy(matrix.data(), bytes.data(), matrix_bytes);
    bytes.remove_prefix(matrix_bytes);
    if (called == name) return matrix;
  }
  return std::nullopt;
}

// Reads SPM's matrix from the file beside an Analyze pair: `mat`, or `M` with reversed x. Voxels
// are counted from 1.
bool read_spm_matrix(VolumeInfo& info, std::filesystem::path file, DeclaredPlace& place) {
  std::ifstream in(without_packing(file).replace_extension(".mat"), std::ios::binary);
  if (!in) return false;
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  auto matrix = matrix_of(bytes, "mat");
  const bool is_mirrored = !matrix;
  if (!matrix) matrix = matrix_of(bytes, "M");
  Rows rows{};
  for (std::size_t row = 0; matrix && row < 3; ++row) {
    for (std::size_t axis = 0; axis < 4; ++axis) rows[row][axis] = (*matrix)[4 * axis + row];
    for (std::size_t axis = 0; axis < 3; ++axis) rows[row][3] += rows[row][axis];
    if (is_mirrored && row == 0)
      for (double& each : rows[row]) each = -each;
  }
  if (set_place(rows, place)) return true;
  note(info, "the .mat file beside it is no matrix of MATLAB 4, and is ignored; save it with -v4");
  return false;
}

// Follows SPM and nibabel: x runs from right to left.
bool read_origin(VolumeInfo& info, const NiftiHeader& header, DeclaredPlace& place) {
  for (std::size_t i = 0; i < 3; ++i)
    if (header.originator[i] < 1 || header.originator[i] > static_cast<int>(info.dims[i]))
      return false;
  place.space = Space::ras;
  Axes& steps = place.steps.emplace();
  for (std::size_t i = 0; i < 3; ++i) {
    steps[i][i] = place.spacing[i].value_or(1) * (i == 0 ? -1 : 1);
    place.origin[i] = (1 - header.originator[i]) * steps[i][i];
  }
  note(info, "the origin is SPM's, and x runs from right to left as SPM reads Analyze");
  return true;
}

void set_geometry(VolumeInfo& info, const std::filesystem::path& file, const NiftiHeader& header,
                  const VolumeOptions& options) {
  DeclaredPlace place;
  place.set_unit(name_of(header.unit));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place.spacing[axis] = std::fabs(header.pixdim[axis + 1]);
    if (header.pixdim[axis + 1] < 0)
      note(info, "pixdim " + std::to_string(axis + 1) + " is negative, and read as positive");
  }
  bool is_placed = header.sform_code > 0 && set_place(header.srow, place);
  if (is_placed) note_mirrored(info, header, place);
  if (header.sform_code > 0 && !is_placed) note(info, "the sform spans no space, and is ignored");
  if (!is_placed && header.qform_code > 0) {
    is_placed = set_place(qform_of(header), place);
    if (!is_placed) note(info, "the qform spans no space, and is ignored");
  }
  if (!is_placed && header.is_analyze()) is_placed = read_spm_matrix(info, file, place);
  if (!is_placed) is_placed = read_origin(info, header, place);
  if (!is_placed) note(info, "no orientation (sform, qform); left and right are unknown");
  set_place(info, place, options);
}

// A slope that is not a number means no scaling, as in nibabel and FSL.
void set_values(VolumeInfo& info, const std::filesystem::path& file, const NiftiHeader& header) {
  const bool has_slope = std::isfinite(header.scl_slope) && header.scl_slope != 0;
  if (!std::isfinite(header.scl_slope))
    note(info, "scl_slope is " + std::to_string(header.scl_slope) + ", and is ignored");
  set_scale(info, file, has_slope ? header.scl_slope : 0, has_slope ? header.scl_inter : 0);
}

std::uint64_t data_offset(const std::filesystem::path& file, const NiftiHeader& header) {
  if (header.vox_offset < 0)
    fail(file, "vox_offset is " + std::to_string(header.vox_offset), "correct the header");
  const auto offset = static_cast<std::uint64_t>(header.vox_offset);
  // Some programs leave 0 for "directly after the header".
  const std::uint64_t min_offset = header.format == "NIfTI-2" ? 544 : 352;
  return header.is_one_file && offset < min_offset ? min_offset : offset;
}

}  // namespace

std::unique_ptr<VolumeReader> open_nifti(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const bool is_data = lower(without_packing(file).extension().string()) == ".img";
  if (is_data) stream = open_content(partner(file, ".hdr"));
  const NiftiHeader header = read_nifti_header(stream);
  VolumeInfo info;
  set_samples(info, file, header, options);
  set_geometry(info, file, header, options);
  set_values(info, file, header);
  info.format = header.format;

  const std::uint64_t offset = data_offset(file, header);
  constexpr auto no_end = std::numeric_limits<std::uint64_t>::max();
  if (!header.is_analyze())
    read_label_extensions(stream, header.is_one_file ? offset : no_end, header.is_big_endian, info);
  if (header.is_one_file) {
    stream.skip(offset - stream.position());
  } else {
    info.format += " pair";
    stream = open_content(is_data ? file : partner(file, ".img"));
    stream.skip(offset);
  }
  return channel_of(file, std::move(info), options.channel, [&](VolumeInfo all) {
    return std::make_unique<SliceStream>(std::move(all), std::move(stream), header.is_big_endian,
                                         options.frame);
  });
}

}  // namespace discmc::command
