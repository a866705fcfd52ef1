// The passes at a vertex: which chains go through it, from where to where.
//
// A ray is a boundary link that leaves the vertex between two different sectors. Through the
// sectors between two rays, a wedge, one chain passes: it comes in along one ray and goes out along
// the other, with the wedge on its left. Where all sectors are alike there is nothing to do.
#ifndef DISCMC_TRACE_PASSES_HPP
#define DISCMC_TRACE_PASSES_HPP

#include <discmc/trace/neighbourhood.hpp>
#include <discmc/trace/sector_table.hpp>

namespace discmc::trace {

/// One chain's way through a vertex. The two spokes of a wedge at a centroid are one link here, so
/// the link that goes out may have a corner on the way.
struct Pass {
  Incidence incidence;
  Link incoming;  ///< by which the chain comes to the vertex
  Link first;     ///< by which it goes on: to the next vertex, or to the centroid on the way there
  Link second;    ///< from the centroid on; equal to `first` without one, or without a corner there
  uint8_t in, out;        ///< queues of the links that come in and go out
  bool comes_from_ahead;  ///< the vertex before is visited later
  uint8_t flags;          ///< ahead, by_centroid

  static constexpr uint8_t ahead = 1, by_centroid = 2;
  bool goes_ahead() const { return (flags & ahead) != 0; }  ///< the vertex after is visited later
  bool has_centroid() const { return (flags & by_centroid) != 0; }
  bool turns() const { return incoming != first; }
  bool turns_at_centroid() const { return first != second; }
};

/// All passes at a vertex.
struct PassList {
  static constexpr int most = 8;

  uint32_t parts;  ///< what the vertex adds to the counts of cells: see CountParts
  Pass pass[most];
  uint8_t count;
};

/// Works out the passes at the vertex on an edge. absent: by quadrant, a bit: there is no cell, or
/// none that takes part.
template <bool has_absent_cells = true, bool has_counts = true>
void derive_passes(const EdgePlace& edge, uint32_t absent, PassList& passes);

/// An edge whose surroundings are at hand: for hosts, as EdgePlace.
struct EdgeLines {
  int axis;
  bool is_on;
  uint32_t around;

  bool lower_is_on() const { return is_on; }
  uint32_t lines() const { return around; }
};
void derive_passes(const EdgeLines& edge, uint32_t absent, PassList& passes);

}  // namespace discmc::trace

#endif
