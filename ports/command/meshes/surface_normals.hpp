// Normals of vertices from the faces around them, where there are no samples at hand.
#ifndef DISCMC_COMMAND_MESHES_SURFACE_NORMALS_HPP
#define DISCMC_COMMAND_MESHES_SURFACE_NORMALS_HPP

#include <vector>

#include "mesh.hpp"

namespace discmc::command {

/// Unit normals, one a vertex: the mean of the triangles that meet there, each by its angle there.
/// So it makes no difference how a flat part of the surface is cut into triangles. Vertices at
/// equal positions are one. Zero where no face is, or where those that are cancel each other out.
/// Limit: triangles.
std::vector<Point> surface_normals(const Mesh& mesh);

}  // namespace discmc::command

#endif
