// The rays at a vertex, looked up by the voxels around it, and what a pass along two rays is.
//
// The neighbourhood of a vertex is looked up by halves, of which there are few kinds. A half has
// the rays between its sectors, and one where the halves meet, if the sectors on both sides differ.
// Two queues, those of its rays, name a pass: a queue begins at one edge of a cell and ends at one.
#ifndef DISCMC_MESH_HOST_RAY_TABLE_HPP
#define DISCMC_MESH_HOST_RAY_TABLE_HPP

#include <discmc/trace/sector_table.hpp>

namespace discmc::host {

/// A queue as it is numbered here: those in which tails wait from 0 on, those in which begins do
/// from first_begins on. The last one of either is that of ends at a seam, which no pass takes out.
using QueueCode = uint8_t;

constexpr uint32_t queues_each = detail::trace::queue_count / 2 + 1;
constexpr uint32_t first_begins = queues_each;
constexpr uint32_t queue_codes = first_begins + queues_each;
constexpr QueueCode seam_tails = queues_each - 1, seam_begins = queue_codes - 1;

/// A ray: in bits 0 to 7 the queue of the chain that comes along it, in bits 8 to 15 that of the
/// one that goes, from bit 16 on the incidence of the sector behind it. A pass, of the wedge
/// between two rays, is the same: one of the queues is that of the next ray.
using RayWord = uint32_t;
using PassWord = uint32_t;

constexpr uint32_t in_bits = 0xFF, out_bits = 0xFF00, incidence_bits = 0x1F0000;
constexpr uint32_t incidence_shift = 16;

static_assert(queue_codes <= in_bits + 1 &&
                  incidence_codes - 1 <= incidence_bits >> incidence_shift,
              "a word has two queues and an incidence");

constexpr uint32_t in_of(PassWord pass) {
  return pass & in_bits;
}
constexpr uint32_t out_of(PassWord pass) {
  return pass >> 8 & 0xFF;
}
constexpr PassWord pass_word(uint32_t in, uint32_t out, Incidence incidence) {
  return in | out << 8 | static_cast<uint32_t>(incidence) << incidence_shift;
}

/// A sum of what vertices add to the counts of cells (CountParts), over as many as come at once.
struct PartSum {
  static constexpr uint32_t bits = 21;  // of each of the three
  static constexpr uint64_t of(uint32_t part) {
    constexpr uint32_t facet = detail::trace::CountParts::facet_shift;
    constexpr uint32_t triangle = detail::trace::CountParts::triangle_shift;
    const uint64_t cells = part & ((1U << facet) - 1);
    const uint64_t facets = part >> facet & ((1U << (triangle - facet)) - 1);
    return cells | facets << bits | uint64_t{part >> triangle} << 2 * bits;
  }
};

/// Half of what surrounds a vertex: two of its four cells, quadrants 0 and 1 or 2 and 3. Five lines
/// of voxels (sector_table.hpp) and the one in the middle decide its rays.
struct HalfRays {
  static constexpr uint32_t lines_bits = 10;
  static constexpr uint32_t places = 1U << (lines_bits + 1);
  static constexpr uint32_t kinds = 306;

  /// Those behind the first face, in order; what stands behind the last of them is of no use.
  RayWord ray[3];
  /// The one on the first face, if the sector before it has another incidence; from last_shift on
  /// the incidence of the last sector of the half, from count_shift on how many rays follow.
  RayWord first;
  static constexpr uint32_t last_shift = 21, count_shift = 26;
  static_assert(incidence_codes <= 1 << (count_shift - last_shift),
                "the second incidence has a field");
};

struct RayTable {
  /// What nine voxels of a slice contribute to the lines around the one in the middle: by
  /// how far above the voxel it lies, from -1 on, and its voxels, bit x + 3 y. From the lowest bit,
  /// for each axis: lines 0 to 4 (10 bits), whether the voxel is on (1), lines 4 to 7 and 0 (10).
  uint64_t lines[3][512];
  static constexpr uint32_t axis_bits = 2 * HalfRays::lines_bits + 1;
  static_assert(3 * axis_bits <= 64, "three axes fit");

  /// A half, whatever the axis: its rays, and what its cells add to counts.
  struct Kind {
    uint16_t rays;   ///< a place in `rays`
    uint16_t parts;  ///< a place in `parts`
  };
  Kind kind[2][HalfRays::places];  ///< by half, and lines and voxel as they stand above

  HalfRays rays[3][2][HalfRays::kinds];  ///< by axis and half
  uint64_t parts[120];                   ///< PartSum
};

/// What follows from the queue of a ray, for chains that come along it, and for those that leave.
struct RayEnds {
  /// From the voxel to the vertex, CornerCode::vector(), and `incoming` in its place.
  uint64_t vertex[queue_codes];
  Link incoming[queue_codes];
  uint32_t comes_from_ahead[queue_codes];  ///< all bits if the vertex before is visited later

  /// From the voxel to a corner at the centroid behind the vertex, with its links.
  uint64_t centroid[queue_codes];
  Link first[queue_codes];           ///< by which it goes on, to the next vertex or to a centroid
  uint8_t turns[queue_codes];        ///< 1 if there is a corner at that centroid, else 0
  uint32_t goes_ahead[queue_codes];  ///< all bits if the vertex after is visited later

  /// Equal where the chain has no corner and one of its ends goes from queue to queue. A begin does
  /// not, if there is a corner at the centroid before the vertex: it may wait for the next slice,
  /// and the side up to there be of any length.
  uint32_t straight_in[queue_codes], straight_out[queue_codes];

  uint8_t number[queue_codes];                 ///< what the queue is in sector_table.hpp
  QueueCode code[detail::trace::queue_count];  ///< and back
};

extern const RayTable ray_table;
extern const RayEnds ray_ends;

}  // namespace discmc::host

#endif
