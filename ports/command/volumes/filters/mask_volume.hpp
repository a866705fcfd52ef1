// Volumes that select voxels of another volume.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_MASK_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_MASK_VOLUME_HPP

#include <filesystem>
#include <memory>

#include "volumes/volume.hpp"

namespace discmc::command {

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

}  // namespace discmc::command

#endif
