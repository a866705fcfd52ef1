// A plane of the half-step lattice by two of the three coordinates.
#ifndef DISCMC_MESH_MESHES_LATTICE_PLANE_HPP
#define DISCMC_MESH_MESHES_LATTICE_PLANE_HPP

#include <cstdint>

#include <discmc/lattice.hpp>

#include "delaunay.hpp"
#include "surface/plane_axes.hpp"

namespace discmc::meshing {

/// The coordinates of PlaneAxes, from an origin on.
class LatticePlane {
 public:
  /// origin: any vertex of the plane; has the coordinates 0 and 0.
  LatticePlane(const Vertex& origin, Incidence incidence)
      : axes_(plane_axes(incidence)), origin_(origin), incidence_(incidence) {}

  /// Limit: vertices of the plane.
  PlanePoint at(const Vertex& vertex) const {
    return {std::int64_t{vertex.*axes_.u} - origin_.*axes_.u,
            std::int64_t{vertex.*axes_.v} - origin_.*axes_.v};
  }

  /// The vertex that has these coordinates.
  Vertex vertex(const PlanePoint& point) const {
    const Vertex normal = incidence_normal(incidence_);
    const std::int64_t along = normal.*axes_.u * point.u + normal.*axes_.v * point.v;
    Vertex vertex = origin_;
    vertex.*axes_.u += static_cast<std::int32_t>(point.u);
    vertex.*axes_.v += static_cast<std::int32_t>(point.v);
    vertex.*axes_.left_out -= static_cast<std::int32_t>(normal.*axes_.left_out * along);
    return vertex;
  }

 private:
  PlaneAxes axes_;
  Vertex origin_;
  Incidence incidence_;
};

}  // namespace discmc::meshing

#endif
