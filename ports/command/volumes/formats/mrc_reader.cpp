// MRC and CCP4 maps, https://www.ccpem.ac.uk/mrc_format/mrc2014.php: a header of 1024 bytes, an
// extended header, and sections of rows of columns. Columns, rows and sections may each run along
// x, y or z.
#include <algorithm>
#include <cmath>
#include <utility>

#include "volumes/array_layout.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_bytes.hpp"

namespace discmc::command {
namespace {

constexpr std::size_t header_bytes = 1024;

// Offsets of fields. Units: bytes.
constexpr std::size_t counts_at = 0;  // columns, rows, sections
constexpr std::size_t mode_at = 12;
constexpr std::size_t starts_at = 16;     // of columns, rows, sections
constexpr std::size_t intervals_at = 28;  // of the cell, along x, y and z
constexpr std::size_t cell_at = 40;       // its edges; at 52 its angles
constexpr std::size_t axes_at = 64;       // axes of columns, rows and sections, 1 to 3
constexpr std::size_t space_group_at = 88;
constexpr std::size_t extended_bytes_at = 92;
constexpr std::size_t imod_stamp_at = 152;
constexpr std::size_t imod_flags_at = 156;
constexpr std::size_t origin_at = 196;
constexpr std::size_t stamp_at = 212;

bool is_axis(std::int32_t axis) {
  return axis >= 1 && axis <= 3;
}

// Decides by the machine stamp. Old files have none, but their modes and axes are small numbers.
bool has_big_endian_header(ByteStream& stream) {
  const std::string_view head = stream.peek(header_bytes);
  if (head.size() < header_bytes) return false;
  const char stamp = head[stamp_at];
  if (stamp == 0x44) return false;
  if (stamp == 0x11) return true;
  return head[mode_at] == 0 && head[mode_at + 1] == 0 &&
         (head[mode_at + 3] != 0 || head[axes_at + 3] != 0);
}

std::array<std::int32_t, 3> integers(const HeaderBytes& header, std::size_t offset) {
  std::array<std::int32_t, 3> numbers{};
  for (std::size_t i = 0; i < 3; ++i) numbers[i] = header.number<std::int32_t>(offset + 4 * i);
  return numbers;
}

struct Storage {
  SampleType type = SampleType::u8;
  bool is_half = false;
};

// Older programs of IMOD wrote unsigned bytes, before this flag existed.
Storage storage_of(VolumeInfo& info, const std::filesystem::path& file, const HeaderBytes& header) {
  constexpr std::int32_t imod_stamp = 1146047817;
  constexpr std::int32_t has_sign = 1;
  const auto mode = header.number<std::int32_t>(mode_at);
  switch (mode) {
    case 0:
      if (header.number<std::int32_t>(imod_stamp_at) == imod_stamp &&
          (header.number<std::int32_t>(imod_flags_at) & has_sign) == 0) {
        note(info, "bytes are read as u8, as IMOD wrote them");
        return {SampleType::u8};
      }
      return {SampleType::i8};
    case 1:
      return {SampleType::i16};
    case 2:
      return {SampleType::f32};
    case 6:
      return {SampleType::u16};
    case 12:
      return {SampleType::f32, true};
    default:
      fail(file, "samples of MRC's mode " + std::to_string(mode) + " are not supported",
           mode == 3 || mode == 4 ? "give a map of real numbers, not of a transform"
                                  : "convert it, e.g. with IMOD: newstack -mode 2 IN OUT");
  }
}

// Returns the axes of space, 0 to 2, along which columns, rows and sections run.
std::array<std::size_t, 3> axes_of(VolumeInfo& info, const std::filesystem::path& file,
                                   const HeaderBytes& header) {
  const auto axis_numbers = integers(header, axes_at);
  if (axis_numbers == std::array<std::int32_t, 3>{}) {
    note(info, "no axes given, columns, rows and sections are read as x, y and z");
    return {0, 1, 2};
  }
  if (!std::all_of(axis_numbers.begin(), axis_numbers.end(), is_axis) ||
      axis_numbers[0] == axis_numbers[1] || axis_numbers[0] == axis_numbers[2] ||
      axis_numbers[1] == axis_numbers[2])
    fail(file,
         "MAPC, MAPR and MAPS are " + std::to_string(axis_numbers[0]) + ", " +
             std::to_string(axis_numbers[1]) + " and " + std::to_string(axis_numbers[2]),
         "correct them: 1, 2 and 3 in some order");
  std::array<std::size_t, 3> axes{};
  for (std::size_t i = 0; i < 3; ++i) axes[i] = static_cast<std::size_t>(axis_numbers[i] - 1);
  return axes;
}

// Returns sections in stored order, and the number of volumes that they form.
ArrayShape shape_of(const std::filesystem::path& file, const HeaderBytes& header,
                    const std::array<std::size_t, 3>& axes) {
  const auto counts = integers(header, counts_at);
  ArrayShape shape;
  for (std::size_t i = 3; i-- > 0;) {
    shape.sizes.push_back(counts[i]);
    shape.letters += "xyz"[axes[i]];
  }
  constexpr std::int32_t first_of_stacks = 401, last_of_stacks = 630;
  const auto group = header.number<std::int32_t>(space_group_at);
  if (group < first_of_stacks || group > last_of_stacks) return shape;
  const auto sections = integers(header, intervals_at)[2];
  if (sections < 1 || counts[2] % sections != 0)
    fail(file,
         "a stack of volumes has " + std::to_string(counts[2]) + " sections, but a volume " +
             std::to_string(sections),
         "correct NZ or MZ");
  shape.sizes[0] = sections;
  shape.sizes.insert(shape.sizes.begin(), counts[2] / sections);
  shape.letters.insert(shape.letters.begin(), 't');
  return shape;
}

// Returns the edges of the cell. The first runs along x, the second in the plane of x and y.
Axes edges_of(const HeaderBytes& header) {
  constexpr double degree = 3.14159265358979323846 / 180;
  const auto lengths = header.reals(cell_at);
  auto angles = header.reals(cell_at + 12);
  for (double& angle : angles)
    if (!(angle > 0 && angle < 180)) angle = 90;
  std::array<double, 3> cosines{};
  for (std::size_t i = 0; i < 3; ++i)
    cosines[i] = angles[i] == 90 ? 0 : std::cos(angles[i] * degree);
  const double sine = std::sqrt(1 - cosines[2] * cosines[2]);
  const double along_y = (cosines[0] - cosines[1] * cosines[2]) / sine;
  const double along_z = std::sqrt(std::max(0.0, 1 - cosines[1] * cosines[1] - along_y * along_y));
  Axes edges{{{1, 0, 0}, {cosines[2], sine, 0}, {cosines[1], along_y, along_z}}};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double& along : edges[axis]) along *= lengths[axis];
  return edges;
}

// The map begins at ORIGIN. If ORIGIN is 0, the first column, row and section are counted from
// those of the cell.
DeclaredPlace place_of(VolumeInfo& info, const HeaderBytes& header,
                       const std::array<std::size_t, 3>& axes) {
  DeclaredPlace place;
  const auto intervals = integers(header, intervals_at);
  const auto lengths = header.reals(cell_at);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(intervals[axis] > 0 && lengths[axis] > 0)) return place;
  note(info, "lengths are in angstrom; 1 angstrom is written as 1 mm");
  place.set_unit("mm");
  Axes& steps = place.steps.emplace(edges_of(header));
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double& along : steps[axis]) along /= intervals[axis];
  place.origin = header.reals(origin_at);
  const auto starts = integers(header, starts_at);
  if (place.origin == std::array<double, 3>{})
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) place.origin[j] += starts[i] * steps[axes[i]][j];
  return place;
}

}  // namespace

std::unique_ptr<VolumeReader> open_mrc(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  bool is_big_endian = has_big_endian_header(stream);
  const HeaderBytes header(stream, header_bytes, is_big_endian);
  VolumeInfo info;
  info.format = "MRC";
  const Storage storage = storage_of(info, file, header);
  info.type = storage.type;
  const auto axes = axes_of(info, file, header);
  const ArrayLayout layout = find_volume_axes(info, file, shape_of(file, header, axes), options);
  set_place(info, place_of(info, header, axes), options);
  const auto extended = header.number<std::int32_t>(extended_bytes_at);
  if (extended < 0)
    fail(file, "the extended header has " + std::to_string(extended) + " bytes", "correct NSYMBT");
  stream.skip(static_cast<std::uint64_t>(extended));
  if (storage.is_half) {
    stream.decode(
        [is_big_endian](auto in) { return floats_of_halves(std::move(in), is_big_endian); });
    is_big_endian = is_native_big_endian();
  }
  return array_volume(std::move(info), std::move(stream), layout, is_big_endian);
}

}  // namespace discmc::command
