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
  CHECK(again.bounds.links == cell_bounds.links);
  CHECK(again.one_patch_an_incidence);
  CHECK(again.one_fan_a_cell);
}

}  // namespace
}  // namespace discmc
