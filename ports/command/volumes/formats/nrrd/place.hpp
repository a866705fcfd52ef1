// Where the volume of an NRRD file lies.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_PLACE_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_NRRD_PLACE_HPP

#include "volumes/declared_place.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {

/// As the header declares it: by directions, spacings, bounds of axes or thicknesses. info: with
/// the extents; gets the notes.
DeclaredPlace nrrd_place(VolumeInfo& info, const HeaderFields& fields);

}  // namespace discmc::command

#endif
