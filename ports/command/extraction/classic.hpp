// Classic Marching Cubes: what the merged polygons are to be compared with.
#pragma once

#include "extraction.hpp"
#include "meshes/mesh.hpp"
#include "meshing.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Reads the volume to its end and makes triangles of the same topology as extract(). Every loop of
/// a cell is a fan over its edge crossings. Crossings are interpolated between the two samples, at
/// half a stored unit below the threshold. Next to the halo of a closed border they are in the
/// middle. Each triangle is a polygon of its own. options.memory has no meaning here. Throws
/// VolumeError as the reader does.
FaceMesh classic_mesh(VolumeReader& volume, const ExtractionOptions& options);

}  // namespace discmc::command
