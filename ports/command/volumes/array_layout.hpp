// Arrays of any number of axes as volumes: which axis is which, and where their samples are.
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
  std::vector<std::int64_t> sizes;         ///< of array[a][b][c]: a, b, c
  std::string letters = {};                ///< of each axis, such as "tczyx", or nothing
  std::vector<std::string> channels = {};  ///< their names, or none
  /// Whether neighbours along the first axis lie side by side, not along the last one.
  bool is_first_fastest = false;
};

/// A volume in an array.
struct ArrayLayout {
  /// The axis along which neighbours lie side by side is the last one.
  std::vector<std::uint64_t> sizes;
  /// The axes of the array that are x, y and z; an image has no z.
  std::array<std::optional<std::size_t>, 3> axes;
  /// Where the volume begins along each axis: 0 but for the frame and the channel.
  std::vector<std::uint64_t> first;

  /// Returns the axis of the volume along which neighbours lie farthest apart.
  std::size_t slowest() const;
  /// Returns the axes of the volume by their letters, the slowest first: "zyx".
  std::string order() const;
};

/// Takes an array as a volume. Axes of size 1 are dropped, with a note, until as many are left as
/// there are letters, or else three. Without letters, the three fastest axes are z, y and x, and
/// those before them count volumes. Throws as set_dims(), where the letters are not those of the
/// axes, and where of several channels none is chosen.
ArrayLayout take_array(VolumeInfo& info, const std::filesystem::path& file, const ArrayShape& shape,
                       const VolumeOptions& options);

/// Returns the letter of an axis by the name that people give it, "lon" or "depth"; '?' if that is
/// of none.
char axis_letter(std::string_view name);

/// Takes the coordinates of voxels along an axis, x, y or z, as spacing and origin of a place. One
/// more than there are voxels are those of their borders; any other number is ignored. Throws where
/// they are uneven, unless the user gives a spacing. name: of the axis, for people.
void take_coordinates(DeclaredPlace& place, std::size_t axis, const std::string& file,
                      const std::string& name, std::vector<double> coordinates,
                      std::uint64_t voxels, const VolumeOptions& options);

/// The volume of an array whose first sample is next in the stream. In memory are the slices of all
/// channels; where z is not the slowest of its axes, the volume.
std::unique_ptr<VolumeReader> array_volume(VolumeInfo info, ByteStream stream,
                                           const ArrayLayout& layout, bool is_big_endian);

}  // namespace discmc::command
