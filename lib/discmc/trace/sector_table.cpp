#include <discmc/trace/sector_derivation.hpp>

namespace discmc::detail::trace {

namespace {

constexpr SectorTable derived = derive::sector_table();

// Whether chains use every queue, from one end of the link or the other.
constexpr bool are_all_queues_used() {
  bool is_used[queue_count] = {};
  for (const AxisTable& axis : derived.axis)
    for (const auto& ways_of_quadrant : axis.way)
      for (const Way& way : ways_of_quadrant) is_used[way.queue_out()] = true;
  for (const bool is_queue_used : is_used)
    if (!is_queue_used) return false;
  return true;
}

static_assert(are_all_queues_used(),
              "18 kinds of links on faces both ways, and 108 ways by a centroid");

// Whether the fields of a word of counts have room for four cells around a vertex.
constexpr bool has_room_for_parts() {
  for (const uint32_t part : derived.part) {
    constexpr uint32_t facet = CountParts::facet_shift, triangle = CountParts::triangle_shift;
    if (quadrants * (part & ((1U << facet) - 1)) >> facet != 0 ||
        quadrants * (part >> facet & ((1U << (triangle - facet)) - 1)) >> (triangle - facet) != 0 ||
        uint64_t{quadrants} * (part >> triangle) >> (32 - triangle) != 0)
      return false;
  }
  return true;
}
static_assert(has_room_for_parts(), "the parts of four cells fit into a word");

}  // namespace

const SectorTable sector_table = derived;

}  // namespace discmc::detail::trace
