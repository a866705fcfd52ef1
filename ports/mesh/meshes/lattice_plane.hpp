// Projects a plane of the half-step lattice to two of the three coordinates.
#ifndef DISCMC_MESH_MESHES_LATTICE_PLANE_HPP
#define DISCMC_MESH_MESHES_LATTICE_PLANE_HPP

#include <cstdint>

#include <discmc/lattice.hpp>

#include "delaunay.hpp"
#include "surface/plane_axes.hpp"

namespace discmc::meshing {

/// Coordinates by PlaneAxes, relative to an origin.
class LatticePlane {
 public:
  /// origin: any vertex of the plane; its projection is (0, 0).
  LatticePlane(const Vertex& origin, Incidence incidence)
      : axes_(plane_axes(incidence)), origin_(origin), incidence_(incidence) {}

  /// Projects a vertex. Limit: vertices of the plane.
  PlanePoint at(const Vertex& vertex) const {
    return {std::int64_t{vertex.*axes_.u} - origin_.*axes_.u,
            std::int64_t{vertex.*axes_.v} - origin_.*axes_.v};
  }

  /// Returns the vertex of a projection.
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
