// Extracts the surfaces of a segmentation's labels, without the steps of voxels.
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

/// Extracts labels as extract_labels() does, each smoothed like SmoothedVolume. Labels that meet
/// share their surface, also where three meet, and keep_volumes() keeps the volume of each body.
/// The mesh of a label does not depend on the choice of other labels. progress: called with the
/// number of labels done, and of all. The progress function of the options is called before, after
/// every slice read. tolerance: as VolumeKeeping. Limit: no majority filter. Cost: memory of the
/// volume, of the box of one label per job, and of the meshes of all labels. All labels are
/// smoothed, chosen or not.
std::vector<SmoothedLabel> smoothed_labels(
    SliceReader& volume, const LabelOptions& options, double deviation_mm, double tolerance,
    const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace discmc::meshing

#endif
