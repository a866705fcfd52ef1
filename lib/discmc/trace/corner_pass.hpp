// A pass as hosts take it: written so that all passes are taken by the same instructions.
#ifndef DISCMC_TRACE_CORNER_PASS_HPP
#define DISCMC_TRACE_CORNER_PASS_HPP

#include <discmc/trace/corner.hpp>
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
  Port in;         ///< of the link that comes
  Port out;        ///< of the link that goes
  uint16_t sides;  ///< of the corner: see CornerCode
  uint8_t place;   ///< of the corner: see CornerPlaces
  uint8_t kind;    ///< one of these

  /// There is no corner: the end goes from one port to the other.
  static constexpr uint8_t straight = 1;
  /// A corner where two ends are taken out.
  static constexpr uint8_t join = 2;
  static constexpr uint8_t corner = 0;

  static constexpr uint32_t most_of_pass = 2;
};

/// Where a corner lies from the voxel at the lower end of an edge, by the axis and by the link to
/// the centroid where it is, or on_vertex: see CornerCode::vector().
struct CornerPlaces {
  static constexpr Link on_vertex = link_codes;
  static constexpr uint8_t index(int axis, Link link) {
    return static_cast<uint8_t>(axis * (link_codes + 1) + link);
  }
  uint64_t of[3 * (link_codes + 1)];
};
namespace derive {
constexpr CornerPlaces corner_places() {
  CornerPlaces places{};
  for (int axis = 0; axis < 3; ++axis) {
    const Vertex vertex{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
    for (Link link = 0; link < link_codes; ++link)
      places.of[CornerPlaces::index(axis, link)] = CornerCode::vector(vertex + link_vector(link));
    places.of[CornerPlaces::index(axis, CornerPlaces::on_vertex)] = CornerCode::vector(vertex);
  }
  return places;
}
}  // namespace derive
inline constexpr CornerPlaces corner_places = derive::corner_places();

/// Writes a pass at a vertex on an edge along an axis down as at most most_of_pass corner passes,
/// and returns how many there are.
uint32_t corner_passes(const Pass& pass, int axis, CornerPass* passes);

}  // namespace discmc::trace

#endif
