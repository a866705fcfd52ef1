#include <discmc/compiler.hpp>
#include <discmc/trace/passes.hpp>

namespace discmc::trace {

namespace {

// What lies around a vertex. Sectors, and rays between them, have a nibble each in words of eight:
// a ray is named by where its nibble begins.
class Surroundings {
 public:
  explicit Surroundings(const EdgePlace& edge)
      : axis_(sector_table.axis[edge.axis]),
        lower_is_on_(edge.lower_is_on() ? 1 : 0),
        lines_(edge.lines() * 0x10001) {}

  // What the sectors head to.
  uint32_t headings() const {
    const uint32_t all = sector(0).headings | uint32_t{sector(1).headings} << 8 |
                         uint32_t{sector(2).headings} << 16 | uint32_t{sector(3).headings} << 24;
    // Turned from quadrant 0 to their own: 2 lines on a quadrant, but for those that head nowhere.
    const uint32_t nowhere = all & 0x88888888;
    return ((all + 0x66442200) & 0x77777777 & ~(nowhere - (nowhere >> 3))) | nowhere;
  }

  uint32_t parts(uint32_t quadrant) const {
    return count_parts.part[count_parts.kind[lower_is_on_][cell_lines(quadrant)]];
  }

  Incidence incidence(uint32_t heading) const {
    return heading > no_heading ? no_incidence : axis_.incidence[lower_is_on_][heading];
  }

  // A ray lies between two wedges: one chain comes along it, and the other goes.
  void set_ray(uint32_t ray, Pass& ending, Pass& beginning) const {
    Pass& comes = lower_is_on_ != 0 ? ending : beginning;
    Pass& goes = lower_is_on_ != 0 ? beginning : ending;
    const uint32_t quadrant = ray / 8;
    const Way* const ways = axis_.way[quadrant];
    goes.has_centroid = (ray & 4) != 0;
    if (goes.has_centroid) {
      const uint32_t edges = sector(quadrant).edges;
      const Link inwards = axis_.inwards[quadrant];
      come(ways[edges >> 4], opposite_link(inwards), comes);
      go(inwards, ways[edges & 15], goes);
    } else {
      const Way way = ways[sector_table.face_way[lower_is_on_][lines_ >> 4 * quadrant & 3]];
      come(way, opposite_link(way.link()), comes);
      go(way.link(), way, goes);
    }
  }

 private:
  uint32_t cell_lines(uint32_t quadrant) const { return lines_ >> 4 * quadrant & 63; }
  const Sector& sector(uint32_t quadrant) const {
    return sector_table.sector[lower_is_on_][cell_lines(quadrant)];
  }
  static void come(Way way, Link link, Pass& pass) {
    pass.came = link;
    pass.in = way.queue_in();
    pass.comes_from_ahead = way.is_ahead();
  }
  static void go(Link first, Way way, Pass& pass) {
    pass.first = first;
    pass.second = way.link();
    pass.out = way.queue_out();
    pass.goes_ahead = way.is_ahead();
  }

  const AxisTable& axis_;
  uint32_t lower_is_on_;
  uint32_t lines_;  // once and once more
};

// A bit for every ray: the lowest of its nibble.
constexpr uint32_t rays_between(uint32_t headings) {
  uint32_t differ = headings ^ (headings << 4 | headings >> 28);
  differ |= differ >> 2;
  differ |= differ >> 1;
  return differ & 0x11111111;
}

// Takes out the wedges where there are no cells.
void remove_absent(PassList& passes) {
  uint8_t count = 0;
  for (uint32_t i = 0; i < passes.count; ++i)
    if (passes.pass[i].incidence != no_incidence) passes.pass[count++] = passes.pass[i];
  passes.count = count;
}

}  // namespace

void derive_passes(const EdgePlace& edge, uint32_t absent, PassList& passes) {
  const Surroundings around(edge);
  uint32_t headings = around.headings();
  passes.parts = around.parts(0) + around.parts(1) + around.parts(2) + around.parts(3);
  for (uint32_t quadrant = 0; absent >> quadrant != 0; ++quadrant) {
    if ((absent >> quadrant & 1) == 0) continue;
    passes.parts -= around.parts(quadrant);
    headings |= uint32_t{0xFF} << 8 * quadrant;
  }
  passes.count = 0;
  const uint32_t rays = rays_between(headings);
  if (rays == 0) return;
  // From the second ray on, and the first one last: so the first wedge begins at the first ray.
  Pass* ending = passes.pass;
  for (uint32_t left = rays;;) {
    left &= left - 1;
    const uint32_t ray = trailing_zeros(left != 0 ? left : rays);
    Pass* const beginning = left != 0 ? ending + 1 : passes.pass;
    beginning->incidence = around.incidence(headings >> ray & 15);
    around.set_ray(ray, *ending, *beginning);
    if (left == 0) break;
    ending = beginning;
  }
  passes.count = static_cast<uint8_t>(ending - passes.pass + 1);
  if (absent != 0) remove_absent(passes);
}

}  // namespace discmc::trace
