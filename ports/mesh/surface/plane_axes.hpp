// Two of the three coordinates for the planes of an incidence.
#ifndef DISCMC_MESH_SURFACE_PLANE_AXES_HPP
#define DISCMC_MESH_SURFACE_PLANE_AXES_HPP

#include <array>
#include <cstddef>
#include <cstdint>

#include <discmc/lattice.hpp>

namespace discmc::meshing {

/// Two coordinates of a plane, ordered so that counter-clockwise, seen from the tip of the normal,
/// stays counter-clockwise. The projection changes shapes, but neither order nor sides.
struct PlaneAxes {
  std::int32_t Vertex::*u;
  std::int32_t Vertex::*v;
  std::int32_t Vertex::*left_out;
};

namespace derive {
constexpr PlaneAxes plane_axes(Incidence incidence) {
  const Vertex normal = incidence_normal(incidence);
  if (normal.z > 0) return {&Vertex::x, &Vertex::y, &Vertex::z};
  if (normal.z < 0) return {&Vertex::y, &Vertex::x, &Vertex::z};
  if (normal.y > 0) return {&Vertex::z, &Vertex::x, &Vertex::y};
  if (normal.y < 0) return {&Vertex::x, &Vertex::z, &Vertex::y};
  if (normal.x > 0) return {&Vertex::y, &Vertex::z, &Vertex::x};
  return {&Vertex::z, &Vertex::y, &Vertex::x};
}
constexpr std::array<PlaneAxes, incidence_codes> all_plane_axes() {
  std::array<PlaneAxes, incidence_codes> table{};
  for (Incidence i = 0; i < incidence_codes; ++i) table[i] = plane_axes(i);
  return table;
}
}  // namespace derive

inline const PlaneAxes& plane_axes(Incidence incidence) {
  static constexpr std::array<PlaneAxes, incidence_codes> table = derive::all_plane_axes();
  return table[incidence];
}

}  // namespace discmc::meshing

#endif
