// A mesh with what a file holds beside it.
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

/// The length of 1 in the coordinates of a mesh.
enum class MeshUnit { millimetre, micrometre, metre, inch };

struct FileMesh : FaceMesh {
  FileMesh() = default;
  FileMesh(FaceMesh mesh) : FaceMesh(std::move(mesh)) {}

  std::optional<Srgb> colour;            ///< of all of it, where one was given
  std::string name;                      ///< in a file that holds several
  std::optional<std::int64_t> voxels;    ///< inside the surface, where they were counted
  Space space = Space::scanner;          ///< of the coordinates
  MeshUnit unit = MeshUnit::millimetre;  ///< of all lengths, once resize() has changed it
};

/// The coordinates of a mesh in a file.
struct MeshSize {
  MeshUnit unit = MeshUnit::millimetre;
  double scale = 1;  ///< times larger than the object; Limit: positive

  bool is_given() const { return unit != MeshUnit::millimetre || scale != 1; }
};

/// Turns millimetres into these. Call it last: what has a length in its name is then in this unit.
void resize(FileMesh& mesh, const MeshSize& size);

/// A symbol, the word for several, and the word of 3MF.
struct UnitNames {
  const char *symbol, *plural, *word_of_3mf;
};
const UnitNames& names_of(MeshUnit unit);

/// The faces of all, in their order, with their polygons and normals; a single mesh as it is.
/// Limit: all have normals, or none.
FileMesh joined(std::vector<FileMesh> parts);

/// The distance from one float to the next where a mesh is farthest from the origin. Units:
/// millimetres.
double float_step_mm(const FileMesh& mesh, const Point& origin = {});

/// Whether floats move no vertex by more than a thousandth of a voxel.
bool suits_floats(const FileMesh& mesh, const Point& origin = {});

/// How many different places the vertices have as floats. Limit: as FileMesh::vertices_mm.
std::size_t count_float_places(const FileMesh& mesh, const Point& origin = {});

}  // namespace discmc::command
