// A mesh moved to where its volume lies.
#ifndef DISCMC_COMMAND_MESHES_PLACING_HPP
#define DISCMC_COMMAND_MESHES_PLACING_HPP

#include "mesh.hpp"
#include "volumes/volume_placement.hpp"

namespace discmc::command {

/// Moves a mesh of build_mesh(), once, from where its spacing has it: vertices, normals (as planes
/// go, so also by oblique axes), and the order of corners where the placement mirrors. A vertex
/// (x, y, z), in half-steps, then lies at origin + (x axes[0] + y axes[1] + z axes[2]) / 2.
/// Limit: is_usable(placement).
void place(Mesh& mesh, const VolumePlacement& placement);

/// The coordinates of a mesh in a file.
struct MeshSize {
  MeshUnit unit = MeshUnit::millimetre;
  double scale = 1;  ///< times larger than the object; Limit: positive

  bool is_given() const { return unit != MeshUnit::millimetre || scale != 1; }
};

/// Turns millimetres into these. Call it last: what has a length in its name is then in this unit.
void resize(Mesh& mesh, const MeshSize& size);

/// "mm", "um", "m" or "inch".
const char* symbol(MeshUnit unit);

}  // namespace discmc::command

#endif
