// The rays at a vertex, looked up by the voxels around it, and the pass between two rays.
//
// The neighbourhood of a vertex is looked up by halves, of which there are few kinds. A half has a
// ray between each two of its sectors, and one where the halves meet if the sectors there differ.
// The queues of its two rays identify a pass: a queue leads from one edge of a cell to another.
#ifndef DISCMC_MESH_HOST_RAY_TABLE_HPP
#define DISCMC_MESH_HOST_RAY_TABLE_HPP

#include <discmc/trace/sector_table.hpp>

namespace discmc::host {

/// The number of a queue here: queues of tails from 0 on, queues of begins from first_begins on.
/// The last queue of either kind holds the ends at a seam, which no pass removes.
using QueueCode = uint8_t;

constexpr uint32_t queues_each = detail::trace::queue_count / 2 + 1;
constexpr uint32_t first_begins = queues_each;
constexpr uint32_t queue_codes = first_begins + queues_each;
constexpr QueueCode seam_tails = queues_each - 1, seam_begins = queue_codes - 1;

/// A ray. Bits 0-7: the queue of the chain that arrives along it. 8-15: the queue of the chain that
/// leaves along it. 16-20: the incidence of the sector behind it. A pass lies in the wedge between
/// two rays and has the same bits, but one of its queues is that of the next ray.
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

  /// The rays behind the first face, in order; the words after the last of them are unused.
  RayWord ray[3];
  /// The ray on the first face, which exists if the sector before it has another incidence. From
  /// last_shift on: the incidence of the half's last sector. From count_shift on: how many rays
  /// follow.
  RayWord first;
  static constexpr uint32_t last_shift = 21, count_shift = 26;
  static_assert(incidence_codes <= 1 << (count_shift - last_shift),
                "the second incidence has a field");
};

struct RayTable {
  /// What 3 x 3 voxels of a slice contribute to the lines around the middle voxel. By the height of
  /// the slice above that voxel, plus 1, and by the voxels: bit x + 3 y. An axis has 21 bits, from
  /// the lowest: lines 0 to 4 (10), the voxel (1), lines 4 to 7 and 0 (10).
  uint64_t lines[3][512];
  static constexpr uint32_t axis_bits = 2 * HalfRays::lines_bits + 1;
  static_assert(3 * axis_bits <= 64, "three axes fit");

  /// A half, whatever the axis: its rays, and what its cells add to counts.
  struct Kind {
    uint16_t rays;   ///< a place in `rays`
    uint16_t parts;  ///< a place in `parts`
  };
  Kind kind[2][HalfRays::places];  ///< by half, and by lines and voxel, in the order above

  HalfRays rays[3][2][HalfRays::kinds];  ///< by axis and half
  uint64_t parts[120];                   ///< PartSum
};

/// What follows from the queue of a ray, for chains that arrive along it and for chains that leave.
struct RayEnds {
  /// From the voxel to the vertex, CornerCode::vector(), and `incoming` in its place.
  uint64_t vertex[queue_codes];
  Link incoming[queue_codes];
  uint32_t comes_from_ahead[queue_codes];  ///< all bits if the vertex before is visited later

  /// From the voxel to a corner at the centroid behind the vertex, with its links.
  uint64_t centroid[queue_codes];
  Link first[queue_codes];           ///< by which it leaves, to the next vertex or a centroid
  uint8_t turns[queue_codes];        ///< 1 if there is a corner at that centroid, else 0
  uint32_t goes_ahead[queue_codes];  ///< all bits if the vertex after is visited later

  /// straight_in[a] equals straight_out[b] if a pass from queue a to queue b has no corner and
  /// moves one end to another queue. It never does for a begin with a corner at the centroid before
  /// the vertex. That begin may wait for the next slice, and its side to the centroid may be long.
  uint32_t straight_in[queue_codes], straight_out[queue_codes];

  uint8_t number[queue_codes];                 ///< what the queue is in sector_table.hpp
  QueueCode code[detail::trace::queue_count];  ///< and back
};

extern const RayTable ray_table;
extern const RayEnds ray_ends;

}  // namespace discmc::host

#endif
