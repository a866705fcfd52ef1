// Finds boxes by their position in space.
#ifndef DISCMC_MESH_MESHES_BOX_TREE_HPP
#define DISCMC_MESH_MESHES_BOX_TREE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "jobs/parallel.hpp"
#include "surface/point.hpp"

namespace discmc::meshing {

/// The three corners of a triangle.
using Corners = std::array<Point, 3>;

/// Returns a vector along the normal of a triangle, with twice its area as length.
inline Point doubled_area(const Corners& triangle) {
  return cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
}

/// An axis-aligned box, initially empty. Its bounds are rounded outwards.
struct Box {
  Box() = default;
  explicit Box(const Corners& triangle) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lowest, highest] =
          std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
      low[axis] = static_cast<float>(lowest);
      high[axis] = static_cast<float>(highest);
      low[axis] = moved(low[axis], static_cast<double>(low[axis]) > lowest ? -1 : 0);
      high[axis] = moved(high[axis], static_cast<double>(high[axis]) < highest ? 1 : 0);
    }
  }

  static constexpr float infinity = std::numeric_limits<float>::infinity();

  // Returns the next float, above or below, or the same one. As integers, floats of one sign are in
  // order. Avoids branches and calls of std::nextafter(), as each second coordinate needs a step.
  static float moved(float from, std::int32_t steps) {
    std::int32_t bits;
    std::memcpy(&bits, &from, sizeof bits);
    bits += bits < 0 ? -steps : steps;
    std::memcpy(&from, &bits, sizeof from);
    return from;
  }

  void include(const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], box.low[axis]);
      high[axis] = std::max(high[axis], box.high[axis]);
    }
  }
  // Avoids branches, because mispredicted ones cost more.
  bool overlaps(const Box& other) const {
    bool result = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result &= low[axis] <= other.high[axis];
      result &= other.low[axis] <= high[axis];
    }
    return result;
  }
  double squared_distance(const Point& point) const;
  bool operator==(const Box& other) const { return low == other.low && high == other.high; }

  std::array<float, 3> low{infinity, infinity, infinity};
  std::array<float, 3> high{-infinity, -infinity, -infinity};
};

/// Four boxes, stored axis by axis for vector instructions. Missing boxes overlap nothing.
class FourBoxes {
 public:
  FourBoxes() {
    for (std::size_t i = 0; i < 4; ++i) set(i, {});
  }
  void set(std::size_t i, const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis][i] = box.low[axis];
      high_[axis][i] = box.high[axis];
    }
  }
  Box operator[](std::size_t i) const {
    Box box;
    box.low = {low_[0][i], low_[1][i], low_[2][i]};
    box.high = {high_[0][i], high_[1][i], high_[2][i]};
    return box;
  }
  /// Returns the box around the selected boxes.
  Box around(unsigned bits) const {
    Box bounds;
    for (std::size_t i = 0; i < 4; ++i)
      if ((bits >> i & 1U) != 0) bounds.include((*this)[i]);
    return bounds;
  }
  /// Sets bit i if box i overlaps `other`.
  unsigned overlaps(const Box& other) const {
    Integers bits = {1, 2, 4, 8};
    for (std::size_t axis = 0; axis < 3; ++axis)
      bits &= (low_[axis] <= other.high[axis]) & (high_[axis] >= other.low[axis]);
    const auto halves = reinterpret_cast<Halves>(bits);
    const std::uint64_t both = halves[0] | halves[1];
    return static_cast<unsigned>(both | both >> 32);
  }

 private:
  // Vectors of GCC and Clang, because compilers do not always vectorise loops over four numbers.
  using Floats [[gnu::vector_size(16)]] = float;
  using Integers [[gnu::vector_size(16)]] = std::int32_t;
  using Halves [[gnu::vector_size(16)]] = std::uint64_t;

  std::array<Floats, 3> low_, high_;
};

/// Returns the boxes of triangles corners_of(i), for i from 0 on. jobs: threads that call it.
template <class CornersOf>
std::vector<Box> boxes_of(std::size_t count, CornersOf corners_of, unsigned jobs = 1) {
  std::vector<Box> boxes(count);
  for_each_range_in_parallel(jobs, count, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i)
      boxes[i] = Box(corners_of(static_cast<std::uint32_t>(i)));
  });
  return boxes;
}

/// Returns the indexes of boxes along a space-filling curve, which keeps near boxes together.
std::vector<std::uint32_t> along_curve(const std::vector<Box>& boxes, unsigned jobs = 1);

/// A tree of boxes with four per node, mostly near each other. Memory: 40 to 65 bytes per box.
/// Time: n log n to build for n boxes.
class BoxTree {
 public:
  /// jobs: threads that share the work. Limit: fewer than 2^32 boxes.
  explicit BoxTree(const std::vector<Box>& boxes, unsigned jobs = 1);

  /// Returns the distance of a point from the nearest item in the boxes, or `enough` if that is
  /// larger. A point near the previous one takes less time.
  /// squared_distance_of: called with the index of a box, returns the squared distance of its item.
  /// Limit: at least one box.
  template <class SquaredDistance>
  double distance(const Point& point, double enough, SquaredDistance squared_distance_of) {
    struct Waiting {
      std::size_t node;
      double squared_distance;
    };
    const double squared_enough = enough * enough;
    double nearest = squared_distance_of(last_);
    std::array<Waiting, max_waiting> waiting;
    waiting[0] = {0, 0};
    std::size_t count = 1;
    while (count > 0 && nearest > squared_enough) {
      const auto [node, squared] = waiting[--count];
      if (squared >= nearest) continue;
      const std::size_t first = count;
      for (std::uint32_t i = 0; i < 4; ++i) {
        const double away = boxes_[node][i].squared_distance(point);
        if (!(away < nearest)) continue;
        if (node < leaves_) {  // pushes the nearest child last, to visit it next
          std::size_t at = count++;
          for (; at > first && waiting[at - 1].squared_distance < away; --at)
            waiting[at] = waiting[at - 1];
          waiting[at] = {child(node, i), away};
          continue;
        }
        const std::uint32_t index = indexes_[slot(node, i)];
        const double exact = squared_distance_of(index);
        if (exact >= nearest) continue;
        nearest = exact;
        last_ = index;
      }
    }
    return std::max(std::sqrt(nearest), enough);
  }

  /// Calls `call` with the index of each box that overlaps `box`, and with that box, until a call
  /// returns true. Returns whether a call did.
  template <class Call>
  bool any_near(const Box& box, Call call) const {
    return any_below(0, box, hit_visitor(call));
  }
  /// Likewise begins at the box with the index `from`, and continues outwards in the tree. This
  /// takes less time if a near call returns true. Limit: at least one box.
  template <class Call>
  bool any_near(const Box& box, std::uint32_t from, Call call) const {
    std::size_t node = leaves_ + slots_[from] / 4;
    if (any_below(node, box, hit_visitor(call))) return true;
    while (node > 0) {
      const std::size_t below = node;
      node = parent(below);
      const unsigned hits = boxes_[node].overlaps(box);
      for (std::size_t i = 0; i < 4; ++i)
        if ((hits >> i & 1U) != 0 && child(node, i) != below &&
            any_below(child(node, i), box, hit_visitor(call)))
          return true;
    }
    return false;
  }

  /// Replaces a box. Searches become slower if boxes move far.
  void replace(std::uint32_t index, const Box& box);
  /// Returns the position of a box in the curve's order when the tree was built: near boxes have
  /// near numbers, from 0 on.
  std::uint32_t order_of(std::uint32_t index) const { return slots_[index]; }
  /// Returns the index of the box at a position in this order.
  std::uint32_t index_at(std::size_t position) const { return indexes_[position]; }

  /// Restricts near pairs to pairs with a box for which is_wanted(index) is true.
  template <class IsWanted>
  void keep_pairs_with(IsWanted is_wanted) {
    std::fill(wanted_.begin(), wanted_.end(), std::uint8_t{0});
    for (std::size_t slot = 0; slot < indexes_.size(); ++slot)
      if (is_wanted(indexes_[slot])) wanted_[slot / 4] |= static_cast<std::uint8_t>(1U << slot % 4);
  }
  /// Returns the number of parts of the search for near pairs.
  std::size_t part_count() const {
    return (wanted_.size() + leaves_per_part - 1) / leaves_per_part;
  }
  /// Calls `call` with two overlapping boxes, by their positions in the curve's order. All parts
  /// together report each pair once.
  template <class Call>
  void for_each_near_pair(std::size_t part, Call call) const {
    const std::size_t end = leaves_ + std::min((part + 1) * leaves_per_part, wanted_.size());
    for (std::size_t leaf = leaves_ + part * leaves_per_part; leaf < end; leaf += 4)
      for_each_pair_with(leaf, std::min(leaf + 4, end), call);
  }

 private:
  static constexpr std::size_t leaves_per_part = 4096;
  static constexpr std::size_t max_waiting = 64;  // three on each of 16 levels, plus four

  static std::size_t child(std::size_t node, std::size_t i) { return 4 * node + 1 + i; }
  static std::size_t parent(std::size_t node) { return (node - 1) / 4; }
  // Returns the position of box i of a leaf in the curve's order.
  std::uint32_t slot(std::size_t leaf, std::size_t i) const {
    return static_cast<std::uint32_t>(4 * (leaf - leaves_) + i);
  }

  // Calls `call` with each leaf that has boxes overlapping `box`, and the bits of these boxes,
  // until a call returns true.
  template <class Call>
  bool any_below(std::size_t top, const Box& box, Call call) const {
    std::array<std::size_t, max_waiting> waiting;
    waiting[0] = top;
    std::size_t count = 1;
    while (count > 0) {
      const std::size_t node = waiting[--count];
      const unsigned hits = boxes_[node].overlaps(box);
      if (node >= leaves_) {
        if (hits != 0 && call(node, hits)) return true;
        continue;
      }
      for (std::size_t i = 0; i < 4; ++i) {
        waiting[count] = child(node, i);
        count += hits >> i & 1U;
      }
    }
    return false;
  }
  template <class Call>
  auto hit_visitor(Call& call) const {
    return [this, &call](std::size_t leaf, unsigned hits) {
      for (std::size_t i = 0; i < 4; ++i)
        if ((hits >> i & 1U) != 0 && call(indexes_[slot(leaf, i)], boxes_[leaf][i])) return true;
      return false;
    };
  }

  // Finds pairs of the wanted boxes in up to four leaves at once.
  template <class Call>
  void for_each_pair_with(std::size_t begin, std::size_t end, Call& call) const {
    std::array<Box, 4> wanted;
    Box bounds;
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      wanted[leaf - begin] = boxes_[leaf].around(wanted_[leaf - leaves_]);
      bounds.include(wanted[leaf - begin]);
    }
    any_below(0, bounds, [&](std::size_t other, unsigned) {
      for (std::size_t leaf = begin; leaf < end; ++leaf)
        if (const unsigned near = boxes_[other].overlaps(wanted[leaf - begin]); near != 0)
          for_each_pair_of(leaf, other, near, call);
      return false;
    });
  }
  // near: the bits of boxes in the other leaf. A pair of wanted boxes is reported only from the
  // first one.
  template <class Call>
  void for_each_pair_of(std::size_t leaf, std::size_t other, unsigned near, Call& call) const {
    const unsigned wanted = wanted_[leaf - leaves_];
    if (other < leaf) near &= ~unsigned{wanted_[other - leaves_]};
    for (std::size_t i = 0; i < 4; ++i) {
      if ((wanted >> i & 1U) == 0) continue;
      if (other == leaf) near &= ~(1U << i);
      const unsigned pairs = near & boxes_[other].overlaps(boxes_[leaf][i]);
      for (std::size_t j = 0; j < 4; ++j)
        if ((pairs >> j & 1U) != 0) call(slot(leaf, i), slot(other, j));
    }
  }

  std::vector<std::uint32_t> indexes_;  // index of each box in the curve's order
  std::vector<std::uint32_t> slots_;    // position in indexes_ of each index

  // Node i has the boxes around its children, 4 i + 1 to 4 i + 4; leaves have the original boxes.
  std::vector<FourBoxes> boxes_;
  std::size_t leaves_ = 0;            // number of the first leaf
  std::vector<std::uint8_t> wanted_;  // per leaf: bits of its wanted boxes
  std::uint32_t last_ = 0;            // last result of distance()
};

}  // namespace discmc::meshing

#endif
