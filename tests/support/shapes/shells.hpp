// Shells within shells: boxes, octahedra or balls, alone or repeated.
#pragma once

#include <algorithm>
#include <cstdint>

namespace discmc::shapes {

struct Shells {
  enum class Norm : uint8_t { box, octahedron, ball };

  Norm norm;
  uint32_t cell;       ///< voxels per nest, along each axis
  uint32_t period;     ///< voxels between shells; for balls, square voxels
  uint32_t thickness;  ///< Limit: less than the period

  bool operator()(uint32_t x, uint32_t y, uint32_t z) const {
    return distance(from_centre(x), from_centre(y), from_centre(z)) % period < thickness;
  }

 private:
  uint32_t from_centre(uint32_t at) const {
    const uint32_t place = at % cell, centre = cell / 2;
    return place < centre ? centre - place : place - centre;
  }
  uint32_t distance(uint32_t x, uint32_t y, uint32_t z) const {
    if (norm == Norm::box) return std::max({x, y, z});
    return norm == Norm::octahedron ? x + y + z : x * x + y * y + z * z;
  }
};

}  // namespace discmc::shapes
