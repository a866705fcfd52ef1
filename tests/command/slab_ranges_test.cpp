// The range of slices of a volume whose slabs come from several streams.
#include "streams/slab_ranges.hpp"

#include "test.hpp"

namespace {

using discmc::SlabRange;
using discmc::command::SlabRanges;

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;  // first, end

Pairs pairs(const std::vector<SlabRange>& ranges) {
  Pairs pairs;
  for (const SlabRange& range : ranges) pairs.emplace_back(range.first, range.end());
  return pairs;
}

}  // namespace

TEST_CASE("slabs in any order complete the volume, and missing slices are listed until then") {
  const SlabRange slabs[] = {{0, 3, 10}, {3, 1, 10}, {4, 4, 10}, {8, 2, 10}};
  int order[] = {0, 1, 2, 3};
  do {
    SlabRanges ranges;
    CHECK(ranges.missing().empty());  // unknown
    std::vector<bool> is_there(10, false);
    for (const int each : order) {
      CHECK_FALSE(ranges.add(slabs[each]));
      std::fill_n(is_there.begin() + slabs[each].first, slabs[each].slices, true);
      std::vector<bool> is_covered(10, false), missing(10, true);
      for (const auto& [first, end] : pairs(ranges.ranges()))
        std::fill(is_covered.begin() + first, is_covered.begin() + end, true);
      for (const auto& [first, end] : pairs(ranges.missing()))
        std::fill(missing.begin() + first, missing.begin() + end, false);
      CHECK(is_covered == is_there);
      CHECK(missing == is_there);
    }
    CHECK(pairs(ranges.ranges()) == Pairs{{0, 10}});
    CHECK(ranges.missing().empty());
  } while (std::next_permutation(order, order + 4));
}

TEST_CASE("repeated slices are reported and not added") {
  SlabRanges ranges;
  ranges.add({2, 4, 10});
  for (const auto& [range, twice] : {std::pair{SlabRange{0, 3, 10}, std::pair{2U, 3U}},
                                     {{5, 5, 10}, {5, 6}},
                                     {{0, 10, 10}, {2, 6}},
                                     {{3, 1, 10}, {3, 4}},
                                     {{2, 4, 10}, {2, 6}}}) {
    const auto is_covered = ranges.add(range);
    REQUIRE(is_covered);
    CHECK(std::pair{is_covered->first, is_covered->end()} == twice);
  }
  CHECK(pairs(ranges.ranges()) == Pairs{{2, 6}});
  CHECK(discmc::command::text(ranges.missing()) == "slices 0 to 1 and 6 to 9");
}
