// The pictures of a volume: its pages and files, and their common properties.
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
  std::uint32_t channel = 0;  ///< index in the pixels
  Hyperstack described;       ///< description in the first file
  PictureHeader header;       ///< of the first picture
};

/// Returns the pictures of the requested volume, which have equal headers. Sets the numbers of
/// frames and channels, and the notes of the files. source: the named path. Throws VolumeError.
/// Limit: at least one file, in order.
Stack stack_of(const std::filesystem::path& source, const std::vector<std::filesystem::path>& files,
               const VolumeOptions& options, VolumeInfo& info);

/// Throws if the names belong to several stacks; the text has a pattern of one stack. Names do so
/// if they differ in more than their numbers, or if no single number counts the files. source: the
/// named path. files: in natural order.
void require_one_stack(const std::filesystem::path& source,
                       const std::vector<std::filesystem::path>& files);

/// Sets spacing and placement from the files, or from SkyScan's log beside them, and notes what is
/// missing.
void set_place_of(VolumeInfo& info, const Stack& stack, const VolumeOptions& options);

/// Whether the name is x_rec_spr.bmp, NRecon's overview, which is not a slice.
bool is_overview_name(const std::filesystem::path& file);

/// A log of NRecon, SkyScan's reconstruction program.
struct SkyScanLog {
  std::filesystem::path file;
  std::array<double, 3> spacing_mm{};
  /// Width and height of the slices; 0 if the log lacks them.
  std::array<std::uint32_t, 2> size{};
};

/// Returns the log of a stack by one of its slices: a file beside it, whose name begins the slice's
/// name. Returns nothing if no log has a pixel size.
std::optional<SkyScanLog> skyscan_log(const std::filesystem::path& slice);

}  // namespace discmc::command
