// The volumes in pages of picture files: slices, channels and times, described by OME-XML, ImageJ
// or tifffile.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace discmc::command {

/// A page, from 0, of one of several files.
struct Page {
  std::uint32_t file = 0;
  std::uint32_t number = 0;
};

/// Successive pages of a file that are successive planes of a hyperstack.
struct PageRun {
  std::uint32_t file = 0;  ///< index among the hyperstack's files
  std::uint64_t first_page = 0;
  std::uint64_t first_plane = 0;
  std::uint64_t count = 0;
};

/// An axis of a hyperstack.
struct PlaneAxis {
  std::uint64_t size = 1;
  std::uint64_t step = 1;  ///< distance of neighbours along the axis; Units: planes
};

/// Planes that form volumes of one size, one per channel and frame. A frame is a time, or another
/// index of volumes.
struct Hyperstack {
  std::string name;  ///< for people; may be empty
  PlaneAxis slices, channels, frames;
  std::vector<std::filesystem::path> files;
  std::vector<PageRun> runs;
  std::vector<std::string> channel_names;
  /// Width and height in the description.
  std::optional<std::array<std::uint64_t, 2>> plane_size;
  /// Units: millimetres; nothing if the spacing along an axis is not described.
  std::array<std::optional<double>, 3> spacing_mm{};
  /// The voxel at the origin of the coordinates. Units: voxels.
  std::array<double, 3> origin_voxel{};
  /// value = slope * stored + intercept.
  double slope = 1;
  double intercept = 0;
  std::vector<std::string> notes;
};

/// Sets the steps of axes stored in this order, the fastest first: "czt". Ignores letters other
/// than c, z and t.
void set_order(Hyperstack& stack, std::string_view order);

/// Treats all planes as planes along one axis: 'c', 'z' or 't'.
void set_axis(Hyperstack& stack, char axis);

/// A further remedy if channels or frames have only one slice each.
constexpr const char* if_slices = "; if they are slices, give --axes zyx";

/// Returns the number of planes, limited to the maximum of the type.
std::uint64_t planes(const Hyperstack& stack);

/// A volume of a file, without its channel.
struct ChosenFrame {
  const Hyperstack* stack = nullptr;
  std::uint64_t frame = 0;   ///< index in `stack`
  std::uint64_t frames = 0;  ///< total of all stacks
};

/// Returns the requested frame, counted through all stacks. Throws if it does not exist, or if
/// there are several frames and none is requested.
ChosenFrame chosen_frame(const std::filesystem::path& file, const std::vector<Hyperstack>& stacks,
                         std::optional<std::uint32_t> frame);

/// Returns the pages of a volume, from the first slice to the last. Throws if a page is missing or
/// described twice. Limit: all pages of all runs exist.
std::vector<Page> pages_of(const std::filesystem::path& file, const Hyperstack& stack,
                           std::uint64_t channel, std::uint64_t frame);

}  // namespace discmc::command
