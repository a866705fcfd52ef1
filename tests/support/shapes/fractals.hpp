// Fractals: boundaries of every size, and holes in holes.
#pragma once

#include <cstdint>

namespace discmc::shapes {

struct Fractal {
  enum class Kind : uint8_t {
    menger,      ///< sponge: no voxel has a middle digit of base 3 along two axes
    cantor,      ///< dust: no voxel has a middle digit along any axis
    sierpinski,  ///< tetrahedron: no two coordinates share a bit
  };

  Kind kind;

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    if (kind == Kind::sierpinski) return ((x & y) | (y & z) | (x & z)) == 0;
    const uint32_t max_middles = kind == Kind::menger ? 1 : 0;
    for (; (x | y | z) != 0; x /= 3, y /= 3, z /= 3)
      if (is_middle(x) + is_middle(y) + is_middle(z) > max_middles) return false;
    return true;
  }

 private:
  static uint32_t is_middle(uint32_t place) { return place % 3 == 1 ? 1 : 0; }
};

}  // namespace discmc::shapes
