// A volume of fewer, larger voxels, one for a block each.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_SHRUNK_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_SHRUNK_VOLUME_HPP

#include <cstdint>
#include <filesystem>
#include <memory>

#include "volumes/volume.hpp"

namespace discmc::command {

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

}  // namespace discmc::command

#endif
