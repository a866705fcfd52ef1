// Writes meshes as STL, PLY, OBJ, GLB, 3MF and VTP, polygons as lines of JSON, and measures as
// tables.
//
// All writers append to a binary stream that the caller opened and owns. They throw
// std::runtime_error if the stream fails; its earlier content is then unusable.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "file_format.hpp"
#include "file_mesh.hpp"
#include "mesh_parts.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// The meshes of one file.
using Meshes = std::vector<const FileMesh*>;

/// Calls the writer of the format below; throws std::invalid_argument if that writer accepts no
/// mesh. jobs: parallel parts, if the writer supports them; the file does not depend on them.
void write_mesh(const FileMesh& mesh, Format format, std::ostream& out, unsigned jobs = 1);

/// Writes several meshes to one file, each with its name and colour. Limit: one mesh, or a format
/// that holds several; otherwise std::invalid_argument.
void write_meshes(const Meshes& meshes, Format format, std::ostream& out);

/// Writes binary STL with 32-bit floats, even if they round visibly. Units: millimetres. Limit:
/// triangles only (Faces::triangles), otherwise std::invalid_argument.
void write_stl(const FileMesh& mesh, std::ostream& out, unsigned jobs = 1);
/// Writes the same bytes without the whole mesh in memory. Limit: `out` can seek, and is empty.
MeshTotals write_stl(const MeshParts& parts, std::ostream& out);

/// Writes binary little-endian PLY. Coordinates are 32-bit floats, or doubles if floats do not suit
/// (suits_floats()). Doubles make the file a third larger, and some readers support only floats.
/// Normals are floats, if the mesh has them; every vertex has the mesh's colour, if it has one.
/// Units: millimetres. Limit: max_face_corners corners per face, which every reader supports as a
/// byte, and 2^31 - 1 vertices; otherwise std::invalid_argument.
void write_ply(const FileMesh& mesh, std::ostream& out, unsigned jobs = 1);
/// Writes the same bytes without the whole mesh in memory. Limit: bounds() suit floats; `out` can
/// seek, and is empty.
MeshTotals write_ply(const MeshParts& parts, std::ostream& out);

/// Writes Wavefront OBJ with exact decimal coordinates, and normals if the mesh has them. Units:
/// millimetres. material_file: the name of the write_mtl() file beside it, or empty.
void write_obj(const FileMesh& mesh, std::ostream& out, unsigned jobs = 1,
               const std::string& material_file = {});

/// Writes the colour of a mesh to the separate file that OBJ requires.
void write_mtl(const Srgb& colour, std::ostream& out);

/// Writes binary glTF 2.0. Coordinates are 32-bit floats in millimetres, relative to glb_origin().
/// A node moves them back, scales them to metres, and turns z upwards to y upwards. Normals are
/// written if a mesh has them. Each mesh with faces has a named node and a material, in its colour
/// if it has one. Limit: triangles only, and 4 GiB; otherwise std::invalid_argument.
void write_glb(const Meshes& meshes, std::ostream& out);

/// Returns zero if that suits the floats of all meshes; otherwise one of their vertices.
Point glb_origin(const Meshes& meshes);

/// Writes 3MF with exact decimal coordinates, one object per mesh that has faces, with its name and
/// its colour. Units: millimetres, as declared in the file. Limit: triangles only, otherwise
/// std::invalid_argument.
void write_3mf(const Meshes& meshes, std::ostream& out);

/// Writes XML PolyData of VTK; coordinates, normals and colour as in PLY. Units: millimetres.
void write_vtp(const FileMesh& mesh, std::ostream& out);

/// Writes the measures of meshes (measures_of()): a CSV line or a JSON object per mesh. The keys
/// include the units. A measure that a mesh lacks because it is open is empty or null.
void write_csv(const Meshes& meshes, std::ostream& out);
void write_json(const Meshes& meshes, std::ostream& out);

/// Writes one polygon per line, `{"normal":[0,0,1],"rings":[[[1,0,0],...],...]}`: the corners of
/// its simple rings, the outer ring first. Units: half-steps.
void write_jsonl(const Surface& surface, std::ostream& out);

}  // namespace discmc::command
