#include <discmc/base/compiler.hpp>
#include <discmc/trace/passes.hpp>

namespace discmc::detail::trace {

namespace {

// The eight sectors around a vertex have a nibble each in a word: a heading, 8 for none, or 15 if
// the cell is absent. Rays lie between the nibbles; the bit at which the following nibble begins
// names a ray.
template <bool is_lean>
class Surroundings {
 public:
  template <class Edge>
  Surroundings(const Edge& edge, uint32_t absent)
      : axis_(sector_table.axis[edge.axis]), lower_is_on_(edge.lower_is_on() ? 1 : 0) {
    const uint32_t lines = edge.lines();
    lines_ = (lower_is_on_ != 0 ? mirrored(lines) : lines) * 0x10001;
    DISCMC_UNROLL(4)
    for (uint32_t quadrant = 0; quadrant < quadrants; ++quadrant) {
      const uint32_t packed_cell = cell(quadrant);
      headings_ = headings_ >> 8 | packed_cell << 24;
      if constexpr (!is_lean) parts_ += sector_table.part[packed_cell >> 12];
    }
    // Turns headings from quadrant 0 to their own quadrant q: adds 2q, modulo 8, and leaves an 8,
    // no heading, unchanged.
    const uint32_t no_heading_bits = headings_ & 0x88888888;
    headings_ =
        ((headings_ + 0x66442200) & 0x77777777 & ~(no_heading_bits - (no_heading_bits >> 3))) |
        no_heading_bits;
    if (!is_lean && absent != 0) remove(absent);
  }

  uint32_t parts() const { return parts_; }

  // Returns the rays between differing sectors.
  uint32_t rays() const {
    uint32_t differ = headings_ ^ (headings_ << 4 | headings_ >> 28);
    differ |= differ >> 2;
    differ |= differ >> 1;
    return differ & 0x11111111;
  }

  // Returns the incidence of the wedge that begins at a ray.
  Incidence incidence(uint32_t ray) const {
    const uint32_t heading = headings_ >> ray & 15;
    if (!is_lean && heading > no_heading) return no_incidence;
    return static_cast<Incidence>(axis_.incidence[heading] +
                                  (lower_is_on_ != 0 ? axis_.to_upper : 0));
  }

  // A ray lies between two wedges: one chain arrives along it, the other leaves. A chain has its
  // wedge on the left, seen from the tip of the normal. If the lower end is off, normals point down
  // the axis. Sectors are counted as seen from above, so the chain of the wedge that begins at a
  // ray arrives along the ray. If the lower end is on, that chain leaves.
  void set_ray(uint32_t ray, Pass& ending, Pass& beginning) const {
    const uint32_t quadrant = ray / 8;
    const bool is_spoke = (ray & 4) != 0;
    uint32_t to, from;
    if (is_spoke) {
      const uint32_t edge_pair = sector_table.edges[lower_is_on_][cell(quadrant) >> 8 & 15];
      to = edge_pair & 15;
      from = edge_pair >> 4;
    } else {
      to = from = sector_table.face_way[lower_is_on_][lines_ >> 4 * quadrant & 3];
    }
    Pass& arriving = lower_is_on_ != 0 ? ending : beginning;
    Pass& leaving = lower_is_on_ != 0 ? beginning : ending;
    const Way out = axis_.way[quadrant][to], in = axis_.way[quadrant][from];
    leaving.outgoing = is_spoke ? axis_.inwards[quadrant] : out.link();
    leaving.after_centroid = out.link();
    leaving.out_queue = out.queue_out();
    leaving.flags = static_cast<uint8_t>((is_spoke ? Pass::by_centroid : 0) |
                                         (out.is_ahead() ? Pass::ahead : 0));
    arriving.incoming = opposite_link(leaving.outgoing);
    arriving.in_queue = in.queue_in();
    arriving.comes_from_ahead = in.is_ahead();
  }

 private:
  void remove(uint32_t absent) {
    for (uint32_t quadrant = 0; quadrant < quadrants; ++quadrant) {
      if ((absent >> quadrant & 1) == 0) continue;
      headings_ |= uint32_t{0xFF} << 8 * quadrant;
      parts_ -= sector_table.part[cell(quadrant) >> 12];
    }
  }
  uint32_t cell(uint32_t quadrant) const { return sector_table.cell[lines_ >> 4 * quadrant & 63]; }

  const AxisTable& axis_;
  uint32_t lower_is_on_;
  // The circle of lines, mirrored if the lower end is on. Repeated, so that one shift also finds
  // the lines 6, 7 and 0 of quadrant 3.
  uint32_t lines_;
  uint32_t headings_ = 0;
  uint32_t parts_ = 0;
};

// Removes the wedges of absent cells.
DISCMC_ALWAYS_INLINE void remove_absent(PassList& passes) {
  uint8_t count = 0;
  for (uint32_t i = 0; i < passes.count; ++i)
    if (passes.pass[i].incidence != no_incidence) passes.pass[count++] = passes.pass[i];
  passes.count = count;
}

template <bool is_lean, class Edge>
DISCMC_ALWAYS_INLINE void find_passes(const Edge& edge, uint32_t absent, PassList& passes) {
  const Surroundings<is_lean> around(edge, absent);
  passes.parts = around.parts();
  passes.count = 0;
  const uint32_t rays = around.rays();
  if (rays == 0) return;
  // Starts at the second ray and ends with the first, so that the first wedge begins at the first
  // ray.
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
  if (!is_lean && absent != 0) remove_absent(passes);
}

}  // namespace

template <bool is_lean>
void derive_passes(const RowEdge& edge, uint32_t absent, PassList& passes) {
  find_passes<is_lean>(edge, absent, passes);
}

template void derive_passes<false>(const RowEdge&, uint32_t, PassList&);
template void derive_passes<true>(const RowEdge&, uint32_t, PassList&);

void derive_passes(const EdgeLines& edge, uint32_t absent, PassList& passes) {
  find_passes<false>(edge, absent, passes);
}

}  // namespace discmc::detail::trace
