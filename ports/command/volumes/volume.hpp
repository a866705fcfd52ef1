// Volumes from files and pipes, slice by slice: the formats of README.md, and headerless samples.
//
// A reader holds a small buffer, never the volume. If the size of the file does not bound that of a
// slice, it holds the first slice. Any bytes given as a file end in a volume or in a VolumeError,
// which names the file, the fault and the remedy.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "meshing.hpp"
#include "samples/sample_type.hpp"
#include "volume_info.hpp"

namespace discmc::command {

/// The layout of a file without a header.
struct RawLayout {
  /// Units: voxels. Limit: as VolumeInfo.
  std::array<std::uint32_t, 3> dims{};
  SampleType type = SampleType::u8;
  bool is_big_endian = false;
  /// Bytes before the samples.
  std::uint64_t skipped_bytes = 0;
};

/// Voxels along an axis: from the first to the last, both of them too. The first voxel of a volume
/// is 0.
struct VoxelRange {
  std::uint32_t first = 0;
  std::optional<std::uint32_t> last = {};  ///< else the last one of the volume
};

/// A part of a volume, along x, y and z.
using Crop = std::array<VoxelRange, 3>;

/// The voxel that replaces a block of voxels.
enum class BlockValue { mean, most_frequent };

/// By what the slices of a volume are put in order that are files of their own.
enum class SliceOrder { position, instance, name };

/// The options of a volume.
struct VolumeOptions {
  /// The layout of headerless samples; nothing where the file has a header.
  std::optional<RawLayout> layout = {};
  /// Distances of voxels instead of those in the file; an axis that runs backwards still
  /// does. Units: millimetres. Limit: as VolumeInfo.
  std::optional<std::array<double, 3>> spacing_mm = {};
  /// For DICOM: the UID of the series, or its number in the list of the error if there are several.
  std::string series = {};
  /// For DICOM: another order than by positions, which are then ignored.
  SliceOrder order = SliceOrder::position;
  /// For DICOM: whether slices of several series are of one volume.
  bool merges_series = false;
  /// Whether slices that are missing in a folder are filled with the nearest ones, not refused.
  bool allow_gaps = false;
  /// Which of the volumes of a file, the first is 0. Without it, a file of several is refused.
  std::optional<std::uint32_t> frame = {};
  /// Which of the channels, likewise.
  std::optional<std::uint32_t> channel = {};
  /// What the axes of an array are, the slowest first: letters of "tczyx", each once, x and y among
  /// them. Otherwise as in the file, or as in its format.
  std::string axes = {};
  /// Which of the resolutions of a file, the finest is 0. Otherwise the finest that VolumeInfo
  /// takes.
  std::optional<std::uint32_t> level = {};
  /// The part of the volume that is taken; otherwise all of it.
  std::optional<Crop> crop = {};
  /// Blocks of this many voxels along x, y and z become one voxel each, after the crop.
  /// Limit: 1 to 16.
  std::uint32_t shrink = 1;
  BlockValue block_value = BlockValue::mean;
  /// Whether values are labels: their volume is then that of whole_labels().
  bool holds_labels = false;
  /// Files beside the one that is named: slices of the same volume, or masks.
  std::vector<std::filesystem::path> others = {};
};

/// Whether the name is that of a volume, by its extension; headerless ones may have any name.
bool is_volume_name(const std::filesystem::path& file);

/// Opens a volume: a file, a folder of DICOM, pictures or masks, files by a pattern with *, ? or
/// [...], a pipe, or "-" for standard input. With a layout the file has headerless samples and
/// nothing else; if its name ends in .gz, it is inflated first. Without one the name decides the
/// format, or else the first bytes, inflated first if they are gzip. Throws VolumeError when the
/// file cannot be opened, is in no known format, or holds what the command does not take. Nothing
/// is allocated that depends on the sizes a file claims, and a file too short for its first slice
/// is refused here.
std::unique_ptr<VolumeReader> open_volume(const std::filesystem::path& file,
                                          const VolumeOptions& options = {});

/// Throws the refusal of a file with several volumes of which none is chosen.
[[noreturn]] void fail_frames(const std::filesystem::path& file, const VolumeInfo& info,
                              const VolumeOptions& options);

}  // namespace discmc::command
