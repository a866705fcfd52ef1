// How chains turn in the planes of an incidence, by links.
#ifndef DISCMC_MESH_HOST_PLANES_HPP
#define DISCMC_MESH_HOST_PLANES_HPP

#include <discmc/lattice.hpp>

namespace discmc::host {

struct Planes {
  Direction direction[link_codes];  ///< as direction_of()
  uint8_t directions;               ///< direction_count()
};
struct PlaneTable {
  Planes of[incidence_codes];
};
namespace derive {
constexpr PlaneTable plane_table() {
  PlaneTable table{};
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    Planes& planes = table.of[incidence];
    planes.directions = direction_count(incidence);
    for (Direction direction = 0; direction < direction_count(incidence); ++direction)
      planes.direction[link_of(incidence, direction)] = direction;
  }
  return table;
}
}  // namespace derive
inline constexpr PlaneTable plane_table = derive::plane_table();

}  // namespace discmc::host

#endif
