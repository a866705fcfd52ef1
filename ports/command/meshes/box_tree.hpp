// Triangles in space, found by where they are.
#ifndef DISCMC_COMMAND_MESHES_BOX_TREE_HPP
#define DISCMC_COMMAND_MESHES_BOX_TREE_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "point.hpp"

namespace discmc::host {

/// Of a triangle.
using Corners = std::array<Point, 3>;

/// A box along the axes; empty at first.
struct Box {
  Box() = default;
  explicit Box(const Corners& triangle) {
    for (const Point& corner : triangle) include(corner);
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void include(const Point& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  void include(const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], box.low[axis]);
      high[axis] = std::max(high[axis], box.high[axis]);
    }
  }
  bool overlaps(const Box& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
  }
  double squared_distance(const Point& point) const;

  Point low{infinity, infinity, infinity};
  Point high{-infinity, -infinity, -infinity};
};

/// A binary tree of boxes around triangles that are near to each other.
/// Memory: 28 bytes a triangle, beside the triangles. Time: n log n to build for n triangles.
class BoxTree {
 public:
  /// Limit: some, and fewer than 2^32. Owner: the caller.
  explicit BoxTree(const std::vector<Corners>& triangles);
  explicit BoxTree(std::vector<Corners>&&) = delete;

  /// The distance of a point from the nearest triangle, or `enough` where it is no more. It takes
  /// less time the nearer the point is to the one before.
  double distance(const Point& point, double enough = 0);

  /// Whether the box of some triangle overlaps this one.
  bool is_near(const Box& box) const;

  /// Calls with the places of two triangles in what was given, once for any two whose boxes
  /// overlap.
  template <class Call>
  void for_each_near_pair(Call call) const {
    std::vector<std::array<std::size_t, 2>> waiting{{1, 1}};  // nodes of the same level
    while (!waiting.empty()) {
      const auto [a, b] = waiting.back();
      waiting.pop_back();
      if (a != b && !boxes_[a].overlaps(boxes_[b])) continue;
      if (a >= leaves_) {
        for_each_pair_of(a - leaves_, b - leaves_, call);
        continue;
      }
      waiting.push_back({2 * a, 2 * b});
      waiting.push_back({2 * a, 2 * b + 1});
      if (a != b) waiting.push_back({2 * a + 1, 2 * b});
      waiting.push_back({2 * a + 1, 2 * b + 1});
    }
  }

 private:
  static constexpr std::size_t leaf_size = 4;

  std::size_t leaf_end(std::size_t leaf) const {
    return std::min((leaf + 1) * leaf_size, places_.size());
  }
  const Corners& triangle(std::size_t i) const { return triangles_[places_[i]]; }

  struct Nearest {
    double squared_distance;
    std::size_t triangle;
  };
  void look_in_leaf(std::size_t leaf, const Point& point, Nearest& nearest) const;

  // Of one leaf, or of two.
  template <class Call>
  void for_each_pair_of(std::size_t a, std::size_t b, Call call) const {
    for (std::size_t i = a * leaf_size; i < leaf_end(a); ++i) {
      const Box box(triangle(i));
      if (!box.overlaps(boxes_[leaves_ + b])) continue;
      for (std::size_t j = a == b ? i + 1 : b * leaf_size; j < leaf_end(b); ++j)
        if (box.overlaps(Box(triangle(j)))) call(places_[i], places_[j]);
    }
  }

  const std::vector<Corners>& triangles_;
  std::vector<std::uint32_t> places_;  // along a curve through space
  std::size_t leaves_ = 1;
  std::vector<Box> boxes_;  // node i has the children 2 i and 2 i + 1; the leaves are the last ones
  std::size_t last_ = 0;    // what distance() found
};

}  // namespace discmc::host

#endif
