#include "volume_format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "text/control_character.hpp"
#include "text/number_text.hpp"

namespace discmc::command {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";
constexpr std::int64_t max_across = 32766;
// The half-steps of the last slice must fit into 31 bits.
constexpr std::int64_t max_slices = (std::int64_t{1} << 30) - 1;

bool usable(double spacing_mm) {
  const double size = std::fabs(spacing_mm);
  return size >= min_spacing_mm && size <= max_spacing_mm;
}

// The signs of the axes where each is mostly along its coordinate; otherwise that of the whole.
std::array<double, 3> signs_of(const Axes& axes) {
  constexpr double mostly_along = 0.75;  // no other component can be larger
  std::array<double, 3> signs{};
  bool near = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = std::hypot(axes[i][0], axes[i][1], axes[i][2]);
    signs[i] = std::copysign(1.0, axes[i][i]);
    near = near && std::fabs(axes[i][i]) > mostly_along * length;
  }
  const double hand = std::copysign(1.0, determinant(axes));
  if (near && signs[0] * signs[1] * signs[2] == hand) return signs;
  return {1, 1, hand};
}

std::string list(const std::array<double, 3>& numbers) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '(' << numbers[0] << ", " << numbers[1] << ", " << numbers[2] << ')';
  return text.str();
}

// " ('red', 'green', 'blue')", of the first names.
std::string in_brackets(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;
  if (names.empty()) return {};
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most; ++i)
    text += (i == 0 ? " (" : ", ") + shown(names[i]);
  return text + (names.size() > most ? ", ...)" : ")");
}

}  // namespace

void fail(const std::filesystem::path& file, const std::string& what, const std::string& remedy) {
  throw VolumeError(file.string() + ": " + what + "; " + remedy);
}

void require_slice_left(const std::filesystem::path& file, std::size_t read, std::size_t slices) {
  if (read == slices)
    fail(file, "all " + std::to_string(read) + " slices have been read", "open the volume again");
}

ByteStream open_content(const std::filesystem::path& file) {
  ByteStream stream(file);
  if (stream.peek(2) == "\x1f\x8b") stream.decode(inflated);
  return stream;
}

void fail_type(const std::filesystem::path& file, std::string_view type) {
  fail(file, "samples of type " + shown(type) + " are not read",
       "give a volume of one number a voxel: whole, or floating point of 32 or 64 bits");
}

std::string shown(std::string_view text) {
  constexpr std::size_t max_shown = 60;
  std::string result = "'";
  for (const char c : text.substr(0, max_shown)) result += is_control(c) ? '?' : c;
  return result + (text.size() > max_shown ? "...'" : "'");
}

std::uint64_t bytes_of_all(const VolumeInfo& info) {
  return info.slice_bytes() * info.dims[2] * info.frames;
}

void skip_to_end(ByteStream& stream, std::uint64_t bytes) {
  const auto left = stream.left();
  if (!left)
    fail(stream.file(), "the data is the end of a file, and this has no known end",
         "store it in a file, not compressed");
  if (bytes > *left)
    fail(stream.file(),
         "the last " + std::to_string(bytes) + " bytes are data, but the file has only " +
             std::to_string(*left),
         "copy or export the file again");
  stream.skip(*left - bytes);
}

void skip_to_frame(ByteStream& stream, const VolumeInfo& info, const VolumeOptions& options) {
  stream.skip(info.slice_bytes() * info.dims[2] * options.frame.value_or(0));
}

std::optional<std::string_view> take_line(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> result;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    result.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return result;
}

std::filesystem::path beside(const std::filesystem::path& header, std::string_view name) {
  // A zero byte would end the name early, and every message that shows it.
  if (std::any_of(name.begin(), name.end(), is_control))
    fail(header, "the data file " + shown(name) + " has control characters in its name",
         "correct the header");
  return header.parent_path() / std::filesystem::path(std::string(name));
}

std::string extents(const std::array<std::uint32_t, 3>& dims) {
  return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " +
         std::to_string(dims[2]);
}

std::int64_t integer(const std::filesystem::path& file, std::string_view field,
                     std::string_view text) {
  const auto value = whole_number<std::int64_t>(text);
  if (!value)
    fail(file, std::string(field) + " is " + shown(text) + ", which is no whole number in range",
         "correct the header");
  return *value;
}

double real(const std::filesystem::path& file, std::string_view field, std::string_view text) {
  if (lower(text) == "nan") return std::numeric_limits<double>::quiet_NaN();
  // A stream of its own: strtod follows the user's locale, from_chars is missing in some libraries.
  std::istringstream in{std::string(text)};
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  if (text.empty() || !in || in.peek() != std::istringstream::traits_type::eof())
    fail(file, std::string(field) + " is " + shown(text) + ", which is no number",
         "correct the header");
  return value;
}

void set_dims(VolumeInfo& info, const std::filesystem::path& file,
              const std::vector<std::int64_t>& sizes, const VolumeOptions& options) {
  if (sizes.size() < 2)
    fail(file, "the data has " + std::to_string(sizes.size()) + " dimensions",
         "give a volume of three");
  info.dims = {1, 1, 1};
  info.frames = 1;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis) {
    const std::int64_t most = axis == 0 || axis == 1 ? max_across : max_slices;
    if (sizes[axis] < 1 || sizes[axis] > most / static_cast<std::int64_t>(info.frames))
      fail(file,
           "dimension " + std::to_string(axis + 1) + " has size " + std::to_string(sizes[axis]) +
               ", outside 1 to " + std::to_string(most / static_cast<std::int64_t>(info.frames)),
           "crop or resample the volume");
    if (axis < 3)
      info.dims[axis] = static_cast<std::uint32_t>(sizes[axis]);
    else
      info.frames *= static_cast<std::uint64_t>(sizes[axis]);
    if (axis >= 3 && sizes[axis] == 1)
      info.notes.push_back("dimension " + std::to_string(axis + 1) + " of size 1 dropped");
  }
  // All bytes can be counted.
  if (info.frames > std::numeric_limits<std::uint64_t>::max() / info.dims[2] / info.slice_bytes())
    fail(file, "the sizes are beyond any file", "correct the header");
  if (sizes.size() == 2) info.notes.emplace_back("two dimensions, taken as one slice");
  const std::string frames = std::to_string(info.frames);
  if (info.frames > 1 && !options.frame)
    fail(file, "the file holds " + frames + " volumes, and one is read at a time",
         "choose one with --frame N, the first is 0");
  if (options.frame && *options.frame >= info.frames)
    fail(file,
         "there is no volume " + std::to_string(*options.frame) + ": the file holds " + frames,
         "choose one with --frame 0 to " + std::to_string(info.frames - 1));
}

void set_channels(VolumeInfo& info, const std::filesystem::path& file, std::uint64_t channels,
                  const VolumeOptions& options, const std::vector<std::string>& names) {
  info.channels = channels;
  const std::string count = std::to_string(channels);
  if (channels > 1 && !options.channel)
    fail(file,
         "the file holds " + count + " channels" + in_brackets(names) +
             ", and one is read at a time",
         "choose one with --channel N, the first is 0");
  if (options.channel && *options.channel >= channels)
    fail(file,
         "there is no channel " + std::to_string(*options.channel) + ": the file holds " + count,
         channels > 1 ? "choose one with --channel 0 to " + std::to_string(channels - 1)
                      : "leave out --channel");
}

void set_spacing(VolumeInfo& info, const std::array<double, 3>& spacing_mm) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    info.spacing_mm[axis] = usable(spacing_mm[axis]) ? spacing_mm[axis] : 1;
    if (usable(spacing_mm[axis])) continue;
    std::ostringstream note;
    note.imbue(std::locale::classic());
    note << "spacing " << spacing_mm[axis] << " of axis " << axis + 1 << " unusable, 1 mm taken";
    info.notes.push_back(note.str());
  }
}

void set_placement(VolumeInfo& info, VolumePlacement placement) {
  if (is_usable(placement.axes_mm)) {
    const std::array<double, 3> signs = signs_of(placement.axes_mm);
    for (std::size_t axis = 0; axis < 3; ++axis)
      info.spacing_mm[axis] = std::copysign(info.spacing_mm[axis], signs[axis]);
  } else {
    info.notes.emplace_back("axis directions unusable, taken as along the coordinates");
    placement.axes_mm = along_coordinates(info.spacing_mm).axes_mm;
  }
  if (!is_usable(placement)) {
    info.notes.push_back("origin " + list(placement.origin_mm) + " unusable, 0 taken");
    placement.origin_mm = {};
  }
  // Sums with zero have no negative zeros.
  for (double& at : placement.origin_mm) at += 0.0;
  for (auto& axis : placement.axes_mm)
    for (double& along : axis) along += 0.0;
  if (!(placement == along_coordinates(info.spacing_mm))) info.placement = placement;
}

void set_part(VolumeInfo& info, const std::filesystem::path& file,
              const std::array<std::uint32_t, 3>& dims, const std::array<double, 3>& first,
              double step) {
  VolumePlacement placement = info.placement.value_or(along_coordinates(info.spacing_mm));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    info.spacing_mm[axis] *= step;
    for (std::size_t i = 0; i < 3; ++i) {
      double& along = placement.axes_mm[axis][i];
      placement.origin_mm[i] += first[axis] * along;
      along *= step;
    }
  }
  if (!is_usable(placement))
    fail(file,
         "the part that is asked for would be more than 1e9 mm away, or its voxels 1e6 mm apart",
         "give the distances of the voxels with --spacing");
  info.placement.reset();
  if (!(placement == along_coordinates(info.spacing_mm))) info.placement = placement;
  if (!info.whole_dims) info.whole_dims = info.dims;
  info.dims = dims;
}

void set_scale(VolumeInfo& info, const std::filesystem::path& file, double slope,
               double intercept) {
  const std::string formula =
      "value = " + std::to_string(slope) + " * stored + " + std::to_string(intercept);
  if (!std::isfinite(slope) || !std::isfinite(intercept))
    fail(file, formula + " is not finite", "correct the slope and intercept in the header");
  if (slope < 0)
    fail(file, formula + " has a negative slope, which turns inside out",
         "negate the samples and the slope");
  info.slope = slope == 0 ? 1 : slope;
  info.intercept = slope == 0 ? 0 : intercept;
}

}  // namespace discmc::command
