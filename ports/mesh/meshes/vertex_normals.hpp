// Normals at the vertices of a merged mesh, in the integers of the library.
#ifndef DISCMC_MESH_MESHES_VERTEX_NORMALS_HPP
#define DISCMC_MESH_MESHES_VERTEX_NORMALS_HPP

#include <cstdint>
#include <functional>

#include "mesh.hpp"
#include "samples/slice_reader.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

/// Gives every vertex the mean of the polygons that have it for a corner or a junction, each by its
/// area. Zero if they cancel each other out. mesh: build_mesh() of the surface. Throws
/// std::invalid_argument when the spacing is beyond what a stream can hold.
void set_polygon_normals(const Surface& surface, FaceMesh& mesh);

/// Gives every vertex its normal in the scan or the stream. A vertex without one keeps the normal
/// that it has.
void set_stream_normals(const Surface& surface, FaceMesh& mesh);

/// Gives every vertex the direction in which the samples fall there. If they are level, and on
/// the walls around the volume, the vertex keeps its normal. Reads the volume to its end, and
/// holds four slices of it.
/// mesh: from a volume of these extents; its spacing counts, not that of the volume.
/// Limit: is_scanner_type() samples; extraction/narrowed_volume.hpp makes them of others.
/// progress: called after every slice with how many are done.
/// Throws as set_polygon_normals() does, and VolumeError as the reader does.
void set_gradient_normals(SliceReader& volume, FaceMesh& mesh,
                          const std::function<void(std::uint32_t)>& progress = {});

}  // namespace discmc::meshing

#endif
