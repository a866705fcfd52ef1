// Which of the labels that are asked for a voxel has, as bits.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_LABEL_BITS_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_LABEL_BITS_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "meshing.hpp"
#include "samples/label_value.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

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

#endif
