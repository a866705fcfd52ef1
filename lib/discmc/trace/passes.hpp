// The passes at a vertex: the chains through it, with their links.
//
// A ray is a boundary link that leaves the vertex between two different sectors. The sectors
// between two rays are a wedge. One chain passes each wedge: it arrives along one ray and leaves
// along the other, with the wedge on its left. If all sectors are equal, no chain passes.
#ifndef DISCMC_TRACE_PASSES_HPP
#define DISCMC_TRACE_PASSES_HPP

#include <discmc/trace/neighbourhood.hpp>
#include <discmc/trace/sector_table.hpp>

namespace discmc::detail::trace {

/// The path of one chain through a vertex. The two spokes of a wedge at a centroid are one link
/// here, so the outgoing link may have a corner.
struct Pass {
  Incidence incidence;
  Link incoming;          ///< by which the chain arrives
  Link outgoing;          ///< to the next vertex, or to a centroid before it
  Link after_centroid;    ///< equal to `outgoing` without a centroid or a corner there
  uint8_t in_queue;       ///< of the incoming link
  uint8_t out_queue;      ///< of the outgoing link
  bool comes_from_ahead;  ///< whether the previous vertex is visited later
  uint8_t flags;          ///< ahead, by_centroid

  static constexpr uint8_t ahead = 1, by_centroid = 2;
  /// Whether the next vertex is visited later.
  bool goes_ahead() const { return (flags & ahead) != 0; }
  bool has_centroid() const { return (flags & by_centroid) != 0; }
  bool turns() const { return incoming != outgoing; }
  bool turns_at_centroid() const { return outgoing != after_centroid; }
};

/// All passes at a vertex.
struct PassList {
  static constexpr int max_passes = 8;

  uint32_t parts;  ///< the vertex's parts of the cell counts: see CountParts
  Pass pass[max_passes];
  uint8_t count;
};

/// Computes the passes at the vertex on an edge. absent: a bit per quadrant without a participating
/// cell. is_lean: none is absent, and nothing is counted.
template <bool is_lean = false>
void derive_passes(const RowEdge& edge, uint32_t absent, PassList& passes);

/// An edge with known surroundings: for hosts, instead of RowEdge.
struct EdgeLines {
  int axis;
  bool is_on;
  uint32_t around;

  bool lower_is_on() const { return is_on; }
  uint32_t lines() const { return around; }
};
void derive_passes(const EdgeLines& edge, uint32_t absent, PassList& passes);

}  // namespace discmc::detail::trace

#endif
