// Filters that make a volume from another one: a part, larger voxels, other axes, or a mask.
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

/// Returns a part of a volume, at its place. Slices before the part are skipped, and slices after
/// it are not read. Damage there is not found, and a program that writes into a pipe finds it
/// closed. Memory: one slice of the volume. Throws VolumeError if the part is not within the
/// volume. file: for errors.
std::unique_ptr<VolumeReader> cropped(const std::filesystem::path& file,
                                      std::unique_ptr<VolumeReader> volume, const Crop& crop);

/// Replaces every block of extent x extent x extent voxels by one voxel in its middle. The last
/// blocks along an axis may hold fewer voxels, and are placed like whole ones. NaN does not count,
/// unless all samples of a block are NaN.
///
/// mean: of the block, in the samples' own type. The mean of whole numbers is rounded to the
/// nearest, halves up. Memory: the sums of a slice of blocks.
/// most_frequent: for labels, which have no mean. Among equally frequent labels, the first in the
/// block counts, x fastest, then y, then z. Memory: the slices of a block.
///
/// Limit: extent 2 to 16. Throws VolumeError if the voxels would be too large. file: for errors.
std::unique_ptr<VolumeReader> shrunk(const std::filesystem::path& file,
                                     std::unique_ptr<VolumeReader> volume, std::uint32_t extent,
                                     BlockValue value);

/// The layout of samples in blocks, one block per voxel along one axis. Units: samples.
struct BlockLayout {
  std::size_t block_axis = 2;  ///< x, y or z: 0 to 2
  std::uint64_t first = 0;     ///< index of voxel (0, 0, 0) in the first block
  /// Distances of neighbouring voxels along x, y and z; unused for block_axis.
  std::array<std::uint64_t, 3> strides{};
};

/// Turns blocks into slices. info: of the volume. blocks: its slices are the blocks. Memory: one
/// block if each z has a block, otherwise all blocks of the volume. file: for errors.
std::unique_ptr<VolumeReader> turned(VolumeInfo info, std::unique_ptr<VolumeReader> blocks,
                                     const BlockLayout& layout, const std::filesystem::path& file);

/// Puts the axes of a volume into the order and direction of another volume, with a note. Memory: a
/// slice, or the volume if its slices lie in another direction.
std::unique_ptr<VolumeReader> turned_to(const AxesMatch& match,
                                        std::unique_ptr<VolumeReader> volume,
                                        const std::filesystem::path& file);

/// Returns every `count`-th sample of a row, beginning with sample `first`. all: rows of all
/// samples, `count` times as wide as `info.dims`. info: of the component.
std::unique_ptr<VolumeReader> component(std::unique_ptr<VolumeReader> all, VolumeInfo info,
                                        std::uint32_t first, std::uint32_t count);

/// Returns the description of `all` for a component's description. remedy: for the VolumeError if
/// rows are then too long.
VolumeInfo of_all_components(const std::string& file, VolumeInfo info, std::uint64_t count,
                             const std::string& remedy = "crop the volume");

/// Returns a channel of a volume whose channels are adjacent samples. open: opens all channels, by
/// their description.
std::unique_ptr<VolumeReader> channel_of(
    const std::string& file, VolumeInfo info, std::optional<std::uint32_t> channel,
    const std::function<std::unique_ptr<VolumeReader>(VolumeInfo all)>& open);

/// Returns the values of a volume as floating point, with NaN for the fill value, because NaN is
/// outside every surface. fill: as stored.
std::unique_ptr<VolumeReader> without_fill(std::unique_ptr<VolumeReader> volume, double fill);

/// Opens the mask of a volume: samples of u8, 0 if the file's value is 0 or NaN, else 1. options:
/// of the volume, for its spacing, crop and shrink; a block of the mask has the value of most of
/// its voxels. volume: after these options. A mask whose axes have another order or direction is
/// turned. Unless its slices stay slices, all of the mask is in memory, a byte per voxel. Throws
/// VolumeError like open_volume(), and if the mask has other extents than the whole volume. Also
/// throws if a turned mask has another place. A mask that needs no turning may lie elsewhere.
std::unique_ptr<VolumeReader> open_mask(const std::filesystem::path& file,
                                        const VolumeOptions& options, const VolumeInfo& volume);

/// Returns the labels, with 0 where the mask is 0. labels: from whole_labels(). mask: from
/// open_mask().
std::unique_ptr<VolumeReader> masked(std::unique_ptr<VolumeReader> labels,
                                     std::unique_ptr<VolumeReader> mask);

/// Returns the label of a value: the whole number within 0.01. Returns nothing for other values,
/// and from 2^53 on, because double rounds such numbers.
std::optional<std::int64_t> nearest_label(double value);

/// Returns the volume with its values as samples: slope 1, intercept 0. Whole numbers of up to 64
/// bits stay exact. Other values become i64 by nearest_label(), and NaN becomes 0. After the last
/// slice, notes count rounded values and NaN. read_slice() throws VolumeError if a value has no
/// label. file: for errors.
std::unique_ptr<VolumeReader> whole_labels(const std::filesystem::path& file,
                                           std::unique_ptr<VolumeReader> volume);

/// Labels that form one surface: their values per layer. No values mean all labels except 0.
using LabelSet = std::map<std::uint32_t, std::vector<LabelValue>>;

/// The number of sets that fit the bits of a sample.
constexpr std::size_t max_label_sets = 64;

/// Returns unsigned samples: bit i is on if the voxel has a label of sets[i]. The type is the
/// smallest one with enough bits. layers: from whole_labels(), by their numbers in the sets, with
/// equal extents. Limit: at least one layer, 1 to max_label_sets sets.
std::unique_ptr<VolumeReader> label_bits(
    std::map<std::uint32_t, std::unique_ptr<VolumeReader>> layers,
    const std::vector<LabelSet>& sets);

}  // namespace discmc::command
