// The directions of links in the planes of an incidence.
#ifndef DISCMC_MESH_HOST_DIRECTION_TABLE_HPP
#define DISCMC_MESH_HOST_DIRECTION_TABLE_HPP

#include <discmc/lattice.hpp>

namespace discmc::host {

/// The results of direction_of().
struct DirectionTable {
  Direction by_link[incidence_codes][link_codes];
};
namespace derive {
constexpr DirectionTable direction_table() {
  DirectionTable table{};
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    for (Direction direction = 0; direction < direction_count(incidence); ++direction)
      table.by_link[incidence][link_of(incidence, direction)] = direction;
  return table;
}
}  // namespace derive
inline constexpr DirectionTable direction_table = derive::direction_table();

}  // namespace discmc::host

#endif
