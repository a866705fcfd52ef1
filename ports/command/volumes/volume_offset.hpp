// Whether the voxels of two volumes lie in the same places.
#ifndef DISCMC_COMMAND_VOLUMES_VOLUME_OFFSET_HPP
#define DISCMC_COMMAND_VOLUMES_VOLUME_OFFSET_HPP

#include "volume.hpp"

namespace discmc::command {

/// How far voxels of the same number lie apart at most, as far as the volumes tell; 0 where that is
/// a tenth of a voxel or less. Where one of them does not know the patient's space their spacings
/// alone are compared. Units: millimetres. Limit: the same extents.
double offset_mm(const VolumeInfo& a, const VolumeInfo& b);

}  // namespace discmc::command

#endif
