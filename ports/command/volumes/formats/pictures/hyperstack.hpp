// Pages of picture files as volumes: slices of channels at times, as OME-XML, ImageJ and tifffile
// describe them.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace discmc::command {

/// A page, the first is 0, of one of several files.
struct Page {
  std::uint32_t file = 0;
  std::uint32_t number = 0;
};

/// Successive pages of a file that are successive planes of a hyperstack.
struct PageRun {
  std::uint32_t file = 0;  ///< of those of the hyperstack
  std::uint64_t first_page = 0;
  std::uint64_t first_plane = 0;
  std::uint64_t count = 0;
};

/// An axis of a hyperstack.
struct PlaneAxis {
  std::uint64_t size = 1;
  std::uint64_t step = 1;  ///< Units: planes from one to the next along the axis
};

/// Planes as volumes of one size, one for each channel and frame. A frame is a time, or what else
/// distinguishes volumes.
struct Hyperstack {
  std::string name;  ///< for people, may be empty
  PlaneAxis slices, channels, frames;
  std::vector<std::filesystem::path> files;
  std::vector<PageRun> runs;
  std::vector<std::string> channel_names;
  /// Width and height that the description promises.
  std::optional<std::array<std::uint64_t, 2>> plane_size;
  /// Units: millimetres; nothing along an axis whose spacing is not described.
  std::array<std::optional<double>, 3> spacing_mm{};
  /// The voxel at the origin of the coordinates. Units: voxels.
  std::array<double, 3> origin_voxel{};
  /// value = slope * stored + intercept.
  double slope = 1;
  double intercept = 0;
  std::vector<std::string> notes;
};

/// Sets the steps of axes that are stored in this order, the fastest first: "czt". Letters other
/// than c, z and t have no meaning.
void set_order(Hyperstack& stack, std::string_view order);

/// Takes all planes as those along one axis: 'c', 'z' or 't'.
void set_axis(Hyperstack& stack, char axis);

/// A further remedy if several channels or frames have one slice each.
constexpr const char* if_slices = "; if they are slices, give --axes zyx";

/// Returns the number of planes, or the greatest number where it is beyond that.
std::uint64_t planes(const Hyperstack& stack);

/// A volume of a file, without its channel.
struct ChosenFrame {
  const Hyperstack* stack = nullptr;
  std::uint64_t frame = 0;   ///< of this stack
  std::uint64_t frames = 0;  ///< of all stacks of the file
};

/// Returns the frame that is asked for, counted through all stacks. Throws when there is none, and
/// when there are several and none is asked for.
ChosenFrame chosen_frame(const std::filesystem::path& file, const std::vector<Hyperstack>& stacks,
                         std::optional<std::uint32_t> frame);

/// Returns the pages of a volume, first slice to last. Throws when one is missing, or described
/// twice. Limit: all pages of all runs exist.
std::vector<Page> pages_of(const std::filesystem::path& file, const Hyperstack& stack,
                           std::uint64_t channel, std::uint64_t frame);

}  // namespace discmc::command
