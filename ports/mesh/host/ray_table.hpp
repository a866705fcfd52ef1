// Tables of the rays at a vertex, by the voxels around it. A pass lies between two rays.
//
// The neighbourhood of a vertex is looked up by halves, of which there are few kinds. A half has a
// ray between its differing sectors. If the halves differ where they meet, there is a ray as well.
// A pass is identified by the queues of its two rays: a queue leads from one edge of a cell to
// another.
#ifndef DISCMC_MESH_HOST_RAY_TABLE_HPP
#define DISCMC_MESH_HOST_RAY_TABLE_HPP

#include <discmc/trace/sector_table.hpp>

namespace discmc::host {

/// The number of a queue: tails from 0, begins from first_begins. The last queue of each kind holds
/// the ends at a seam, which no pass removes.
using QueueCode = uint8_t;

constexpr uint32_t queues_each = detail::trace::queue_count / 2 + 1;
constexpr uint32_t first_begins = queues_each;
constexpr uint32_t queue_codes = first_begins + queues_each;
constexpr QueueCode seam_tails = queues_each - 1, seam_begins = queue_codes - 1;

/// A ray. Bits 0-7: the queue of the chain that arrives along the ray. 8-15: the queue of the chain
/// that leaves. 16-20: the incidence of the sector behind the ray. A pass has the same bits, but
/// one of its queues belongs to the next ray.
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

/// The sum of the counts of cells (CountParts) over a batch of vertices.
struct PartSum {
  static constexpr uint32_t bits = 21;  // per count
  static constexpr uint64_t from_part(uint32_t part) {
    constexpr uint32_t facet = detail::trace::CountParts::facet_shift;
    constexpr uint32_t triangle = detail::trace::CountParts::triangle_shift;
    const uint64_t cells = part & ((1U << facet) - 1);
    const uint64_t facets = part >> facet & ((1U << (triangle - facet)) - 1);
    return cells | facets << bits | uint64_t{part >> triangle} << 2 * bits;
  }
};

/// Half of the neighbourhood of a vertex: two of the four cells, quadrants 0 and 1 or 2 and 3. Five
/// lines of voxels (sector_table.hpp) and the voxel in the middle determine the rays.
struct HalfRays {
  static constexpr uint32_t lines_bits = 10;
  static constexpr uint32_t neighbourhoods = 1U << (lines_bits + 1);
  static constexpr uint32_t kinds = 306;

  /// The rays behind the first face, in order; words after the last ray are unused.
  RayWord ray[3];
  /// The ray on the first face. It exists if the sector before it has another incidence. From
  /// last_shift: the incidence of the half's last sector. From count_shift: the number of further
  /// rays.
  RayWord first;
  static constexpr uint32_t last_shift = 21, count_shift = 26;
  static_assert(incidence_codes <= 1 << (count_shift - last_shift),
                "the second incidence has a field");
};

struct RayTable {
  /// The lines of 3 x 3 voxels of a slice around the middle voxel. First index: the slice below,
  /// with, or above that voxel. Second index: the voxels, bit x + 3 y. Each axis has 21 bits, from
  /// the lowest: lines 0 to 4 (10), the voxel (1), lines 4 to 7 and 0 (10).
  uint64_t lines[3][512];
  static constexpr uint32_t axis_bits = 2 * HalfRays::lines_bits + 1;
  static_assert(3 * axis_bits <= 64, "three axes fit");

  /// A half of any axis: its rays, and the counts of its cells.
  struct Kind {
    uint16_t rays;   ///< an index of `rays`
    uint16_t parts;  ///< an index of `parts`
  };
  Kind kind[2][HalfRays::neighbourhoods];  ///< by half, then by lines and voxel as above

  HalfRays rays[3][2][HalfRays::kinds];  ///< by axis and half
  uint64_t parts[120];                   ///< PartSum
};

/// The properties of each queue, for arriving and leaving chains.
struct QueueTraits {
  /// CornerCode::vector() from the voxel to the vertex, with the arriving link.
  uint64_t vertex[queue_codes];
  Link incoming[queue_codes];
  uint32_t comes_from_ahead[queue_codes];  ///< all bits if the vertex before is visited later

  /// CornerCode::vector() from the voxel to the corner at the centroid behind the vertex, with both
  /// links.
  uint64_t centroid[queue_codes];
  Link outgoing[queue_codes];        ///< the leaving link, to the next vertex or a centroid
  uint8_t turns[queue_codes];        ///< 1 if there is a corner at that centroid, else 0
  uint32_t goes_ahead[queue_codes];  ///< all bits if the vertex after is visited later

  /// straight_in[a] equals straight_out[b] if a pass from queue a to queue b has no corner, and
  /// only moves an end to another queue. Such a pass moves no begin with a corner at the centroid
  /// before the vertex. That begin may wait for the next slice, with a long side to the centroid.
  uint32_t straight_in[queue_codes], straight_out[queue_codes];

  QueueCode code[detail::trace::queue_count];  ///< by the number in sector_table.hpp
};

extern const RayTable ray_table;
extern const QueueTraits queue_traits;

}  // namespace discmc::host

#endif
