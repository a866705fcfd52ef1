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

#include <discmc/cell.hpp>

namespace discmc::trace {

/// The edges of a cell, numbered in the order in which a sweep visits them.
using CellEdge = uint8_t;

constexpr int cell_edges = 12;
constexpr int quadrants = 4;
constexpr int rays = 8;
constexpr uint8_t no_heading = 8;

/// What a cell is at one of its vertices: two headings, and where the chains of its spoke lead.
class Sector {
 public:
  constexpr Sector() = default;
  constexpr Sector(uint32_t headings, CellEdge from, CellEdge to)
      : code_(static_cast<uint16_t>(headings | uint32_t{from} << 8 | uint32_t{to} << 12)) {}

  /// Of the quadrant's first sector in bits 0 to 3, of its second in bits 4 to 7.
  constexpr uint32_t headings() const { return code_ & 0xFF; }
  /// Whether the spoke is boundary: its two sectors differ.
  constexpr bool has_spoke() const { return (code_ & 15) != (code_ >> 4 & 15); }
  /// The chain that comes along the spoke comes from this edge of the cell by its centroid ...
  constexpr CellEdge from() const { return code_ >> 8 & 15; }
  /// ... and the one that leaves along it goes to this edge. Both as if the axis were x.
  constexpr CellEdge to() const { return static_cast<CellEdge>(code_ >> 12); }

 private:
  uint16_t code_ = 0;
};

/// A link between two vertices on a face of a cell, seen from one of them.
struct FaceRay {
  Link link;
  uint8_t queue;  ///< of the chains that go from its earlier vertex to the later; 1 more: back
  bool is_ahead;  ///< the other vertex is visited later
};

/// Ends wait in queues, one for each kind of link and each way of the chain along it: 36 for links
/// on faces, by their vectors, and 108 for links by the centroid of a cell, by the edges that they
/// join. Links of one kind end in the order in which they began. Those of the first queues stay
/// within a slice, those from `first_rising_queue` on reach the next.
constexpr int queue_count = 144;
constexpr int first_rising_queue = 76;

/// What depends on the axis of an edge.
struct AxisTable {
  FaceRay face_ray[quadrants][3];      ///< [quadrant][straight, down or up the axis]
  CellEdge edge[cell_edges];           ///< an edge as if the axis were x, as it is
  CellEdge own_edge[quadrants];        ///< the edge of the quadrant's cell that the vertex lies on
  Incidence incidence[2][no_heading + 1];  ///< [lower end is on][heading]
};

struct SectorTable {
  Sector sector[2][quadrants][64];  ///< [lower end is on][quadrant][bits of its three lines]
  AxisTable axis[3];
  uint8_t face_turn[2][4];               ///< which face ray: [lower end is on][bits of the line]
  uint8_t queue[cell_edges][cell_edges];  ///< of the chains from one edge by the centroid to another
  Link inwards[cell_edges];               ///< from an edge to the centroid
  Direction direction[incidence_codes][link_codes];  ///< of a link in a plane, or no_direction
};

extern const SectorTable sector_table;

/// What a scan counts of cells: every vertex adds a part for each of its four cells, so that a cell,
/// a facet and a triangle of classic Marching Cubes are counted once when all vertices are.
struct CountParts {
  // Units of one, and where in a word their sum over four cells stands.
  static constexpr uint32_t cell = 2520, facet = 12, triangle = 420;
  static constexpr uint32_t facet_shift = 12, triangle_shift = 18;

  uint8_t kind[2][64];  ///< [lower end is on][bits of the cell's three lines]
  uint32_t part[32];    ///< by kind
};

extern const CountParts count_parts;

}  // namespace discmc::trace

#endif
