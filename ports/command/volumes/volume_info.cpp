#include "volume_info.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>

namespace discmc::command {
namespace {

// The half-steps of the last slice must fit into 31 bits.
constexpr std::int64_t max_slices = (std::int64_t{1} << 30) - 1;

// Returns the first names, such as " ('red', 'green', 'blue')".
std::string in_brackets(const std::vector<std::string>& names) {
  constexpr std::size_t max_shown = 8;
  if (names.empty()) return {};
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < max_shown; ++i)
    text += (i == 0 ? " (" : ", ") + shown(names[i]);
  return text + (names.size() > max_shown ? ", ...)" : ")");
}

}  // namespace

void note(VolumeInfo& info, const std::string& text) {
  if (std::find(info.notes.begin(), info.notes.end(), text) == info.notes.end())
    info.notes.push_back(text);
}

void set_dims(VolumeInfo& info, const std::string& file, const std::vector<std::int64_t>& sizes,
              std::optional<std::uint32_t> frame) {
  if (sizes.size() < 2)
    fail(file, "the data has " + std::to_string(sizes.size()) + " dimensions",
         "give a volume of three");
  info.dims = {1, 1, 1};
  info.frames = 1;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis) {
    const std::int64_t max_size = axis == 0 || axis == 1 ? max_across : max_slices;
    if (sizes[axis] < 1 || sizes[axis] > max_size / static_cast<std::int64_t>(info.frames))
      fail(file,
           "dimension " + std::to_string(axis + 1) + " has size " + std::to_string(sizes[axis]) +
               ", outside 1 to " +
               std::to_string(max_size / static_cast<std::int64_t>(info.frames)),
           "crop or resample the volume");
    if (axis < 3)
      info.dims[axis] = static_cast<std::uint32_t>(sizes[axis]);
    else
      info.frames *= static_cast<std::uint64_t>(sizes[axis]);
    if (axis >= 3 && sizes[axis] == 1)
      note(info, "dimension " + std::to_string(axis + 1) + " of size 1 is dropped");
  }
  // Throws unless the number of bytes fits 64 bits.
  if (info.frames > std::numeric_limits<std::uint64_t>::max() / info.dims[2] / info.slice_bytes())
    fail(file, "the sizes are larger than any file", "correct the header");
  if (sizes.size() == 2) note(info, "two dimensions, read as one slice");
  if (frame && *frame >= info.frames)
    fail(file,
         "there is no volume " + std::to_string(*frame) + ": the file holds " +
             std::to_string(info.frames),
         info.frames > 1 ? "choose one with --frame 0 to " + std::to_string(info.frames - 1)
                         : "leave out --frame");
}

void set_channels(VolumeInfo& info, const std::string& file, std::uint64_t channels,
                  std::optional<std::uint32_t> channel, const std::vector<std::string>& names) {
  info.channels = channels;
  const std::string count = std::to_string(channels);
  if (channels > 1 && !channel)
    fail(file,
         "the file holds " + count + " channels" + in_brackets(names) +
             ", and one is read at a time",
         "choose one with --channel N, the first is 0");
  if (channel && *channel >= channels)
    fail(file, "there is no channel " + std::to_string(*channel) + ": the file holds " + count,
         channels > 1 ? "choose one with --channel 0 to " + std::to_string(channels - 1)
                      : "leave out --channel");
}

void set_scale(VolumeInfo& info, const std::string& file, double slope, double intercept) {
  const std::string formula =
      "value = " + std::to_string(slope) + " * stored + " + std::to_string(intercept);
  if (!std::isfinite(slope) || !std::isfinite(intercept))
    fail(file,
         "the scale " + std::to_string(slope) + " and offset " + std::to_string(intercept) +
             " are not finite",
         "correct the slope and intercept in the header");
  if (slope < 0)
    fail(file, formula + " has a negative slope, which would turn the surface inside out",
         "negate the samples and the slope");
  info.slope = slope == 0 ? 1 : slope;
  info.intercept = slope == 0 ? 0 : intercept;
}

void require_possible(const std::string& file, const std::string& what, std::uint64_t bytes,
                      std::uint64_t expansion) {
  std::error_code error;
  const std::uint64_t stored = std::filesystem::file_size(file, error);
  if (!error && bytes / expansion > stored)
    fail(file,
         what + " of " + std::to_string(bytes) + " bytes cannot be in a file of " +
             std::to_string(stored),
         copy_or_export);
}

void set_part(VolumeInfo& info, const std::string& file, const std::array<std::uint32_t, 3>& dims,
              const std::array<double, 3>& first, double step) {
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
    fail(file, "the part would be more than 1e9 mm away, or its voxels more than 1e6 mm apart",
         "give the distances between voxels with --spacing");
  info.placement.reset();
  if (!(placement == along_coordinates(info.spacing_mm))) info.placement = placement;
  if (!info.whole_dims) info.whole_dims = info.dims;
  info.dims = dims;
}

std::uint64_t volume_bytes(const VolumeInfo& info) {
  return info.slice_bytes() * info.dims[2];
}

std::uint64_t bytes_of_all(const VolumeInfo& info) {
  return volume_bytes(info) * info.frames;
}

std::string extents(const std::array<std::uint32_t, 3>& dims) {
  return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " +
         std::to_string(dims[2]);
}

}  // namespace discmc::command
