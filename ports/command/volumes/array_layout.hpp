// Finds the volume in an array of any number of axes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "declared_place.hpp"
#include "volume.hpp"
#include "volume_stream.hpp"

namespace discmc::command {

/// The description of an array in a file.
struct ArrayShape {
  std::vector<std::int64_t> sizes;         ///< sizes of array[a][b][c]: a, b, c
  std::string letters = {};                ///< one per axis, such as "tczyx", or empty
  std::vector<std::string> channels = {};  ///< names, or empty
  /// Whether neighbours along the first axis are adjacent in the file, not along the last.
  bool is_first_fastest = false;
};

/// The part of an array that is a volume.
struct ArrayLayout {
  /// Neighbours along the last axis are adjacent in the file.
  std::vector<std::uint64_t> sizes;
  /// The axes of the array that are x, y and z; an image has no z.
  std::array<std::optional<std::size_t>, 3> axes;
  /// The index at which the volume begins along each axis: 0, except for the frame and the channel.
  std::vector<std::uint64_t> first;

  /// Returns the axis of the volume along which neighbours lie farthest apart.
  std::size_t slowest() const;
  /// Returns the axes of the volume by their letters, the slowest first: "zyx".
  std::string order() const;
};

/// Finds the volume in an array. Drops axes of size 1, with a note, until there are as many axes as
/// letters, or three. Without letters, the three fastest axes are z, y and x, and other axes count
/// volumes. Throws like set_dims(), if the letters do not fit the axes, and if none of several
/// channels is chosen.
ArrayLayout find_volume_axes(VolumeInfo& info, const std::filesystem::path& file,
                             const ArrayShape& shape, const VolumeOptions& options);

/// Returns the letter of an axis by a common name, such as "lon" or "depth"; '?' for other names.
char axis_letter(std::string_view name);

/// Converts the coordinates of voxels along an axis to spacing and origin. One coordinate more than
/// there are voxels means borders of voxels; any other number is ignored. Throws if the coordinates
/// are uneven, unless the user gives a spacing. name: of the axis, for people.
void set_place_from_coordinates(DeclaredPlace& place, std::size_t axis, const std::string& file,
                                const std::string& name, std::vector<double> coordinates,
                                std::uint64_t voxels, const VolumeOptions& options);

/// Reads the volume of an array; the next byte of the stream is its first sample. Memory: the
/// slices of all channels, or the volume if z is not its slowest axis.
std::unique_ptr<VolumeReader> array_volume(VolumeInfo info, ByteStream stream,
                                           const ArrayLayout& layout, bool is_big_endian);

}  // namespace discmc::command
