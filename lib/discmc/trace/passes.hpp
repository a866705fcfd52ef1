// The passes at a vertex: which chains go through it, from where to where.
//
// Where two sectors around the vertex differ runs a boundary link, a ray. Through the sectors
// between two rays, a wedge, one chain passes: it comes in along one ray and goes out along the
// other, with the wedge on its left. Where all sectors are alike there is nothing to do.
#ifndef DISCMC_TRACE_PASSES_HPP
#define DISCMC_TRACE_PASSES_HPP

#include <discmc/compiler.hpp>
#include <discmc/trace/sector_table.hpp>

namespace discmc::trace {

/// One chain's way through a vertex. The two spokes of a wedge at a centroid are one link here, so
/// the link that goes out may have a corner on the way.
struct Pass {
  Incidence incidence;
  Link came;    ///< the way in which the chain comes to the vertex
  Link first;   ///< the way in which it goes on,
  Link second;  ///< and the way from the centroid; the same where there is none, or no corner
  bool has_centroid;
  bool comes_from_ahead;  ///< the vertex before is visited later
  bool goes_ahead;        ///< the vertex after is visited later
  uint8_t in, out;        ///< queues of the links that come in and go out
};

/// All passes at a vertex, one after the other.
class Passes {
 public:
  /// lines: of the ring around the crossing edge, two bits each (sector_table.hpp). absent: by
  /// quadrant, a bit: there is no cell, or none that takes part.
  Passes(const AxisTable& axis, bool lower_is_on, uint32_t lines, uint32_t absent)
      : axis_(axis), lower_(lower_is_on ? 1 : 0), lines_(lines | lines << 16) {
    uint32_t headings = sector(0).headings | uint32_t{sector(1).headings} << 8 |
                        uint32_t{sector(2).headings} << 16 | uint32_t{sector(3).headings} << 24;
    // Turned from quadrant 0 to their own: 2 lines on a quadrant, but for those that head nowhere.
    const uint32_t nowhere = headings & 0x88888888;
    headings = ((headings + 0x66442200) & 0x77777777 & ~(nowhere - (nowhere >> 3))) | nowhere;
    counts_ = count_part(0) + count_part(1) + count_part(2) + count_part(3);
    if (absent != 0) remove(absent, headings);
    headings_ = headings;
    // A bit for every ray: the lowest of its nibble.
    uint32_t differ = headings ^ (headings << 4 | headings >> 28);
    differ |= differ >> 2;
    differ |= differ >> 1;
    rays_ = differ & 0x11111111;
    left_ = rays_;
  }

  /// What the vertex adds to the counts of cells that take part: see CountParts.
  uint32_t counts() const { return counts_; }

  /// The next pass. False when there is none.
  bool next(Pass& pass) {
    while (left_ != 0) {
      const uint32_t begin = nibble(left_);
      left_ &= left_ - 1;
      const uint32_t end = nibble(left_ != 0 ? left_ : rays_);
      const uint32_t heading = headings_ >> begin & 15;
      if (heading > no_heading) continue;
      pass.incidence = axis_.incidence[lower_][heading];
      come_along(pass, lower_ != 0 ? end : begin);
      go_along(pass, lower_ != 0 ? begin : end);
      return true;
    }
    return false;
  }

  /// What next() has yet to look at, and to go on from there.
  uint32_t left() const { return left_; }
  void go_on(uint32_t left) { left_ = left; }

 private:
  // Rays are told by where their nibble begins.
  static uint32_t nibble(uint32_t bits) { return trailing_zeros(bits); }
  static bool is_face(uint32_t ray) { return (ray & 4) == 0; }

  // The lines of a quadrant's cell.
  uint32_t cell_lines(uint32_t quadrant) const { return lines_ >> 4 * quadrant & 63; }
  const Sector& sector(uint32_t quadrant) const {
    return sector_table.sector[lower_][cell_lines(quadrant)];
  }
  uint32_t count_part(uint32_t quadrant) const {
    return count_parts.part[count_parts.kind[lower_][cell_lines(quadrant)]];
  }

  void remove(uint32_t absent, uint32_t& headings) {
    for (uint32_t quadrant = 0; quadrant < quadrants; ++quadrant) {
      if ((absent >> quadrant & 1) == 0) continue;
      headings |= uint32_t{0xFF} << 8 * quadrant;
      counts_ -= count_part(quadrant);
    }
  }

  uint32_t face_way(uint32_t quadrant) const {
    return sector_table.face_way[lower_][lines_ >> 4 * quadrant & 3];
  }

  void come_along(Pass& pass, uint32_t ray) const {
    const uint32_t quadrant = ray / 8;
    const Way* const ways = axis_.way[quadrant];
    const bool on_face = is_face(ray);
    const Way way = ways[on_face ? face_way(quadrant) : sector(quadrant).edges >> 4U];
    pass.came = opposite_link(on_face ? way.link() : axis_.inwards[quadrant]);
    pass.comes_from_ahead = way.is_ahead();
    pass.in = way.queue_in();
  }

  void go_along(Pass& pass, uint32_t ray) const {
    const uint32_t quadrant = ray / 8;
    const Way* const ways = axis_.way[quadrant];
    const bool on_face = is_face(ray);
    const Way way = ways[on_face ? face_way(quadrant) : sector(quadrant).edges & 15U];
    pass.has_centroid = !on_face;
    pass.first = on_face ? way.link() : axis_.inwards[quadrant];
    pass.second = way.link();
    pass.goes_ahead = way.is_ahead();
    pass.out = way.queue_out();
  }

  const AxisTable& axis_;
  uint32_t lower_;
  uint32_t lines_;  // once and once more
  uint32_t headings_;
  uint32_t counts_;
  uint32_t rays_;
  uint32_t left_;  // the rays at which the next wedges begin
};

}  // namespace discmc::trace

#endif
