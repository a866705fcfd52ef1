// Passes by number: there is room for all that exist, and a number says what its pass does.
#include <doctest/doctest.h>

#include <discmc/host/numbered_passes.hpp>

#include <algorithm>
#include <memory>

#include "oracle/neighbourhoods.hpp"

using namespace discmc;
using namespace discmc::reference;
using trace::CornerPass;
using trace::NumberedPasses;

namespace {

void check_numbered(const NumberedPasses& passes, NumberedPasses::Numbers numbers,
                    const trace::Pass& pass, int axis) {
  CornerPass made[CornerPass::max_of_pass] = {};
  const uint32_t count = trace::corner_passes(pass, axis, made);
  if (numbers.count != count) FAIL("corner passes");
  const uint64_t voxel = trace::CornerCode::position({40, 50, 60});
  for (uint32_t i = 0; i < count; ++i) {
    const trace::FoundPass found = voxel + numbers.first + i;
    const CornerPass& numbered = passes[found];
    if (found + numbered.corner != voxel + made[i].corner || numbered.in != made[i].in ||
        numbered.out != made[i].out || numbered.if_straight != made[i].if_straight ||
        numbered.joins != made[i].joins)
      FAIL("number ", numbers.first + i);
  }
}

// Numbers all passes of cells of which some are absent, and checks those that it has not seen
// before, or all.
class Numbering {
 public:
  uint32_t in_use() const { return in_use_; }
  void number(uint32_t absent, bool checks_all) {
    for (int axis = 0; axis < 3; ++axis)
      for_each_neighbourhood(
          axis,
          [&](const trace::PassList& list) {
            for (uint32_t i = 0; i < list.count; ++i) {
              const NumberedPasses::Numbers numbers = passes_->of(list.pass[i], axis);
              const auto end = static_cast<uint32_t>(numbers.first + numbers.count);
              if (checks_all || end > in_use_)
                check_numbered(*passes_, numbers, list.pass[i], axis);
              in_use_ = std::max(in_use_, end);
            }
          },
          absent);
  }

 private:
  std::unique_ptr<NumberedPasses> passes_ = std::make_unique<NumberedPasses>();
  uint32_t in_use_ = 0;
};

}  // namespace

TEST_CASE("a number says what its pass does, whenever it comes by") {
  Numbering numbering;
  numbering.number(0, true);
  const uint32_t in_use = numbering.in_use();
  numbering.number(0, true);
  CHECK(numbering.in_use() == in_use);
}

TEST_CASE("all passes that exist have numbers, wherever cells are absent, and keep them") {
  Numbering numbering;
  constexpr uint32_t all_absent = 15;
  for (uint32_t absent = 0; absent < all_absent; ++absent) numbering.number(absent, false);
  CHECK(numbering.in_use() == NumberedPasses::most);
  numbering.number(0, true);
  CHECK(numbering.in_use() == NumberedPasses::most);
}
