// The surfaces of the labels of a segmentation, each without the steps of its voxels.
#ifndef DISCMC_MESH_SMOOTHING_SMOOTHED_LABELS_HPP
#define DISCMC_MESH_SMOOTHING_SMOOTHED_LABELS_HPP

#include <cstdint>
#include <functional>
#include <vector>

#include "extraction/crossings.hpp"
#include "extraction/labels.hpp"

namespace discmc::meshing {

/// The smoothed surface of the voxels of one value.
struct SmoothedLabel {
  LabelledSurface surface;
  CrossingFinder crossings;  ///< of the surface
};

/// As extract_labels(), each label smoothed as SmoothedVolume does it. If two labels meet, and
/// no third is near, their surfaces are the same. Along the lines where three meet, narrow gaps and
/// overlaps are left. progress: called with how many labels are done, and with their number; that
/// of the options is called before, after every slice that is read.
/// Limit: takes no majority.
/// Cost: memory of the volume, and of the box of a label; time of the boxes.
std::vector<SmoothedLabel> smoothed_labels(
    SliceReader& volume, const LabelOptions& options, double deviation_mm,
    const std::function<void(std::size_t done, std::size_t all)>& progress);

}  // namespace discmc::meshing

#endif
