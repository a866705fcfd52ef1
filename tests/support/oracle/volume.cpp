#include "volume.hpp"

#include "shapes/combs.hpp"
#include "shapes/tilings.hpp"

namespace discmc::reference {

namespace {

int64_t square(int64_t value) {
  return value * value;
}

}  // namespace

BitVolume ball(Size size, Vertex centre, int64_t radius_squared) {
  return volume_of(size, [&](int64_t x, int64_t y, int64_t z) {
    const int64_t distance =
        square(2 * x - centre.x) + square(2 * y - centre.y) + square(2 * z - centre.z);
    return distance <= 4 * radius_squared;
  });
}

BitVolume box(Size size, Vertex first, Vertex last) {
  return volume_of(size, [&](int64_t x, int64_t y, int64_t z) {
    return x >= first.x && x <= last.x && y >= first.y && y <= last.y && z >= first.z &&
           z <= last.z;
  });
}

BitVolume torus(Size size, int64_t ring_radius, int64_t tube_radius) {
  return volume_of(size, [&](int64_t x, int64_t y, int64_t z) {
    const int64_t from_axis =
        square(2 * x + 1 - int64_t{size.width}) + square(2 * y + 1 - int64_t{size.height});
    const int64_t from_plane = square(2 * z + 1 - int64_t{size.depth});
    const int64_t sum = from_axis + from_plane + square(ring_radius) - square(tube_radius);
    return sum <= 0 || square(sum) <= 4 * square(ring_radius) * from_axis;
  });
}

BitVolume checkerboard(Size size) {
  return volume_of(size, [](int64_t x, int64_t y, int64_t z) { return (x + y + z) % 2 == 0; });
}

BitVolume columns(Size size) {
  return volume_of(size, [](int64_t x, int64_t y, int64_t) { return (x + y) % 2 == 0; });
}

BitVolume tiling(Size size, Configuration configuration) {
  return volume_of(size, shapes::Tiling{configuration});
}

BitVolume random(Size size, uint32_t density, uint64_t seed) {
  uint64_t state = seed;
  return volume_of(size,
                   [&](int64_t, int64_t, int64_t) { return next_random(state) >> 56 < density; });
}

BitVolume comb(Size size) {
  return volume_of(size, shapes::Comb{2, 1, size.height - 1});
}

BitVolume spiral(Size size) {
  BitVolume slice({(size.width + 1) / 2, (size.height + 1) / 2, 1});
  int64_t x = 0;
  int64_t y = 0;
  int64_t step_x = 1;
  int64_t step_y = 0;
  const auto is_free = [&] {
    return slice.contains(x + step_x, y + step_y, 0) &&
           !slice.at(x + 2 * step_x, y + 2 * step_y, 0);
  };
  slice.on[0] = 1;
  // After a leg of one step, the next leg would touch the wall.
  for (int steps = 2; steps >= 2;) {
    for (steps = 0; is_free(); ++steps) {
      x += step_x;
      y += step_y;
      slice.on[slice.index(x, y, 0)] = 1;
    }
    const int64_t previous_x = step_x;
    step_x = -step_y;
    step_y = previous_x;
  }
  return volume_of(size, [&](int64_t i, int64_t j, int64_t) { return slice.at(i / 2, j / 2, 0); });
}

BitVolume from_bits(Size size, uint64_t bits) {
  return volume_of(size, [&](int64_t, int64_t, int64_t) {
    const bool is_on = (bits & 1) != 0;
    bits >>= 1;
    return is_on;
  });
}

}  // namespace discmc::reference
