#include "proofs/doubling/families.hpp"

#include <algorithm>

namespace discmc::doubling {

namespace {

using namespace reference;

// Holes of 6 x 6 voxels with a period of 8; optionally an island in each.
bool is_plate(uint32_t n, uint32_t x, uint32_t y, bool has_islands) {
  const auto is_rim = [n](uint32_t at) { return at == 0 || at + 1 == n; };
  const auto is_middle = [](uint32_t at) { return at % 8 / 2 == 1; };
  const bool is_hole = x % 8 < 6 && y % 8 < 6;
  return !is_hole || is_rim(x) || is_rim(y) || (has_islands && is_middle(x) && is_middle(y));
}
uint32_t from_rim(uint32_t n, uint32_t x, uint32_t y) {
  return std::min({x, y, n - 1 - x, n - 1 - y});
}

template <bool has_islands>
BitVolume plate(uint32_t n) {
  return volume_of({n, n, 1}, [n](auto x, auto y, auto) { return is_plate(n, x, y, has_islands); });
}
template <BitVolume (*make)(Size), uint32_t depth>
BitVolume square(uint32_t n) {
  return make({n, n, depth});
}
template <uint32_t depth, uint32_t density, uint64_t seed>
BitVolume square_noise(uint32_t n) {
  return random({n, n, depth}, density, seed);
}

}  // namespace

const Family families[] = {
    {"ball", 64,
     [](uint32_t n) {
       const int32_t centre = static_cast<int32_t>(n) - 1;
       const int64_t radius = n / 2 - 1;
       return ball({n, n, n}, {centre, centre, centre}, radius * radius);
     }},
    {"plate with holes", 256, plate<false>},
    {"plate with islands", 256, plate<true>},
    // The same holes on every second slice: as many planes as holes per row.
    {"many plates with islands", 64,
     [](uint32_t n) {
       return volume_of({n, n, n / 8}, [n](auto x, auto y, auto z) {
         return z % 2 == 0 && is_plate(n, x, y, true);
       });
     }},
    {"nested rings", 128,
     [](uint32_t n) {
       return volume_of({n, n, 1}, [n](auto x, auto y, auto) { return from_rim(n, x, y) % 4 < 2; });
     }},
    {"bodies on a plane", 96,
     [](uint32_t n) {
       return volume_of({n, n, 3}, [](auto x, auto y, auto) { return x % 4 < 2 && y % 4 < 2; });
     }},
    {"cavities", 96,
     [](uint32_t n) {
       return volume_of(
           {n, n, 4}, [](auto x, auto y, auto z) { return x % 4 > 1 || y % 4 > 1 || z % 3 == 0; });
     }},
    {"comb", 128, square<comb, 2>},
    // Teeth that point up and down alternately, joined at the first and the last row.
    {"meander", 128,
     [](uint32_t n) {
       return volume_of({n, n, 2}, [n](auto x, auto y, auto) {
         return x % 2 == 0 || (x % 4 == 1 ? y == 0 : y + 1 == n);
       });
     }},
    {"spiral", 128, square<spiral, 3>},
    {"walls", 128,
     [](uint32_t n) {
       return volume_of({n, n, 8}, [](auto x, auto, auto) { return x % 4 < 2; });
     }},
    {"bars", 96,
     [](uint32_t n) {
       return volume_of({n, n, 8}, [](auto x, auto y, auto z) {
         return (x % 8 < 2 && z % 4 < 2) || (y % 8 < 2 && z % 4 > 1);
       });
     }},
    {"tents", 128,
     [](uint32_t n) {
       return volume_of({n, n / 4, n / 4}, [n](auto x, auto y, auto z) {
         const uint32_t slope = (x < n / 2 ? n / 2 - x : x - n / 2) + z;
         return slope % 6 < 3 && y > 0;
       });
     }},
    {"saw", 96,
     [](uint32_t n) {
       return volume_of({n, n, 4}, [](auto x, auto y, auto z) { return (x + y * 3 + z) % 8 < 4; });
     }},
    {"stripes", 96,
     [](uint32_t n) {
       return volume_of({n, n, 4},
                        [](auto x, auto y, auto z) { return (7 * x + 3 * y + z) % 31 < 15; });
     }},
    {"nested shells", 48,
     [](uint32_t n) {
       return volume_of({n, n, n}, [n](auto x, auto y, auto z) {
         return std::min(from_rim(n, x, y), std::min(z, n - 1 - z)) % 4 < 2;
       });
     }},
    {"sponge", 32,
     [](uint32_t n) {
       return volume_of({n, n, n},
                        [](auto x, auto y, auto z) { return ((x & y) | (y & z) | (z & x)) == 0; });
     }},
    {"long columns", 512,
     [](uint32_t n) {
       return volume_of({32, 32, n}, [](auto x, auto y, auto) { return x % 4 < 2 && y % 4 < 2; });
     }},
    {"ragged columns", 512,
     [](uint32_t n) {
       return volume_of({32, 32, n},
                        [](auto x, auto y, auto z) { return x % 8 < 4 + z % 2 && y % 8 < 4; });
     }},
    {"long rows", 1024,
     [](uint32_t n) {
       return volume_of({n, 32, 8}, [](auto, auto y, auto z) { return y % 4 < 2 && z % 4 < 2; });
     }},
    // One side across all slices.
    {"slope", 512,
     [](uint32_t n) {
       return volume_of({n, 2, n}, [](auto x, auto, auto z) { return x >= z && x < z + 10; });
     }},
    // The last slice joins all fragments.
    {"roof", 96,
     [](uint32_t n) {
       return volume_of({n, n, 6},
                        [](auto x, auto y, auto z) { return z > 3 || (x % 4 < 2 && y % 4 < 2); });
     }},
    {"checkerboard", 48, square<checkerboard, 4>},
    {"columns", 48, square<columns, 8>},
    {"tiling 61", 48, square<tiling_61, 4>},
    {"noise", 48, square_noise<4, 128, 1>},
    {"sparse noise", 64, square_noise<8, 25, 2>},
    {"dense noise", 64, square_noise<8, 230, 3>},
    // Larger than the others: while few holes wait, the logarithm of their number grows fast.
    {"noise on a plane", 192, square_noise<1, 170, 4>},
};
const size_t family_count = sizeof families / sizeof families[0];

}  // namespace discmc::doubling
