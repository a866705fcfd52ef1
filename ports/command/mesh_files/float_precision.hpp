// What 32-bit floats keep of coordinates: less, the farther from the origin they are.
#ifndef DISCMC_COMMAND_MESH_FILES_FLOAT_PRECISION_HPP
#define DISCMC_COMMAND_MESH_FILES_FLOAT_PRECISION_HPP

#include <cstddef>

#include "file_mesh.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// The distance from one float to the next where a mesh is farthest from the origin. Units:
/// millimetres.
double float_step_mm(const FileMesh& mesh, const Point& origin = {});

/// Whether floats move no vertex by more than a thousandth of a voxel.
bool suits_floats(const FileMesh& mesh, const Point& origin = {});

/// How many different places the vertices have as floats. Limit: as FileMesh::vertices_mm.
std::size_t count_float_places(const FileMesh& mesh, const Point& origin = {});

}  // namespace discmc::command

#endif
