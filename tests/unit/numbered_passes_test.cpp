// Passes by number: there is room for all that exist, and a number says what its pass does.
#include <doctest/doctest.h>

#include <discmc/trace/numbered_passes.hpp>

#include <algorithm>
#include <memory>

#include "oracle/neighbourhoods.hpp"

using namespace discmc;
using namespace discmc::reference;
using trace::CornerPass;
using trace::NumberedPass;
using trace::NumberedPasses;

namespace {

void check_numbered(const NumberedPasses& passes, NumberedPasses::Numbers numbers,
                    const trace::Pass& pass, int axis) {
  CornerPass made[CornerPass::most_of_pass];
  const uint32_t count = trace::corner_passes(pass, axis, made);
  if (numbers.count != count) FAIL("corner passes");
  const uint64_t voxel = trace::CornerCode::position({40, 50, 60});
  for (uint32_t i = 0; i < count; ++i) {
    const trace::FoundPass found = voxel + numbers.first + i;
    const NumberedPass& numbered = passes[found];
    const uint64_t corner = voxel + trace::corner_places.of[made[i].place] + made[i].sides;
    const bool is_straight = made[i].kind == CornerPass::straight;
    const bool is_join = made[i].kind == CornerPass::join;
    if (found + numbered.to_corner != corner || numbered.in != made[i].in ||
        numbered.out != made[i].out || numbered.if_straight != (is_straight ? -1 : 0) ||
        numbered.joins != (is_join ? 1 : 0))
      FAIL("number ", numbers.first + i);
  }
}

}  // namespace

TEST_CASE("all passes that exist have numbers, wherever cells are absent, and keep them") {
  const auto passes = std::make_unique<NumberedPasses>();
  uint32_t numbers_in_use = 0;
  const auto number_all = [&](uint32_t absent, bool is_known) {
    for (int axis = 0; axis < 3; ++axis)
      for_each_neighbourhood(
          axis,
          [&](const trace::PassList& list) {
            for (uint32_t i = 0; i < list.count; ++i) {
              const NumberedPasses::Numbers numbers = passes->of(list.pass[i], axis);
              const auto end = static_cast<uint32_t>(numbers.first + numbers.count);
              if (is_known || end > numbers_in_use)
                check_numbered(*passes, numbers, list.pass[i], axis);
              numbers_in_use = std::max(numbers_in_use, end);
            }
          },
          absent);
  };
  constexpr uint32_t all_absent = 15;
  for (uint32_t absent = 0; absent < all_absent; ++absent) number_all(absent, false);
  CHECK(numbers_in_use == NumberedPasses::most);
  number_all(0, true);
  CHECK(numbers_in_use == NumberedPasses::most);
}
