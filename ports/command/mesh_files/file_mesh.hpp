// A mesh with the further content of its file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <discmc/placement.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "meshes/mesh.hpp"
#include "meshing.hpp"
#include "pictures/srgb.hpp"

namespace discmc::command {

/// The unit of a mesh's coordinates.
enum class MeshUnit { millimetre, micrometre, metre, inch };

struct FileMesh : FaceMesh {
  FileMesh() = default;
  FileMesh(FaceMesh mesh) : FaceMesh(std::move(mesh)) {}

  std::optional<Srgb> colour;            ///< of the whole mesh, if set
  std::string name;                      ///< if the file holds several meshes
  std::optional<std::int64_t> voxels;    ///< inside the surface, if counted
  Space space = Space::scanner;          ///< of the coordinates
  MeshUnit unit = MeshUnit::millimetre;  ///< of all lengths, once resize() has changed it
};

/// The coordinates of a mesh in a file.
struct MeshSize {
  MeshUnit unit = MeshUnit::millimetre;
  double scale = 1;  ///< times larger than the object; Limit: positive

  bool is_given() const { return unit != MeshUnit::millimetre || scale != 1; }
};

/// Converts millimetres to the requested unit and scale. Call it last: afterwards members named
/// `_mm` are in this unit.
void resize(FileMesh& mesh, const MeshSize& size);

/// The symbol of a unit, its plural, and its name in 3MF.
struct UnitNames {
  const char *symbol, *plural, *word_of_3mf;
};
const UnitNames& names_of(MeshUnit unit);

/// Joins all faces in order, with their polygons and normals; returns a single mesh unchanged.
/// Limit: all parts have normals, or none.
FileMesh joined(std::vector<FileMesh> parts);

/// Returns the distance between neighbouring floats at the vertex farthest from the origin. Units:
/// millimetres.
double float_step_mm(const FileMesh& mesh, const Point& origin = {});

/// Whether rounding to floats moves no vertex by more than a thousandth of a voxel.
bool suits_floats(const FileMesh& mesh, const Point& origin = {});

/// Counts the distinct positions of the vertices as floats. Limit: as FileMesh::vertices_mm.
std::size_t count_float_places(const FileMesh& mesh, const Point& origin = {});

}  // namespace discmc::command
