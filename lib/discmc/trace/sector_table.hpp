// The sectors around a vertex, derived from the face rule of cell.hpp.
//
// A vertex lies on a crossing edge, which four cells share. Seen along the edge's axis they are the
// quadrants 0 to 3, counter-clockwise; u and v are the two axes that follow in cyclic order:
//
//             v                 Nine lines of voxels run along the axis: the one in the middle
//       3     2     1           crosses, the others are the ring, lines 0 to 7. Each is two bits,
//          q1 | q0              the voxel at the edge's lower end and that at its upper end.
//       4 --- o --- 0   u
//          q2 | q3              Quadrant q has the lines 2q, 2q + 1, 2q + 2 of the ring.
//       5     6     7
//
// In each cell one loop passes through the vertex, from the face at line 2q to that at line 2q + 2.
// Its facets there have one incidence, or two with a spoke to the centroid between them: so each
// quadrant has two sectors. All incidences around a vertex have the same part along the axis; the
// rest is one of nine, its heading: 0 to 7 as the lines of the ring, or 8 for none. Between two
// sectors lies a ray: ray 2q on a face, ray 2q + 1 the spoke of quadrant q.
#ifndef DISCMC_TRACE_SECTOR_TABLE_HPP
#define DISCMC_TRACE_SECTOR_TABLE_HPP

#include <discmc/compiler.hpp>
#include <discmc/geometry/cell.hpp>

namespace discmc::trace {

/// The edges of a cell, numbered in the order in which a sweep visits them.
using CellEdge = uint8_t;

constexpr int cell_edges = 12;
constexpr int quadrants = 4;
constexpr uint8_t no_heading = 8;

/// What a cell is at one of its vertices, turned to quadrant 0: the headings of its two sectors,
/// and where the chains of the spoke between them lead.
struct CellAtVertex {
  /// Of the quadrant's first sector in bits 0 to 3, of its second in bits 4 to 7. The spoke is
  /// boundary where they differ.
  uint8_t headings;
  /// The chain that leaves along the spoke goes to the edge in bits 0 to 3 by the cell's centroid,
  /// and the one that comes along it is from the edge in bits 4 to 7. Both as if the axis were x.
  uint8_t edges;
  uint8_t part;  ///< of counts: an index into SectorTable::part
};

/// Ends wait in queues, one for each kind of link and each way of a chain along it: 36 for links on
/// faces, by the edge that they begin on and their vector, and 108 for links by the centroid of a
/// cell, by the edges that they join: 42 pairs of edges both ways, 24 one way only. Links of one
/// kind end in the order in which they began. Those of the first queues stay within a slice, those
/// from `first_rising_queue` on reach the next. The two queues of a link that is taken both ways
/// differ in their lowest bit.
constexpr int queue_count = 144;
constexpr int first_rising_queue = 76;

/// The link that runs along a ray from a vertex to another.
class Way {
 public:
  constexpr Way() = default;
  /// queue: of the chains that go from the vertex.
  constexpr Way(Link link, uint8_t queue, bool is_ahead)
      : queue_(queue), link_(static_cast<uint8_t>(link | (is_ahead ? ahead : 0))) {}

  /// By a centroid: from there to the other vertex.
  constexpr Link link() const { return link_ & (ahead - 1); }
  /// Whether the other vertex is visited later.
  constexpr bool is_ahead() const { return link_ >= ahead; }
  /// Where the chains wait that go along the ray, and those that come along it; where none ever do,
  /// a queue of others.
  constexpr uint8_t queue_out() const { return queue_; }
  constexpr uint8_t queue_in() const { return queue_ ^ 1; }

 private:
  static constexpr uint8_t ahead = 0x80;
  uint8_t queue_ = 0;
  uint8_t link_ = 0;
};

/// The ways of a quadrant: along its spoke by the edge where it leads (as in CellAtVertex), and on
/// its face straight, down or up the axis.
constexpr int ways = cell_edges + 3;
constexpr uint8_t straight_way = cell_edges, downward_way = cell_edges + 1,
                  upward_way = cell_edges + 2;

/// What depends on the axis of an edge.
struct AxisTable {
  Way way[quadrants][ways];
  Link inwards[quadrants];              ///< from the vertex to the centroid
  Incidence incidence[no_heading + 1];  ///< [heading], where the lower end is off
  uint8_t to_upper;                     ///< what that of the same heading is more where it is on
};

/// Of lines of voxels, mirrored along the axis: the ends of each change places.
DISCMC_ALWAYS_INLINE constexpr uint32_t mirrored(uint32_t lines) {
  return (lines & 0x5555) << 1 | (lines >> 1 & 0x5555);
}

/// What a scan counts of cells: every vertex adds a part for each of its four cells, so that a
/// cell, a facet and a triangle of classic Marching Cubes are counted once when all vertices are.
struct CountParts {
  // Units of one, and where in a word their sum over four cells stands.
  static constexpr uint32_t cell = 2520, facet = 12, triangle = 420;
  static constexpr uint32_t facet_shift = 12, triangle_shift = 18;
};

/// A cell and its mirror image have the same headings and parts.
struct SectorTable {
  uint16_t cell[64];  ///< [bits of the quadrant's three lines, mirrored if the lower end is on]:
                      ///< headings in bits 0 to 7, indices into edges in 8 to 11, part in 12 to 15
  uint32_t part[15];  ///< of counts (CountParts)
  uint8_t edges[2][9];     ///< [lower end is on]: CellAtVertex::edges
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
  constexpr Incidence incidence_at(int of_axis, int lower_is_on, int heading) const {
    const AxisTable& table = axis[of_axis];
    return static_cast<Incidence>(table.incidence[heading] +
                                  (lower_is_on != 0 ? table.to_upper : 0));
  }
};

extern const SectorTable sector_table;

}  // namespace discmc::trace

#endif
