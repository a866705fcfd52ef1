#include <discmc/compiler.hpp>
#include <discmc/trace/passes.hpp>

namespace discmc::trace {

namespace {

// The eight sectors around a vertex have a nibble each in a word: a heading, 8 for none, 15 where
// the cell is absent. So have the rays between them: a ray is named by where its nibble begins.
class Surroundings {
 public:
  Surroundings(int axis, bool lower_is_on, uint32_t lines, uint32_t absent)
      : axis_(sector_table.axis[axis]),
        lower_is_on_(lower_is_on ? 1 : 0),
        lines_(lines * 0x10001) {
    DISCMC_UNROLL(4)
    for (uint32_t quadrant = 0; quadrant < quadrants; ++quadrant) {
      const CellAtVertex& seen = cell(quadrant);
      headings_ |= uint32_t{seen.headings} << 8 * quadrant;
      parts_ += sector_table.part[seen.part];
    }
    // Turned from quadrant 0 to their own: adds 2q, modulo 8, to both headings of quadrant q, and
    // leaves an 8, no heading, alone.
    const uint32_t nowhere = headings_ & 0x88888888;
    headings_ = ((headings_ + 0x66442200) & 0x77777777 & ~(nowhere - (nowhere >> 3))) | nowhere;
    if (absent != 0) remove(absent);
  }

  uint32_t parts() const { return parts_; }

  // Where the sectors on both sides differ.
  uint32_t rays() const {
    uint32_t differ = headings_ ^ (headings_ << 4 | headings_ >> 28);
    differ |= differ >> 2;
    differ |= differ >> 1;
    return differ & 0x11111111;
  }

  // Of the wedge that begins at a ray.
  Incidence incidence(uint32_t ray) const {
    const uint32_t heading = headings_ >> ray & 15;
    return heading > no_heading ? no_incidence : axis_.incidence[lower_is_on_][heading];
  }

  // A ray lies between two wedges: one chain comes along it, and the other goes.
  void set_ray(uint32_t ray, Pass& ending, Pass& beginning) const {
    Pass& comes = lower_is_on_ != 0 ? ending : beginning;
    Pass& goes = lower_is_on_ != 0 ? beginning : ending;
    const uint32_t quadrant = ray / 8;
    const Way* const ways = axis_.way[quadrant];
    if ((ray & 4) == 0) {
      const Way way = ways[sector_table.face_way[lower_is_on_][lines_ >> 4 * quadrant & 3]];
      come(way, opposite_link(way.link()), comes);
      go(way.link(), way, 0, goes);
    } else {
      const uint32_t edges = cell(quadrant).edges;
      const Link inwards = axis_.inwards[quadrant];
      come(ways[edges >> 4], opposite_link(inwards), comes);
      go(inwards, ways[edges & 15], Pass::by_centroid, goes);
    }
  }

 private:
  void remove(uint32_t absent) {
    for (uint32_t quadrant = 0; quadrant < quadrants; ++quadrant) {
      if ((absent >> quadrant & 1) == 0) continue;
      headings_ |= uint32_t{0xFF} << 8 * quadrant;
      parts_ -= sector_table.part[cell(quadrant).part];
    }
  }
  const CellAtVertex& cell(uint32_t quadrant) const {
    return sector_table.cell[lower_is_on_][lines_ >> 4 * quadrant & 63];
  }
  static void come(Way way, Link link, Pass& pass) {
    pass.incoming = link;
    pass.in = way.queue_in();
    pass.comes_from_ahead = way.is_ahead();
  }
  static void go(Link first, Way way, uint8_t centroid, Pass& pass) {
    pass.first = first;
    pass.second = way.link();
    pass.out = way.queue_out();
    pass.flags = static_cast<uint8_t>(centroid | (way.is_ahead() ? Pass::ahead : 0));
  }

  const AxisTable& axis_;
  uint32_t lower_is_on_;
  uint32_t lines_;  // twice, so that quadrant 3, of the lines 6, 7 and 0, is one shift, too
  uint32_t headings_ = 0;
  uint32_t parts_ = 0;
};

// Takes out the wedges where there are no cells.
void remove_absent(PassList& passes) {
  uint8_t count = 0;
  for (uint32_t i = 0; i < passes.count; ++i)
    if (passes.pass[i].incidence != no_incidence) passes.pass[count++] = passes.pass[i];
  passes.count = count;
}

}  // namespace

void derive_passes(int axis, bool lower_is_on, uint32_t lines, uint32_t absent, PassList& passes) {
  const Surroundings around(axis, lower_is_on, lines, absent);
  passes.parts = around.parts();
  passes.count = 0;
  const uint32_t rays = around.rays();
  if (rays == 0) return;
  // From the second ray on, and the first one last: so the first wedge begins at the first ray.
  Pass* ending = passes.pass;
  for (uint32_t left = rays;;) {
    ++passes.count;
    left &= left - 1;
    const uint32_t ray = trailing_zeros(left != 0 ? left : rays);
    Pass* const beginning = left != 0 ? ending + 1 : passes.pass;
    beginning->incidence = around.incidence(ray);
    around.set_ray(ray, *ending, *beginning);
    if (left == 0) break;
    ending = beginning;
  }
  if (absent != 0) remove_absent(passes);
}

}  // namespace discmc::trace
