// The mesh that VTK makes of a volume.
#pragma once

#include "meshes/mesh.hpp"
#include "volumes/volume.hpp"

namespace discmc::bench {

/// The triangles of FlyingEdges3D, closed half a voxel outside the volume. Limit: the samples are
/// u8, u16 or i16. FaceMesh::lattice has the middle of the edge on which each vertex lies.
command::FaceMesh flying_edges(command::VolumeReader& volume, double level);

}  // namespace discmc::bench
