// A plane of the half-step lattice by two of the three coordinates.
#ifndef DISCMC_MESH_MESHES_LATTICE_PLANE_HPP
#define DISCMC_MESH_MESHES_LATTICE_PLANE_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <discmc/lattice.hpp>

#include "delaunay.hpp"

namespace discmc::meshing {

/// Two coordinates of a plane, chosen and ordered so that counter-clockwise seen from the tip of
/// the normal stays so. Leaving a coordinate out changes shapes but neither order nor sides.
class LatticePlane {
 public:
  /// origin: any vertex of the plane; has the coordinates 0 and 0.
  LatticePlane(const Vertex& origin, Incidence incidence)
      : origin_(coordinates(origin)), normal_(coordinates(incidence_normal(incidence))) {
    left_out_ = normal_[2] != 0 ? 2 : normal_[1] != 0 ? 1 : 0;
    u_ = (left_out_ + 1) % 3;
    v_ = (left_out_ + 2) % 3;
    if (normal_[left_out_] < 0) std::swap(u_, v_);
  }

  /// Limit: vertices of the plane.
  PlanePoint at(const Vertex& vertex) const {
    return {std::int64_t{vertex.*axes[u_]} - origin_[u_],
            std::int64_t{vertex.*axes[v_]} - origin_[v_]};
  }

  /// The vertex that has these coordinates.
  Vertex vertex(const PlanePoint& point) const {
    Coordinates at = origin_;
    at[u_] += point.u;
    at[v_] += point.v;
    at[left_out_] -= normal_[left_out_] * (normal_[u_] * point.u + normal_[v_] * point.v);
    return {static_cast<std::int32_t>(at[0]), static_cast<std::int32_t>(at[1]),
            static_cast<std::int32_t>(at[2])};
  }

 private:
  using Coordinates = std::array<std::int64_t, 3>;
  static constexpr std::int32_t Vertex::*axes[] = {&Vertex::x, &Vertex::y, &Vertex::z};
  static Coordinates coordinates(const Vertex& vertex) { return {vertex.x, vertex.y, vertex.z}; }

  Coordinates origin_, normal_;
  std::size_t u_, v_, left_out_;
};

}  // namespace discmc::meshing

#endif
