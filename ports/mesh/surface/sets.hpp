// Disjoint sets of numbers, which find connected polygons or pieces.
#ifndef DISCMC_MESH_SURFACE_SETS_HPP
#define DISCMC_MESH_SURFACE_SETS_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace discmc::meshing {

/// Sets of the numbers from 0, at first one number each. The root of a set is its lowest number.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  /// Returns the root of the set of a number.
  std::uint32_t root(std::uint32_t number) {
    while (parent_[number] != number) {
      parent_[number] = parent_[parent_[number]];
      number = parent_[number];
    }
    return number;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = root(a);
    const std::uint32_t second = root(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace discmc::meshing

#endif
