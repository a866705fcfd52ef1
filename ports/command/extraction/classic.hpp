// Classic Marching Cubes, for comparison with the merged polygons.
#pragma once

#include "extraction.hpp"
#include "meshes/mesh.hpp"
#include "meshing.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Reads the volume to its end and makes triangles of the same topology as extract(). Each loop of
/// a cell is a fan over its edge crossings, and each triangle is a polygon. Crossings are
/// interpolated between two samples, half a stored unit below the threshold. Next to the halo of a
/// closed border, crossings are halfway. options.memory is ignored. Throws VolumeError from the
/// reader.
FaceMesh classic_mesh(VolumeReader& volume, const ExtractionOptions& options);

}  // namespace discmc::command
