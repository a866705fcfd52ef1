// Limits: impossible ones are refused.
#include <discmc/limits.hpp>

#include "test.hpp"

using namespace discmc;

static_assert(!Limits{0, 1}.is_valid() && !Limits{1, 0}.is_valid() &&
                  !Limits{Limits::max_extent + 1, 1}.is_valid() &&
                  !Limits{1, Limits::max_extent + 1}.is_valid() &&
                  Limits{Limits::max_extent, Limits::max_extent}.is_valid(),
              "extents are 1 to 32766");
static_assert(!Limits{1, 1, static_cast<Border>(2)}.is_valid(), "a border is closed or open");

TEST_CASE("limits of a slab are valid if only a slab above another slab has a first slice") {
  const auto is_valid = [](const Slab& slab) { return Limits{4, 4, {}, slab}.is_valid(); };
  CHECK(is_valid({}));
  CHECK(is_valid({0, false, true}));
  CHECK(is_valid({1, true, false}));
  CHECK(is_valid({Limits::max_slices - 1, true, true}));
  CHECK_FALSE(is_valid({0, true, false}));
  CHECK_FALSE(is_valid({1, false, false}));
  CHECK_FALSE(is_valid({Limits::max_slices, true, true}));
}
