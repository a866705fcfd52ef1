// Volumes made of other volumes: a part, larger voxels, other axes, masked ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meshing.hpp"
#include "samples/label_value.hpp"
#include "volumes/volume.hpp"
#include "volumes/volume_info.hpp"
#include "volumes/volume_offset.hpp"

namespace discmc::command {

/// Returns a part of a volume, which lies where the part does. Slices before it are skipped, and
/// those behind it are not read. Damage there is not found, and a program that writes into a pipe
/// finds it closed. Holds one slice of the volume. Throws a VolumeError where the part is not
/// within the volume. file: for errors.
std::unique_ptr<VolumeReader> cropped(const std::filesystem::path& file,
                                      std::unique_ptr<VolumeReader> volume, const Crop& crop);

/// Every block of extent x extent x extent voxels becomes a voxel in the middle of the block. The
/// last blocks along an axis may hold fewer, and are placed as if they were whole. NaN does not
/// count, unless all samples of a block are NaN: then it is NaN.
///
/// mean: of the block, in the samples' own type. For whole numbers it is exact and rounded to the
/// nearest, halves up. Holds the sums of a slice of blocks.
/// most_frequent: of labels, which have no mean; of equally frequent ones that which comes first in
/// the block, x fastest, then y, then z. Holds the slices of a block.
///
/// Limit: extent 2 to 16. Throws a VolumeError where the voxels would be too large. file: for
/// errors.
std::unique_ptr<VolumeReader> shrunk(const std::filesystem::path& file,
                                     std::unique_ptr<VolumeReader> volume, std::uint32_t extent,
                                     BlockValue value);

/// The layout of samples in blocks; there is a block for each voxel along one axis. Units:
/// samples.
struct BlockLayout {
  std::size_t block_axis = 2;  ///< x, y or z: 0 to 2
  std::uint64_t first = 0;     ///< voxel (0, 0, 0) in the first block
  /// From a voxel to the next one along x, y and z; unused for block_axis.
  std::array<std::uint64_t, 3> strides{};
};

/// info: of the volume. blocks: its slices are the blocks. If there is a block for each z, one is
/// held; otherwise all that the volume has of them. file: for errors.
std::unique_ptr<VolumeReader> turned(VolumeInfo info, std::unique_ptr<VolumeReader> blocks,
                                     const BlockLayout& layout, const std::filesystem::path& file);

/// Puts the axes of a volume in the order and direction of another one, with a note. In memory is a
/// slice, or the volume where its slices lie in another direction.
std::unique_ptr<VolumeReader> turned_to(const AxesMatch& match,
                                        std::unique_ptr<VolumeReader> volume,
                                        const std::filesystem::path& file);

/// Every `count`-th sample of a row, from sample `first` on. all: rows of all samples; `info.dims`
/// times count of them. info: of the component.
std::unique_ptr<VolumeReader> component(std::unique_ptr<VolumeReader> all, VolumeInfo info,
                                        std::uint32_t first, std::uint32_t count);

/// Returns the description of `all` by that of a component. remedy: of rows that are then too long,
/// for the VolumeError.
VolumeInfo of_all_components(const std::string& file, VolumeInfo info, std::uint64_t count,
                             const std::string& remedy = "crop the volume");

/// Returns the channel of a volume whose channels are samples side by side. open: opens what holds
/// all of them, by its description.
std::unique_ptr<VolumeReader> channel_of(
    const std::string& file, VolumeInfo info, std::optional<std::uint32_t> channel,
    const std::function<std::unique_ptr<VolumeReader>(VolumeInfo all)>& open);

/// The values of a volume as floating point, NaN where a sample is the fill value: NaN is outside
/// every surface. fill: as stored.
std::unique_ptr<VolumeReader> without_fill(std::unique_ptr<VolumeReader> volume, double fill);

/// Opens the mask of a volume: samples of u8, 0 where the file's value is 0 or not a number, else
/// 1. options: those of the volume, for its spacing, crop and shrink; of a block the mask has what
/// most of its voxels have. volume: as it is after them. A mask whose axes are in another order or
/// direction is turned. Unless these axes leave slices as they are, all of it is kept in memory, a
/// byte per voxel. Throws VolumeError as open_volume() does, and if the mask has other extents than
/// the whole volume, or another place once it is turned. One that needs no turning may lie
/// elsewhere.
std::unique_ptr<VolumeReader> open_mask(const std::filesystem::path& file,
                                        const VolumeOptions& options, const VolumeInfo& volume);

/// The labels with 0 where the mask is 0. labels: of whole_labels(). mask: of open_mask().
std::unique_ptr<VolumeReader> masked(std::unique_ptr<VolumeReader> labels,
                                     std::unique_ptr<VolumeReader> mask);

/// The label of a value: the whole number within 0.01 of it. Nothing
/// if there is none, or from 2^53 on, where double rounds some.
std::optional<std::int64_t> nearest_label(double value);

/// The volume with its values as samples: slope 1, intercept 0. Whole numbers stay as they are, up
/// to all 64 bits. Others become i64, each its nearest_label(), and NaN becomes 0. Notes after the
/// last slice count the rounded values and those that are no numbers. Throws VolumeError in
/// read_slice() where a value is of no label. file: for errors.
std::unique_ptr<VolumeReader> whole_labels(const std::filesystem::path& file,
                                           std::unique_ptr<VolumeReader> volume);

/// Labels whose voxels are one surface: values, by the layer that they are in. No values mean
/// all but 0.
using LabelSet = std::map<std::uint32_t, std::vector<LabelValue>>;

/// How many sets a volume has bits for.
constexpr std::size_t max_label_sets = 64;

/// Unsigned samples: bit i is on if the voxel has a label of sets[i]. The type is the smallest one
/// with that many bits. layers: by their numbers, those of the sets; of whole_labels(), of the same
/// extents. Limit: a layer or more, 1 to max_label_sets sets.
std::unique_ptr<VolumeReader> label_bits(
    std::map<std::uint32_t, std::unique_ptr<VolumeReader>> layers,
    const std::vector<LabelSet>& sets);

}  // namespace discmc::command
