// Fragments are sent loose as late as possible, so that many regions stay whole.
#include <discmc/trace/fragments.hpp>

#include "oracle/scan.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

Statistics scanned(const BitVolume& volume, uint32_t slots) {
  Collector collector;
  scan_into<uint16_t>(collector, volume, {}, Capacities{slots, slots});
  return collector.statistics();
}

}  // namespace

TEST_CASE("a side is full if its ends are at least 4,080 places apart, in either order") {
  constexpr detail::trace::Place places = 1U << detail::trace::place_bits;
  for (const detail::trace::Place from : {0U, 5U, 4100U, 8191U})
    for (detail::trace::Place distance = 0; distance < 4100; ++distance) {
      const detail::trace::Place to = (from + distance) % places;
      if (detail::trace::is_full_side(from, to) != (distance >= 4080)) FAIL(distance);
      if (detail::trace::is_full_side(to, from) != (distance >= 4080)) FAIL(distance);
    }
}

TEST_CASE("a ring of any length stays whole if a thousand slots are free") {
  CHECK(scanned(spiral({200, 200, 1}), 2700).fragments == 0);
  CHECK(scanned(spiral({120, 120, 1}), 1778).fragments == 0);
  CHECK(scanned(spiral({120, 120, 1}), 1777).fragments > 0);
}

TEST_CASE("each number of slots yields the recorded numbers of regions and fragments") {
  struct Known {
    uint32_t slots;
    uint64_t regions, fragments;
  };
  const auto check = [](const BitVolume& volume, const std::vector<Known>& all) {
    for (const Known& known : all) {
      CAPTURE(known.slots);
      const Statistics statistics = scanned(volume, known.slots);
      CHECK(statistics.regions == known.regions);
      CHECK(statistics.fragments == known.fragments);
    }
  };
  check(random({12, 12, 6}, 40, 1),
        {{10, 0, 2748}, {18, 0, 2618}, {52, 50, 1871}, {134, 448, 786}, {216, 584, 491}});
  check(random({9, 9, 6}, 128, 2),
        {{10, 0, 2785}, {18, 0, 2640}, {52, 43, 1937}, {134, 266, 996}, {300, 411, 590}});
  check(random({20, 20, 4}, 100, 3),
        {{18, 3, 8652}, {52, 36, 7293}, {134, 790, 3248}, {400, 1103, 2401}});
  check(ball({14, 14, 14}, {13, 13, 13}, 36), {{10, 0, 772}, {52, 3, 355}, {134, 43, 173}});
}
