// Opens volumes from files and pipes, read slice by slice: the formats of README.md, and headerless
// samples.
//
// A reader holds a small buffer, never the volume. If the file's size does not bound a slice's, it
// holds the first slice. Any file, whatever its bytes, gives a volume or a VolumeError that names
// the file, the fault and the remedy.
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

/// Voxels along an axis, from the first to the last inclusive, counted from 0.
struct VoxelRange {
  std::uint32_t first = 0;
  std::optional<std::uint32_t> last = {};  ///< default: the last voxel of the volume
};

/// A part of a volume, along x, y and z.
using Crop = std::array<VoxelRange, 3>;

/// The value of a voxel that replaces a block.
enum class BlockValue { mean, most_frequent };

/// The order of slices that are separate files.
enum class SliceOrder { position, instance, name };

/// Options for opening a volume.
struct VolumeOptions {
  /// The layout of headerless samples; nothing if the file has a header.
  std::optional<RawLayout> layout = {};
  /// Distances between voxels, instead of the file's; a reversed axis stays reversed. Units:
  /// millimetres. Limit: as VolumeInfo.
  std::optional<std::array<double, 3>> spacing_mm = {};
  /// For DICOM: the UID of the series, or its number in the list of the error message.
  std::string series = {};
  /// For DICOM: another order than by position; positions are then ignored.
  SliceOrder order = SliceOrder::position;
  /// For DICOM: whether one volume may have slices of several series.
  bool merges_series = false;
  /// Whether missing slices in a folder are replaced by the nearest ones, not refused.
  bool allow_gaps = false;
  /// Index of a volume in the file, from 0. Without an index, a file with several volumes is
  /// refused.
  std::optional<std::uint32_t> frame = {};
  /// Index of a channel, likewise.
  std::optional<std::uint32_t> channel = {};
  /// Letters of an array's axes from "tczyx", the slowest first, each once, with x and y. Default:
  /// as in the file, or as in its format.
  std::string axes = {};
  /// Index of a resolution, the finest is 0. Default: the finest that fits VolumeInfo.
  std::optional<std::uint32_t> level = {};
  /// The part of the volume to read. Default: all.
  std::optional<Crop> crop = {};
  /// Extent of the blocks along x, y and z that become one voxel each, after the crop. Limit: 1 to
  /// 16.
  std::uint32_t shrink = 1;
  BlockValue block_value = BlockValue::mean;
  /// Whether values are labels; open_volume() then applies whole_labels().
  bool holds_labels = false;
  /// Further files beside the named one: slices of the same volume, or masks.
  std::vector<std::filesystem::path> others = {};
};

/// Whether the extension is a volume's; headerless files may have any name.
bool is_volume_name(const std::filesystem::path& file);

/// Opens a volume: a file, a folder of DICOM, pictures or masks, files by a pattern with *, ? or
/// [...], a pipe, or "-" for standard input. With a layout, the file has only headerless samples; a
/// name that ends in .gz is inflated first. Without a layout, the name decides the format, or else
/// the first bytes, inflated first if they are gzip. Throws VolumeError if the file cannot be
/// opened, has an unknown format, or has unsupported content. No allocation depends on the sizes
/// that a file declares. A file too short for its first slice is refused here.
std::unique_ptr<VolumeReader> open_volume(const std::filesystem::path& file,
                                          const VolumeOptions& options = {});

/// Throws VolumeError for a file with several volumes, none of which is chosen.
[[noreturn]] void fail_frames(const std::filesystem::path& file, const VolumeInfo& info,
                              const VolumeOptions& options);

}  // namespace discmc::command
