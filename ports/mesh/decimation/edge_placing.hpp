// Computes the position and the cost of the vertex that replaces an edge.
#ifndef DISCMC_MESH_DECIMATION_EDGE_PLACING_HPP
#define DISCMC_MESH_DECIMATION_EDGE_PLACING_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "collapsing_mesh.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// Minimises the squared distances from the planes of the triangles around both ends of an edge,
/// weighted by area (M. Garland and P. Heckbert, 1997). The enclosed volume stays constant (P.
/// Lindstrom and G. Turk, 1998). Only current triangles count, never earlier ones.
class EdgePlacing {
 public:
  explicit EdgePlacing(const CollapsingMesh& mesh);

  struct PlacedVertex {
    Point at;
    double cost;
  };
  /// Returns nothing if only a position far from the edge would keep the volume. An edge with one
  /// end on a border collapses to that end. A border edge collapses to one of its ends, so a plane
  /// border stays plane.
  std::optional<PlacedVertex> placed(std::uint32_t a, std::uint32_t b) const;

  /// Updates a vertex after its triangles have changed.
  void update(std::uint32_t vertex);

 private:
  using Symmetric = std::array<double, 6>;  // xx, xy, xz, yy, yz, zz

  // Sums over the triangles around a vertex, which is a point of their planes.
  struct Sums {
    Symmetric quadric{};
    Point doubled_area{};
  };

  void add_border(std::uint32_t vertex, Sums& sums) const;

  const CollapsingMesh& mesh_;
  std::vector<Sums> sums_;
};

}  // namespace discmc::meshing

#endif
