// Meshes as STL, PLY, OBJ, GLB, 3MF and VTP files, polygons as lines of JSON, and measures as
// tables.
//
// All writers append to a stream that the caller opened (binary) and owns. They throw
// std::runtime_error when the stream fails; what was written before that is worthless.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "file_format.hpp"
#include "file_mesh.hpp"
#include "mesh_parts.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// What goes into one file.
using Meshes = std::vector<const FileMesh*>;

/// By the writer of the format, of those below that take a mesh; otherwise std::invalid_argument.
/// jobs: parts that are made at once, where the writer takes any. The file is the same.
void write_mesh(const FileMesh& mesh, Format format, std::ostream& out, unsigned jobs = 1);

/// The same of several in one file, each with its name and colour. Limit: a format that holds
/// several, or one mesh; otherwise std::invalid_argument.
void write_meshes(const Meshes& meshes, Format format, std::ostream& out);

/// Binary STL, coordinates as 32-bit floats, however coarse they are. Units: millimetres.
/// Limit: triangles only (Faces::triangles), otherwise std::invalid_argument.
void write_stl(const FileMesh& mesh, std::ostream& out, unsigned jobs = 1);
/// The same bytes, of a mesh that is not in memory. Limit: out can seek, and is empty.
MeshTotals write_stl(const MeshParts& parts, std::ostream& out);

/// PLY, binary little endian: coordinates as 32-bit floats, or as doubles where floats do not suit
/// (suits_floats()). Doubles make a file a third larger, and some readers support only floats. Also
/// normals, as floats, if the mesh has them, and at every vertex the colour, if it has one.
/// Units: millimetres. Limit: faces of max_face_corners, which a byte counts as every reader takes
/// it, and 2^31 - 1 vertices; otherwise std::invalid_argument.
void write_ply(const FileMesh& mesh, std::ostream& out, unsigned jobs = 1);
/// The same bytes, of a mesh that is not in memory. Limit: bounds() suit floats; out can seek, and
/// is empty.
MeshTotals write_ply(const MeshParts& parts, std::ostream& out);

/// Wavefront OBJ, exact decimal coordinates. Units: millimetres. Every vertex has its normal, where
/// the mesh has normals. material_file: the name of a file of write_mtl() beside it, or none.
void write_obj(const FileMesh& mesh, std::ostream& out, unsigned jobs = 1,
               const std::string& material_file = {});

/// The colour of a mesh, as OBJ has it in a file of its own.
void write_mtl(const Srgb& colour, std::ostream& out);

/// Binary glTF 2.0: coordinates as 32-bit floats in millimetres, seen from glb_origin(). A node
/// moves them back, scales them to metres, and turns z upwards, which is y in the format. Normals
/// where the mesh has them; a material each, in the colour of the mesh if it has one. Each mesh
/// that has faces has a node, with its name. Limit: triangles only, and 4 GiB; otherwise
/// std::invalid_argument.
void write_glb(const Meshes& meshes, std::ostream& out);

/// The origin of coordinates, where that suits the floats of all meshes; else a vertex of them.
Point glb_origin(const Meshes& meshes);

/// 3MF, an object a mesh that has faces: exact decimal coordinates, its name, and its colour if it
/// has one. Units: millimetres, and the file states it. Limit: triangles only, otherwise
/// std::invalid_argument.
void write_3mf(const Meshes& meshes, std::ostream& out);

/// VTK's XML PolyData; coordinates, normals and colour as those of PLY. Units: millimetres.
void write_vtp(const FileMesh& mesh, std::ostream& out);

/// The measures of meshes (measures_of()), a line per mesh in CSV or an object per mesh in
/// a JSON array. Their keys have the units. What a mesh that is not closed does not have is empty,
/// or null.
void write_csv(const Meshes& meshes, std::ostream& out);
void write_json(const Meshes& meshes, std::ostream& out);

/// One polygon a line, `{"normal":[0,0,1],"rings":[[[1,0,0],...],...]}`: the corners of its simple
/// rings, the outer one first. Units: half-steps.
void write_jsonl(const Surface& surface, std::ostream& out);

}  // namespace discmc::command
