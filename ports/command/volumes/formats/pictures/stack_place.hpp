// How large the voxels of a stack of pictures are, and where they lie.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_STACK_PLACE_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_STACK_PLACE_HPP

#include "stack.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Sets spacing and placement as the files describe them, or SkyScan's log beside them, with notes
/// of what they leave out.
void set_place_of(VolumeInfo& info, const Stack& stack, const VolumeOptions& options);

}  // namespace discmc::command

#endif
