// A volume whose axes are stored in another order than slices, rows and columns.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_TURNED_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_TURNED_VOLUME_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

#include "volumes/volume_offset.hpp"
#include "volumes/volume_reader.hpp"

namespace discmc::command {

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

}  // namespace discmc::command

#endif
