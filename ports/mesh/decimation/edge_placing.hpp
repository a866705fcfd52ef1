// The position of the vertex that replaces an edge, and its cost.
#ifndef DISCMC_MESH_DECIMATION_EDGE_PLACING_HPP
#define DISCMC_MESH_DECIMATION_EDGE_PLACING_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "collapsing_mesh.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// The squared distances of a vertex from the planes of the triangles around both ends of an edge,
/// weighted by area (M. Garland and P. Heckbert, 1997), are least where the vertex is placed, among
/// all places that keep the enclosed volume (P. Lindstrom and G. Turk, 1998). The triangles are
/// the current ones; nothing is kept of earlier ones.
class EdgePlacing {
 public:
  explicit EdgePlacing(const CollapsingMesh& mesh);

  struct Place {
    Point at;
    double cost;
  };
  /// Nothing if the volume would only be kept far from the edge. An edge with one end on a border
  /// goes to that end, and an edge of a border to one of its ends. So a plane border stays plane.
  std::optional<Place> place(std::uint32_t a, std::uint32_t b) const;

  /// Call it after the triangles around the vertex have changed.
  void update(std::uint32_t vertex);

 private:
  using Symmetric = std::array<double, 6>;  // xx, xy, xz, yy, yz, zz

  // The triangles around a vertex, which is a point of their planes.
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
