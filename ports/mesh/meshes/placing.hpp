// Moves a mesh to the placement of its volume.
#ifndef DISCMC_MESH_MESHES_PLACING_HPP
#define DISCMC_MESH_MESHES_PLACING_HPP

#include "mesh.hpp"
#include "samples/volume_placement.hpp"

namespace discmc::meshing {

/// Maps millimetres along the axes of a volume to its placement. A vertex (x, y, z) of the lattice,
/// in half-steps, reaches origin + (x axes[0] + y axes[1] + z axes[2]) / 2.
class Placing {
 public:
  /// Limit: is_usable(placement).
  Placing(const Point& spacing_mm, const VolumePlacement& placement);

  Point vertex(const Point& at) const;
  /// Returns a unit vector: normals are transformed as planes, even for oblique axes.
  Point normal(const Point& at) const;
  /// Whether the corners of faces must be reversed.
  bool mirrors() const { return mirrors_; }

 private:
  Axes turn_, turn_planes_;
  Point origin_mm_;
  bool mirrors_;
};

/// Moves a mesh of build_mesh() to the placement; call it once. Limit: is_usable(placement).
void place(FaceMesh& mesh, const VolumePlacement& placement);

}  // namespace discmc::meshing

#endif
