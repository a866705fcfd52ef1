// The passes at a vertex: which chains go through it, from where to where.
//
// Where two sectors around the vertex differ runs a boundary link, a ray. Through the sectors
// between two rays, a wedge, one chain passes: it comes in along one ray and goes out along the
// other, with the wedge on its left. Where all sectors are alike there is nothing to do.
#ifndef DISCMC_TRACE_PASSES_HPP
#define DISCMC_TRACE_PASSES_HPP

#include <discmc/trace/sector_table.hpp>

namespace discmc::trace {

/// One chain's way through a vertex. The two spokes of a wedge at a centroid are one link here, so
/// the link that goes out may have a corner on the way.
struct Pass {
  Incidence incidence;
  Link came;      ///< the way in which the chain comes to the vertex
  Link first;     ///< the way in which it goes on,
  Link second;    ///< and, behind a centroid, the way from there
  bool has_centroid;
  bool comes_from_ahead;  ///< the vertex before is visited later
  bool goes_ahead;        ///< the vertex after is visited later
  uint8_t in, out;        ///< queues of the links that come in and go out
};

/// The lines around a crossing edge: two bits each, see sector_table.hpp.
struct Ring {
  int axis;
  bool lower_is_on;
  uint32_t lines;
};

/// All passes at a vertex, one after the other.
class Passes {
 public:
  /// absent: by quadrant, a bit: there is no cell, or none that takes part.
  Passes(const Ring& ring, uint32_t absent) : ring_(ring) {
    const uint32_t twice = ring.lines | ring.lines << 16;
    for (int quadrant = 0; quadrant < quadrants; ++quadrant) {
      sector_[quadrant] =
          sector_table.sector[quadrant][ring.lower_is_on ? 1 : 0][twice >> 4 * quadrant & 63];
      headings_ |= sector_[quadrant].headings() << 8 * quadrant;
    }
    if (absent != 0) remove(absent);
    // A bit for every ray: the lowest of its nibble.
    uint32_t differ = headings_ ^ (headings_ << 4 | headings_ >> 28);
    differ |= differ >> 2;
    differ |= differ >> 1;
    rays_ = differ & 0x11111111;
    if (rays_ == 0) return;
    first_ = begin_ = static_cast<uint32_t>(__builtin_ctz(rays_)) / 4;
    rays_ &= rays_ - 1;
  }

  /// The next pass. False when there is none.
  bool next(Pass& pass) {
    while (begin_ != none) {
      const uint32_t begin = begin_;
      const bool is_last = rays_ == 0;
      const uint32_t end = is_last ? first_ : static_cast<uint32_t>(__builtin_ctz(rays_)) / 4;
      begin_ = is_last ? none : end;
      rays_ &= rays_ - 1;
      const uint32_t heading = headings_ >> 4 * begin & 15;
      if (heading > no_heading) continue;
      const int lower = ring_.lower_is_on ? 1 : 0;
      pass.incidence = sector_table.incidence[ring_.axis][lower][heading];
      come_along(pass, ring_.lower_is_on ? end : begin);
      go_along(pass, ring_.lower_is_on ? begin : end);
      return true;
    }
    return false;
  }

 private:
  static constexpr uint32_t none = rays;

  void remove(uint32_t absent) {
    for (int quadrant = 0; quadrant < quadrants; ++quadrant)
      if ((absent >> quadrant & 1) != 0) headings_ |= uint32_t{0xFF} << 8 * quadrant;
  }

  const FaceRay& face_ray(uint32_t quadrant) const {
    const uint32_t line = ring_.lines >> 4 * quadrant & 3;
    const int turn = sector_table.face_turn[ring_.lower_is_on ? 1 : 0][line];
    return sector_table.face_ray[ring_.axis][quadrant][turn];
  }

  void come_along(Pass& pass, uint32_t ray) const {
    const uint32_t quadrant = ray / 2;
    if (ray % 2 == 0) {
      const FaceRay& face = face_ray(quadrant);
      pass.came = opposite_link(face.link);
      pass.comes_from_ahead = face.is_ahead;
      pass.in = static_cast<uint8_t>(face.queue + (face.is_ahead ? 1 : 0));
      return;
    }
    const CellEdge own = sector_table.own_edge[ring_.axis][quadrant];
    const CellEdge from = sector_table.edge[ring_.axis][sector_[quadrant].from()];
    pass.came = opposite_link(sector_table.inwards[own]);
    pass.comes_from_ahead = from > own;
    pass.in = sector_table.queue[from][own];
  }

  void go_along(Pass& pass, uint32_t ray) const {
    const uint32_t quadrant = ray / 2;
    pass.has_centroid = ray % 2 != 0;
    if (!pass.has_centroid) {
      const FaceRay& face = face_ray(quadrant);
      pass.first = pass.second = face.link;
      pass.goes_ahead = face.is_ahead;
      pass.out = static_cast<uint8_t>(face.queue + (face.is_ahead ? 0 : 1));
      return;
    }
    const CellEdge own = sector_table.own_edge[ring_.axis][quadrant];
    const CellEdge to = sector_table.edge[ring_.axis][sector_[quadrant].to()];
    pass.first = sector_table.inwards[own];
    pass.second = opposite_link(sector_table.inwards[to]);
    pass.goes_ahead = to > own;
    pass.out = sector_table.queue[own][to];
  }

  Ring ring_;
  Sector sector_[quadrants];
  uint32_t headings_ = 0;
  uint32_t rays_;
  uint32_t first_ = none;  // the first ray of all
  uint32_t begin_ = none;  // the ray at which the next wedge begins
};

}  // namespace discmc::trace

#endif
