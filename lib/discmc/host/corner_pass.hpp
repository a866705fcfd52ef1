// A pass as hosts take it: written so that all passes are taken by the same instructions.
#ifndef DISCMC_HOST_CORNER_PASS_HPP
#define DISCMC_HOST_CORNER_PASS_HPP

#include <discmc/host/corner.hpp>
#include <discmc/trace/passes.hpp>

namespace discmc::trace {

/// Where ends come from and go to: two ports for each queue, an even one where an end is taken out
/// and an odd one where an end is put in.
using Port = uint16_t;

constexpr Port exit_of(uint32_t queue) {
  return static_cast<Port>(2 * queue);
}
constexpr Port entry_of(uint32_t queue) {
  return static_cast<Port>(2 * queue + 1);
}
constexpr bool is_entry(Port port) {
  return port % 2 != 0;
}

/// Where a chain has a corner at the vertex and one at the centroid next to it an end goes from one
/// to the other by a queue of its own.
constexpr uint32_t inner_queue = queue_count;
constexpr uint32_t ports = 2 * (queue_count + 1);

/// At most one corner, and what becomes of the ends on both sides of it.
struct CornerPass {
  uint64_t corner;      ///< what makes its CornerCode of the CornerCode::position() of the voxel at
                        ///< the lower end of the edge
  Port in;              ///< of the link that comes
  Port out;             ///< of the link that goes
  int16_t if_straight;  ///< all bits where there is no corner: the end goes from port to port
  uint16_t joins;       ///< 1 where two ends are taken out, else 0

  static constexpr uint32_t max_of_pass = 2;
};

/// Writes a pass at a vertex on an edge along an axis down as at most max_of_pass corner passes,
/// and returns how many there are.
uint32_t corner_passes(const Pass& pass, int axis, CornerPass* passes);

}  // namespace discmc::trace

#endif
