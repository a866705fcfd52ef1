// The 48 ways to map a cell onto itself, for statements that hold for turned and mirrored cells.
#pragma once

#include <algorithm>
#include <array>
#include <discmc/geometry/cell.hpp>
#include <vector>

namespace discmc::test {

/// A permutation of the axes, then reflections.
struct CellSymmetry {
  std::array<int, 3> axis;
  int reflected;  ///< bit i: the coordinate of axis i runs backwards

  /// A mirror image reverses every ring; a rotation does not.
  bool is_mirror() const {
    const bool is_odd = (axis[1] - axis[0] + 3) % 3 != 1;
    const int reflections = (reflected & 1) + (reflected >> 1 & 1) + (reflected >> 2);
    return is_odd != (reflections % 2 == 1);
  }

  /// Maps a vector, which has no position.
  Vertex vector(const Vertex& v) const {
    const std::array<int32_t, 3> from{v.x, v.y, v.z};
    std::array<int32_t, 3> to{};
    for (size_t i = 0; i < 3; ++i) {
      const int32_t value = from[static_cast<size_t>(axis[i])];
      to[i] = (reflected >> i & 1) != 0 ? -value : value;
    }
    return {to[0], to[1], to[2]};
  }

  CellPoint point(CellPoint p) const {
    constexpr Vertex middle{1, 1, 1};
    return point_at(vector(position(p) - middle) + middle);
  }

  Configuration configuration(Configuration c) const {
    unsigned bits = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vertex there = position(point(point_at(detail::derive::corner_position(corner))));
      const int number = (there.x + 2 * there.y + 4 * there.z) / 2;
      bits |= static_cast<unsigned>(c >> corner & 1) << number;
    }
    return static_cast<Configuration>(bits);
  }
};

inline std::vector<CellSymmetry> cell_symmetries() {
  std::vector<CellSymmetry> symmetries;
  std::array<int, 3> axis{0, 1, 2};
  do {
    for (int reflected = 0; reflected < 8; ++reflected) symmetries.push_back({axis, reflected});
  } while (std::next_permutation(axis.begin(), axis.end()));
  return symmetries;
}

}  // namespace discmc::test
