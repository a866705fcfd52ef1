// The pictures of a volume: which pages of which files, and what these have in common.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "hyperstack.hpp"
#include "picture_file.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

struct Stack {
  std::vector<std::filesystem::path> files;
  std::vector<Page> pages;    ///< the slices
  std::uint32_t channel = 0;  ///< of the pixels
  Hyperstack described;       ///< by the first file
  PictureHeader header;       ///< of the first picture
};

/// Returns the pictures of the volume that is asked for, all alike. Sets the numbers of frames and
/// channels, and the notes of its files. source: what was named. Throws VolumeError. Limit: one
/// file or more, in their order.
Stack stack_of(const std::filesystem::path& source, const std::vector<std::filesystem::path>& files,
               const VolumeOptions& options, VolumeInfo& info);

/// Throws if the names belong to several stacks, with a pattern of one of them. They do if they
/// differ in more than their numbers, or if no number counts the files by itself. source: what was
/// named. files: in natural order.
void require_one_stack(const std::filesystem::path& source,
                       const std::vector<std::filesystem::path>& files);

/// Sets spacing and placement as the files describe them, or SkyScan's log beside them, with notes
/// of what they leave out.
void set_place_of(VolumeInfo& info, const Stack& stack, const VolumeOptions& options);

/// Whether the name is that of NRecon's overview, no slice: x_rec_spr.bmp.
bool is_overview_name(const std::filesystem::path& file);

/// A log of SkyScan's reconstruction program, NRecon.
struct SkyScanLog {
  std::filesystem::path file;
  std::array<double, 3> spacing_mm{};
  /// Width and height of the slices; 0 if the log lacks them.
  std::array<std::uint32_t, 2> size{};
};

/// Returns the log of a stack, by one of its slices: beside it, and called as it begins. Nothing
/// if there is none with a pixel size.
std::optional<SkyScanLog> skyscan_log(const std::filesystem::path& slice);

}  // namespace discmc::command
