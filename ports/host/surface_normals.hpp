// Normals of vertices from the faces around them, where there are no samples at hand.
#ifndef DISCMC_HOST_SURFACE_NORMALS_HPP
#define DISCMC_HOST_SURFACE_NORMALS_HPP

#include <vector>

#include "mesh.hpp"

namespace discmc::host {

/// Unit normals, one a vertex: the mean of the polygons that meet there, each by its whole area, so
/// that large walls stay plain and the narrow facets between them are rounded. Vertices at equal
/// positions are one. Zero where no face is, or where those that are cancel each other out.
std::vector<Point> surface_normals(const Mesh& mesh);

}  // namespace discmc::host

#endif
