// Computes vertex normals of a merged mesh, with the library's integers.
#ifndef DISCMC_MESH_MESHES_VERTEX_NORMALS_HPP
#define DISCMC_MESH_MESHES_VERTEX_NORMALS_HPP

#include <cstdint>
#include <functional>

#include "mesh.hpp"
#include "samples/slice_reader.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {

/// Sets each normal to the mean over the polygons with the vertex as a corner or junction, weighted
/// by area. It is zero if they cancel. mesh: build_mesh() of the surface. Throws
/// std::invalid_argument if the spacing exceeds the range of a stream.
void set_polygon_normals(const Surface& surface, FaceMesh& mesh);

/// Sets each normal from the scan or the stream. A vertex without a normal there keeps its own.
void set_stream_normals(const Surface& surface, FaceMesh& mesh);

/// Sets each normal to the direction in which the samples fall. A vertex keeps its normal if the
/// samples are level, and on the walls around the volume. Reads the volume to its end. Memory: four
/// slices. mesh: from a volume of these extents; its spacing counts, not the volume's. Limit:
/// is_scanner_type() samples; extraction/narrowed_volume.hpp converts others. progress: called
/// after every slice with the number done. Throws like set_polygon_normals(), and VolumeError from
/// the reader.
void set_gradient_normals(SliceReader& volume, FaceMesh& mesh,
                          const std::function<void(std::uint32_t)>& progress = {});

}  // namespace discmc::meshing

#endif
