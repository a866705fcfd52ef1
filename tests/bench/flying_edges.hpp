// The mesh of a volume by VTK.
#pragma once

#include "meshes/mesh.hpp"
#include "volumes/volume.hpp"

namespace discmc::bench {

/// The triangles of FlyingEdges3D, closed half a voxel outside the volume. FaceMesh::lattice has
/// the middle of each vertex' edge. Limit: u8, u16 or i16 samples.
command::FaceMesh flying_edges(command::VolumeReader& volume, double level);

}  // namespace discmc::bench
