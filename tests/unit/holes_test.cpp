// Holes go to the ring around them, in planes of every direction; where there is none, they go out.
#include <doctest/doctest.h>

#include <string>

#include "oracle/agreement.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr uint32_t side = 11;

// What lies on one side of a plane with a normal, or on the other, but for some voxels: so the
// plane has rings and holes of many shapes, these within holes, and many a ring beside others.
BitVolume half_space(const Vertex& n, bool is_upper, uint32_t noise, uint64_t seed) {
  const Size size{side, side, side};
  BitVolume volume = random(size, noise, seed);
  constexpr int32_t middle = side / 2;
  for (int32_t z = 0; z < static_cast<int32_t>(side); ++z)
    for (int32_t y = 0; y < static_cast<int32_t>(side); ++y)
      for (int32_t x = 0; x < static_cast<int32_t>(side); ++x) {
        const int32_t offset = n.x * (x - middle) + n.y * (y - middle) + n.z * (z - middle);
        uint8_t& on = volume.on[volume.index(x, y, z)];
        if ((offset > 0) == is_upper) on ^= 1;
      }
  return volume;
}

}  // namespace

TEST_CASE("in planes of every direction a hole goes to the ring around it") {
  uint64_t holes = 0;
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    if (incidence == no_incidence) continue;
    for (const uint32_t noise : {10U, 40U}) {
      const BitVolume volume = half_space(normal(incidence), true, noise, incidence);
      const Collector swept = scan<uint16_t>(volume);
      CAPTURE(incidence);
      CHECK(unlike_merge(swept.regions(), volume, true) == "");
      holes += swept.statistics().rings - swept.statistics().regions;
    }
  }
  CHECK(holes > 200);
}
