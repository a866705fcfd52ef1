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
      : axis_(axis), lower_(lower_is_on ? 1 : 0), lines_(lines) {
    const auto& sector = sector_table.sector[lower_];
    sector_[0] = sector[0][cell_lines(0)];
    sector_[1] = sector[1][cell_lines(1)];
    sector_[2] = sector[2][cell_lines(2)];
    sector_[3] = sector[3][cell_lines(3)];
    headings_ = sector_[0].headings() | sector_[1].headings() << 8 | sector_[2].headings() << 16 |
                sector_[3].headings() << 24;
    counts_ = count_part(0) + count_part(1) + count_part(2) + count_part(3);
    if (absent != 0) remove(absent);
    // A bit for every ray: the lowest of its nibble.
    uint32_t differ = headings_ ^ (headings_ << 4 | headings_ >> 28);
    differ |= differ >> 2;
    differ |= differ >> 1;
    rays_ = differ & 0x11111111;
    begin_ = rays_;
  }

  /// What the vertex adds to the counts of cells that take part: see CountParts.
  uint32_t counts() const { return counts_; }

  /// The next pass. False when there is none.
  bool next(Pass& pass) {
    while (begin_ != 0) {
      const uint32_t begin = nibble(begin_);
      begin_ &= begin_ - 1;
      const uint32_t end = nibble(begin_ != 0 ? begin_ : rays_);
      const uint32_t heading = headings_ >> begin & 15;
      if (heading > no_heading) continue;
      pass.incidence = axis_.incidence[lower_][heading];
      come_along(pass, lower_ != 0 ? end : begin);
      go_along(pass, lower_ != 0 ? begin : end);
      return true;
    }
    return false;
  }

 private:
  // Rays are told by where their nibble begins.
  static uint32_t nibble(uint32_t bits) { return trailing_zeros(bits); }
  static bool is_face(uint32_t ray) { return ray % 8 == 0; }

  // The lines of a quadrant's cell.
  uint32_t cell_lines(int quadrant) const {
    return (quadrant < 3 ? lines_ >> 4 * quadrant : lines_ >> 12 | lines_ << 4) & 63;
  }
  uint32_t count_part(int quadrant) const {
    return count_parts.part[count_parts.kind[lower_][cell_lines(quadrant)]];
  }

  void remove(uint32_t absent) {
    for (int quadrant = 0; quadrant < quadrants; ++quadrant) {
      if ((absent >> quadrant & 1) == 0) continue;
      headings_ |= uint32_t{0xFF} << 8 * quadrant;
      counts_ -= count_part(quadrant);
    }
  }

  const FaceRay& face_ray(uint32_t quadrant) const {
    const uint32_t line = lines_ >> 4 * quadrant & 3;
    return axis_.face_ray[quadrant][sector_table.face_turn[lower_][line]];
  }

  void come_along(Pass& pass, uint32_t ray) const {
    const uint32_t quadrant = ray / 8;
    if (is_face(ray)) {
      const FaceRay& face = face_ray(quadrant);
      pass.came = opposite_link(face.link);
      pass.comes_from_ahead = face.is_ahead;
      pass.in = static_cast<uint8_t>(face.queue + (face.is_ahead ? 1 : 0));
      return;
    }
    const CellEdge own = axis_.own_edge[quadrant];
    const CellEdge from = axis_.edge[sector_[quadrant].from()];
    pass.came = opposite_link(sector_table.inwards[own]);
    pass.comes_from_ahead = from > own;
    pass.in = sector_table.queue[from][own];
  }

  void go_along(Pass& pass, uint32_t ray) const {
    const uint32_t quadrant = ray / 8;
    pass.has_centroid = !is_face(ray);
    if (is_face(ray)) {
      const FaceRay& face = face_ray(quadrant);
      pass.first = pass.second = face.link;
      pass.goes_ahead = face.is_ahead;
      pass.out = static_cast<uint8_t>(face.queue + (face.is_ahead ? 0 : 1));
      return;
    }
    const CellEdge own = axis_.own_edge[quadrant];
    const CellEdge to = axis_.edge[sector_[quadrant].to()];
    pass.first = sector_table.inwards[own];
    pass.second = opposite_link(sector_table.inwards[to]);
    pass.goes_ahead = to > own;
    pass.out = sector_table.queue[own][to];
  }

  const AxisTable& axis_;
  uint32_t lower_;
  uint32_t lines_;
  Sector sector_[quadrants];
  uint32_t headings_;
  uint32_t counts_;
  uint32_t rays_;
  uint32_t begin_;  // the rays at which the next wedges begin
};

}  // namespace discmc::trace

#endif
