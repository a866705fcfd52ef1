// The derivation of the patch table, which the compiler does, done once more at run time: so it is
// the same wherever it is done, and the coverage of its source can be told.
//
// The source is compiled in here; the library's object of it is then not linked.
#include <discmc/patch_table.cpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>

namespace discmc {
namespace {

TEST_CASE("the patch table is the same when it is derived at run time") {
  Derived again{};
  again = derive_all();  // what is initialised the compiler would work out
  const auto are_equal = [](const auto& a, const auto& b) {
    return std::equal(std::begin(a), std::end(a), std::begin(b));
  };
  CHECK(are_equal(again.table.block, patch_table.block));
  CHECK(are_equal(again.table.within, patch_table.within));
  CHECK(are_equal(again.table.index, patch_table.index));
  CHECK(are_equal(again.table.of_count, patch_table.of_count));
  CHECK(are_equal(again.table.patch, patch_table.patch));
  CHECK(are_equal(again.table.below, patch_table.below));
  CHECK(again.bounds.patches == cell_bounds.patches);
  CHECK(again.bounds.links == cell_bounds.links);
  CHECK(again.bounds.behind_links == cell_bounds.behind_links);
  CHECK(again.bounds.ahead_links == cell_bounds.ahead_links);
  CHECK(again.one_patch_an_incidence);
  CHECK(again.one_fan_a_cell);
}

TEST_CASE("two patches of one incidence in a cell would be noticed") {
  for (int c = 0; c < configurations; ++c) {
    const uint32_t first = patch_table.first(c);
    if (patch_table.first(c + 1) < first + 2) continue;
    Derived altered{};
    altered.table = patch_table;
    altered.one_patch_an_incidence = true;
    measure_cell(altered, c);
    CHECK(altered.one_patch_an_incidence);
    altered.table.index[first + 1] = altered.table.index[first];
    measure_cell(altered, c);
    CHECK_FALSE(altered.one_patch_an_incidence);
  }
}

}  // namespace
}  // namespace discmc
