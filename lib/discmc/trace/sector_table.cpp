#include <discmc/trace/sector_derivation.hpp>

namespace discmc::trace {

namespace {

constexpr SectorTable derived = derive::sector_table();

// Every queue is that of the chains that go along a way, from the one end or the other.
constexpr bool queues_are_all_used() {
  bool is_used[queue_count] = {};
  for (const AxisTable& axis : derived.axis)
    for (const auto& of_quadrant : axis.way)
      for (const Way& way : of_quadrant) is_used[way.queue_out()] = true;
  for (const bool used : is_used)
    if (!used) return false;
  return true;
}

static_assert(queues_are_all_used(),
              "18 kinds of links on faces both ways, and 108 ways by a centroid");

}  // namespace

const SectorTable sector_table = derived;

}  // namespace discmc::trace
