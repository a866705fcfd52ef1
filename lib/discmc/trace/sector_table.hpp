// The sectors around a vertex, derived from the face rule of cell.hpp.
//
// A vertex lies on a crossing edge, which four cells share. Seen along the edge's axis they are the
// quadrants 0 to 3, counter-clockwise; u and v are the two axes that follow in cyclic order:
//
//             v
//       3     2     1
//          q1 | q0
//       4 --- o --- 0   u
//          q2 | q3
//       5     6     7
//
// Nine lines of voxels run along the axis: the middle line, which crosses, and the lines 0 to 7 of
// the circle. A line has two bits, for the lower and the upper end of the edge. Quadrant q has the
// lines 2q, 2q + 1 and 2q + 2 of the circle.
//
// In each cell one loop passes the vertex, from the face at line 2q to the face at line 2q + 2. Its
// facets there have one incidence, or two with a spoke to the centroid between them. So each
// quadrant has two sectors. All incidences around a vertex have the same component along the axis.
// The rest is one of nine headings: 0 to 7 as the lines of the circle, or 8 for none. Between two
// sectors lies a ray: ray 2q on a face, ray 2q + 1 on the spoke of quadrant q.
#ifndef DISCMC_TRACE_SECTOR_TABLE_HPP
#define DISCMC_TRACE_SECTOR_TABLE_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/geometry/cell.hpp>

namespace discmc::detail::trace {

/// The edges of a cell, numbered in the order in which a sweep visits them.
using CellEdge = uint8_t;

constexpr int cell_edges = 12;
constexpr int quadrants = 4;
constexpr uint8_t no_heading = 8;

/// A cell at one of its vertices, turned to quadrant 0: the headings of its sectors, and the chain
/// ends along the spoke between them.
struct CellAtVertex {
  /// Bits 0 to 3: the first sector of the quadrant; bits 4 to 7: the second. If they differ, the
  /// spoke is boundary.
  uint8_t headings;
  /// Bits 0 to 3: the edge reached by the chain that leaves along the spoke, by the centroid. Bits
  /// 4 to 7: the edge of the chain that arrives along the spoke. Both for the axis x.
  uint8_t edges;
  uint8_t part;  ///< an index into SectorTable::part
};

/// Ends wait in queues, one per kind of link and direction of a chain along the link. Links of one
/// kind end in the order in which they began. There are 144 kinds:
///
///   36    links on faces, by the edge that they begin on and by their vector
///   108   links by the centroid of a cell, by the edges that they join: 42 pairs of edges both
///         ways, 24 pairs one way only
///
/// Links of the first queues stay within a slice; links from `first_rising_queue` on reach the next
/// slice. The two queues of a link that is used in both directions differ in their lowest bit.
constexpr int queue_count = 144;
constexpr int first_rising_queue = 76;

/// A link along a ray, from one vertex to another.
class Way {
 public:
  constexpr Way() = default;
  /// queue: of the chains that leave the vertex.
  constexpr Way(Link link, uint8_t queue, bool is_ahead)
      : queue_(queue), link_(static_cast<uint8_t>(link | (is_ahead ? ahead : 0))) {}

  /// For a link by a centroid: the second part, from the centroid to the other vertex.
  constexpr Link link() const { return link_ & (ahead - 1); }
  /// Whether the other vertex is visited later.
  constexpr bool is_ahead() const { return link_ >= ahead; }
  /// Return the queues of the chains that leave along the ray and that arrive along it. If there
  /// are no such chains, the result is a queue of other chains.
  constexpr uint8_t queue_out() const { return queue_; }
  constexpr uint8_t queue_in() const { return queue_ ^ 1; }

 private:
  static constexpr uint8_t ahead = 0x80;
  uint8_t queue_ = 0;
  uint8_t link_ = 0;
};

/// The ways of a quadrant: along its spoke, by edge (see CellAtVertex), and on its face straight,
/// down or up the axis.
constexpr int ways = cell_edges + 3;
constexpr uint8_t straight_way = cell_edges, downward_way = cell_edges + 1,
                  upward_way = cell_edges + 2;

/// Values that depend on the axis of an edge.
struct AxisTable {
  Way way[quadrants][ways];
  Link inwards[quadrants];              ///< from the vertex to the centroid
  Incidence incidence[no_heading + 1];  ///< [heading], if the lower end is off
  uint8_t to_upper;                     ///< added to the incidence if the lower end is on
};

/// Lines of voxels, mirrored along the axis: the two ends of each line are exchanged.
DISCMC_ALWAYS_INLINE constexpr uint32_t mirrored(uint32_t lines) {
  return (lines & 0x5555) << 1 | (lines >> 1 & 0x5555);
}

/// The counts of cells. Every vertex adds a part for each of its four cells. The parts of all
/// vertices of a cell add up to one cell, its facets, and its classic Marching Cubes triangles.
struct CountParts {
  // The parts of a whole, and the bits of a word for their sum over four cells.
  static constexpr uint32_t cell = 2520, facet = 12, triangle = 420;
  static constexpr uint32_t facet_shift = 12, triangle_shift = 18;
};

/// A cell and its mirror image have the same headings and parts.
struct SectorTable {
  uint16_t cell[64];    ///< [bits of the quadrant's three lines, mirrored if the lower end is on].
                        ///< Bits 0-7 headings, 8-11 an index into edges, 12-15 part
  uint32_t part[15];    ///< of counts (CountParts)
  uint8_t edges[2][9];  ///< [lower end is on]: CellAtVertex::edges
  uint8_t face_way[2][4];  ///< [lower end is on][bits of the line, likewise]: one of the ways on
                           ///< the face
  AxisTable axis[3];

  constexpr CellAtVertex cell_at(int lower_is_on, uint32_t lines) const {
    const uint32_t packed = cell[lower_is_on != 0 ? mirrored(lines) : lines];
    return {static_cast<uint8_t>(packed), edges[lower_is_on][packed >> 8 & 15],
            static_cast<uint8_t>(packed >> 12)};
  }
  constexpr uint8_t face_way_at(int lower_is_on, uint32_t line) const {
    return face_way[lower_is_on][lower_is_on != 0 ? mirrored(line) : line];
  }
  constexpr Incidence incidence_at(int edge_axis, int lower_is_on, int heading) const {
    const AxisTable& table = axis[edge_axis];
    return static_cast<Incidence>(table.incidence[heading] +
                                  (lower_is_on != 0 ? table.to_upper : 0));
  }
};

extern const SectorTable sector_table;

}  // namespace discmc::detail::trace

#endif
