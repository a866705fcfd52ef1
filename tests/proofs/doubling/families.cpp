#include "proofs/doubling/families.hpp"

#include <algorithm>

namespace discmc::doubling {

namespace {

using reference::BitVolume;
using reference::Size;

// On where is_on(x, y, z).
template <class IsOn>
BitVolume volume_of(Size size, IsOn is_on) {
  BitVolume volume(size);
  auto voxel = volume.on.begin();
  for (uint32_t z = 0; z < size.depth; ++z)
    for (uint32_t y = 0; y < size.height; ++y)
      for (uint32_t x = 0; x < size.width; ++x) *voxel++ = is_on(x, y, z) ? 1 : 0;
  return volume;
}

BitVolume ball(uint32_t n) {
  const int32_t centre = static_cast<int32_t>(n) - 1;
  const int64_t radius = n / 2 - 1;
  return reference::ball({n, n, n}, {centre, centre, centre}, radius * radius);
}

// ---- one plane ----

// Holes of 6 x 6 voxels, a period of 8; perhaps an island in each.
bool is_plate(uint32_t n, uint32_t x, uint32_t y, bool has_islands) {
  const auto is_rim = [n](uint32_t at) { return at == 0 || at + 1 == n; };
  const auto is_middle = [](uint32_t at) { return at % 8 / 2 == 1; };
  const bool is_hole = x % 8 < 6 && y % 8 < 6;
  return !is_hole || is_rim(x) || is_rim(y) || (has_islands && is_middle(x) && is_middle(y));
}
BitVolume holes(uint32_t n) {
  return volume_of({n, n, 1}, [n](auto x, auto y, auto) { return is_plate(n, x, y, false); });
}
BitVolume islands(uint32_t n) {
  return volume_of({n, n, 1}, [n](auto x, auto y, auto) { return is_plate(n, x, y, true); });
}
// The same on every second slice: as many planes as holes in a row.
BitVolume stacked_islands(uint32_t n) {
  return volume_of({n, n, n / 8},
                   [n](auto x, auto y, auto z) { return z % 2 == 0 && is_plate(n, x, y, true); });
}
uint32_t from_rim(uint32_t n, uint32_t x, uint32_t y) {
  return std::min({x, y, n - 1 - x, n - 1 - y});
}
BitVolume nested_rings(uint32_t n) {
  return volume_of({n, n, 1}, [n](auto x, auto y, auto) { return from_rim(n, x, y) % 4 < 2; });
}
BitVolume bodies(uint32_t n) {
  return volume_of({n, n, 3}, [](auto x, auto y, auto) { return x % 4 < 2 && y % 4 < 2; });
}
BitVolume cavities(uint32_t n) {
  return volume_of({n, n, 4},
                   [](auto x, auto y, auto z) { return x % 4 > 1 || y % 4 > 1 || z % 3 == 0; });
}
BitVolume comb(uint32_t n) {
  return reference::comb({n, n, 2});
}
// Teeth that point up and down by turns, joined at the last row and at the first.
BitVolume meander(uint32_t n) {
  return volume_of({n, n, 2}, [n](auto x, auto y, auto) {
    return x % 2 == 0 || (x % 4 == 1 ? y == 0 : y + 1 == n);
  });
}
BitVolume spiral(uint32_t n) {
  return reference::spiral({n, n, 3});
}

// ---- walls, bars, tents ----

BitVolume walls(uint32_t n) {
  return volume_of({n, n, 8}, [](auto x, auto, auto) { return x % 4 < 2; });
}
BitVolume bars(uint32_t n) {
  return volume_of({n, n, 8}, [](auto x, auto y, auto z) {
    return (x % 8 < 2 && z % 4 < 2) || (y % 8 < 2 && z % 4 > 1);
  });
}
BitVolume tents(uint32_t n) {
  return volume_of({n, n / 4, n / 4}, [n](auto x, auto y, auto z) {
    const uint32_t slope = (x < n / 2 ? n / 2 - x : x - n / 2) + z;
    return slope % 6 < 3 && y > 0;
  });
}
BitVolume saw(uint32_t n) {
  return volume_of({n, n, 4}, [](auto x, auto y, auto z) { return (x + y * 3 + z) % 8 < 4; });
}
BitVolume stripes(uint32_t n) {
  return volume_of({n, n, 4}, [](auto x, auto y, auto z) { return (7 * x + 3 * y + z) % 31 < 15; });
}

// ---- through space ----

BitVolume nested_shells(uint32_t n) {
  return volume_of({n, n, n}, [n](auto x, auto y, auto z) {
    return std::min(from_rim(n, x, y), std::min(z, n - 1 - z)) % 4 < 2;
  });
}
BitVolume sponge(uint32_t n) {
  return volume_of({n, n, n},
                   [](auto x, auto y, auto z) { return ((x & y) | (y & z) | (z & x)) == 0; });
}
BitVolume long_columns(uint32_t n) {
  return volume_of({32, 32, n}, [](auto x, auto y, auto) { return x % 4 < 2 && y % 4 < 2; });
}
BitVolume ragged_columns(uint32_t n) {
  return volume_of({32, 32, n},
                   [](auto x, auto y, auto z) { return x % 8 < 4 + z % 2 && y % 8 < 4; });
}
BitVolume long_rows(uint32_t n) {
  return volume_of({n, 32, 8}, [](auto, auto y, auto z) { return y % 4 < 2 && z % 4 < 2; });
}
// One side across all slices.
BitVolume slope(uint32_t n) {
  return volume_of({n, 2, n}, [](auto x, auto, auto z) { return x >= z && x < z + 10; });
}
// The last slice joins all fragments.
BitVolume roof(uint32_t n) {
  return volume_of({n, n, 6},
                   [](auto x, auto y, auto z) { return z > 3 || (x % 4 < 2 && y % 4 < 2); });
}

// ---- as many vertices as there can be ----

BitVolume checkerboard(uint32_t n) {
  return reference::checkerboard({n, n, 4});
}
BitVolume columns(uint32_t n) {
  return reference::columns({n, n, 8});
}
BitVolume tiling(uint32_t n) {
  return reference::tiling_61({n, n, 4});
}
BitVolume noise(uint32_t n) {
  return reference::random({n, n, 4}, 128, 1);
}
BitVolume sparse_noise(uint32_t n) {
  return reference::random({n, n, 8}, 25, 2);
}
BitVolume dense_noise(uint32_t n) {
  return reference::random({n, n, 8}, 230, 3);
}
BitVolume noise_on_a_plane(uint32_t n) {
  return reference::random({n, n, 1}, 170, 4);
}

}  // namespace

const Family families[] = {{"ball", ball, 64},
                           {"plate with holes", holes, 256},
                           {"plate with islands", islands, 256},
                           {"many plates with islands", stacked_islands, 64},
                           {"nested rings", nested_rings, 128},
                           {"bodies on a plane", bodies, 96},
                           {"cavities", cavities, 96},
                           {"comb", comb, 128},
                           {"meander", meander, 128},
                           {"spiral", spiral, 128},
                           {"walls", walls, 128},
                           {"bars", bars, 96},
                           {"tents", tents, 128},
                           {"saw", saw, 96},
                           {"stripes", stripes, 96},
                           {"nested shells", nested_shells, 48},
                           {"sponge", sponge, 32},
                           {"long columns", long_columns, 512},
                           {"ragged columns", ragged_columns, 512},
                           {"long rows", long_rows, 1024},
                           {"slope", slope, 512},
                           {"roof", roof, 96},
                           {"checkerboard", checkerboard, 48},
                           {"columns", columns, 48},
                           {"tiling 61", tiling, 48},
                           {"noise", noise, 48},
                           {"sparse noise", sparse_noise, 64},
                           {"dense noise", dense_noise, 64},
                           {"noise on a plane", noise_on_a_plane, 96}};
const size_t family_count = sizeof families / sizeof families[0];

}  // namespace discmc::doubling
