// Boxes in space, found by where they are.
#ifndef DISCMC_MESH_MESHES_BOX_TREE_HPP
#define DISCMC_MESH_MESHES_BOX_TREE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "surface/point.hpp"

namespace discmc::meshing {

/// The three corners of a triangle.
using Corners = std::array<Point, 3>;

/// A vector along the normal of a triangle, twice as long as the triangle is large.
inline Point doubled_area(const Corners& triangle) {
  return cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
}

/// A box along the axes; empty at first. Its bounds are rounded outwards.
struct Box {
  Box() = default;
  explicit Box(const Corners& triangle) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [least, most] =
          std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
      low[axis] = static_cast<float>(least);
      high[axis] = static_cast<float>(most);
      if (static_cast<double>(low[axis]) > least) low[axis] = std::nextafter(low[axis], -infinity);
      if (static_cast<double>(high[axis]) < most) high[axis] = std::nextafter(high[axis], infinity);
    }
  }

  static constexpr float infinity = std::numeric_limits<float>::infinity();

  void include(const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], box.low[axis]);
      high[axis] = std::max(high[axis], box.high[axis]);
    }
  }
  // Without branches: which way they go is hard to foretell, and wrong guesses cost more.
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

/// Four boxes, axis by axis, so that vectors of the processor compare all with another.
/// Missing boxes overlap nothing.
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
  /// The box around those with these bits.
  Box around(unsigned bits) const {
    Box all;
    for (std::size_t i = 0; i < 4; ++i)
      if ((bits >> i & 1U) != 0) all.include((*this)[i]);
    return all;
  }
  /// Bit i: whether box i overlaps another.
  unsigned overlaps(const Box& other) const {
    Integers bits = {1, 2, 4, 8};
    for (std::size_t axis = 0; axis < 3; ++axis)
      bits &= (low_[axis] <= other.high[axis]) & (high_[axis] >= other.low[axis]);
    return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
  }

 private:
  // Vectors of GCC and Clang: loops over four numbers are not always made into vectors.
  using Floats [[gnu::vector_size(16)]] = float;
  using Integers [[gnu::vector_size(16)]] = std::int32_t;

  std::array<Floats, 3> low_, high_;
};

/// The boxes of triangles: corners_of(i) for i from 0 on.
template <class CornersOf>
std::vector<Box> boxes_of(std::size_t count, CornersOf corners_of) {
  std::vector<Box> boxes;
  boxes.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) boxes.emplace_back(corners_of(i));
  return boxes;
}

/// Returns the places of boxes along a curve through space on which near ones are mostly together.
std::vector<std::uint32_t> along_curve(const std::vector<Box>& boxes);

/// A tree of boxes, four to a node, in which those near to each other are mostly together.
/// Memory: 40 to 65 bytes per box. Time: n log n to build for n boxes.
class BoxTree {
 public:
  /// Limit: fewer than 2^32.
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Returns the distance of a point from the nearest of the things that lie in the boxes, or
  /// `enough` if it is nearer than that. It takes less time the nearer the point is to the one
  /// before. squared_distance_of: called with the place of a box in what was given, returns that of
  /// the thing. Limit: some boxes.
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
        if (node < leaves_) {  // the nearest child comes last, so that it is the next
          std::size_t at = count++;
          for (; at > first && waiting[at - 1].squared_distance < away; --at)
            waiting[at] = waiting[at - 1];
          waiting[at] = {child(node, i), away};
          continue;
        }
        const std::uint32_t place = places_[slot(node, i)];
        const double exact = squared_distance_of(place);
        if (exact >= nearest) continue;
        nearest = exact;
        last_ = place;
      }
    }
    return std::max(std::sqrt(nearest), enough);
  }

  /// Calls with the places of boxes that overlap this one, and with these boxes, until a call
  /// returns true. Returns whether one did.
  template <class Call>
  bool any_near(const Box& box, Call call) const {
    return any_below(0, box, of_places(call));
  }
  /// The same, from one place on to those farther and farther away in the tree. It takes less time
  /// where a near one is found. Limit: some boxes.
  template <class Call>
  bool any_near(const Box& box, std::uint32_t from, Call call) const {
    std::size_t node = leaves_ + slots_[from] / 4;
    if (any_below(node, box, of_places(call))) return true;
    while (node > 0) {
      const std::size_t below = node;
      node = parent(below);
      const unsigned hits = boxes_[node].overlaps(box);
      for (std::size_t i = 0; i < 4; ++i)
        if ((hits >> i & 1U) != 0 && child(node, i) != below &&
            any_below(child(node, i), box, of_places(call)))
          return true;
    }
    return false;
  }

  /// Replaces a box. The tree answers the slower the farther boxes move.
  void replace(std::uint32_t place, const Box& box);
  /// Where a box was when the tree was built: near boxes have near numbers, from 0 on.
  std::uint32_t order_of(std::uint32_t place) const { return slots_[place]; }

  /// Restricts near pairs to those with a box for which is_wanted(place) is true.
  template <class IsWanted>
  void keep_pairs_with(IsWanted is_wanted) {
    std::fill(wanted_.begin(), wanted_.end(), std::uint8_t{0});
    for (std::size_t slot = 0; slot < places_.size(); ++slot)
      if (is_wanted(places_[slot])) wanted_[slot / 4] |= static_cast<std::uint8_t>(1U << slot % 4);
  }
  /// The number of parts of the search for near pairs.
  std::size_t part_count() const { return (wanted_.size() + leaves_a_part - 1) / leaves_a_part; }
  /// Calls with the places of two boxes that overlap. All parts: once for any two.
  template <class Call>
  void for_each_near_pair(std::size_t part, Call call) const {
    const std::size_t end = leaves_ + std::min((part + 1) * leaves_a_part, wanted_.size());
    for (std::size_t leaf = leaves_ + part * leaves_a_part; leaf < end; leaf += 4)
      for_each_pair_with(leaf, std::min(leaf + 4, end), call);
  }

 private:
  static constexpr std::size_t leaves_a_part = 4096;
  static constexpr std::size_t max_waiting = 64;  // three on each of 16 levels, and four more

  static std::size_t child(std::size_t node, std::size_t i) { return 4 * node + 1 + i; }
  static std::size_t parent(std::size_t node) { return (node - 1) / 4; }
  // Where box i of a leaf is in the order of the curve.
  std::size_t slot(std::size_t leaf, std::size_t i) const { return 4 * (leaf - leaves_) + i; }

  // Calls with the leaves that have boxes which overlap this one, and the bits of these, until a
  // call returns true.
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
  auto of_places(Call& call) const {
    return [this, &call](std::size_t leaf, unsigned hits) {
      for (std::size_t i = 0; i < 4; ++i)
        if ((hits >> i & 1U) != 0 && call(places_[slot(leaf, i)], boxes_[leaf][i])) return true;
      return false;
    };
  }

  // Pairs of the wanted boxes of up to four leaves, which are searched for at once.
  template <class Call>
  void for_each_pair_with(std::size_t begin, std::size_t end, Call& call) const {
    std::array<Box, 4> wanted;
    Box all;
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      wanted[leaf - begin] = boxes_[leaf].around(wanted_[leaf - leaves_]);
      all.include(wanted[leaf - begin]);
    }
    any_below(0, all, [&](std::size_t other, unsigned) {
      for (std::size_t leaf = begin; leaf < end; ++leaf)
        if (const unsigned near = boxes_[other].overlaps(wanted[leaf - begin]); near != 0)
          for_each_pair_of(leaf, other, near, call);
      return false;
    });
  }
  // near: the bits of boxes of the other leaf. Two that are both wanted are found from the one that
  // comes first.
  template <class Call>
  void for_each_pair_of(std::size_t leaf, std::size_t other, unsigned near, Call& call) const {
    const unsigned wanted = wanted_[leaf - leaves_];
    if (other < leaf) near &= ~unsigned{wanted_[other - leaves_]};
    for (std::size_t i = 0; i < 4; ++i) {
      if ((wanted >> i & 1U) == 0) continue;
      if (other == leaf) near &= ~(1U << i);
      const unsigned pairs = near & boxes_[other].overlaps(boxes_[leaf][i]);
      for (std::size_t j = 0; j < 4; ++j)
        if ((pairs >> j & 1U) != 0) call(places_[slot(leaf, i)], places_[slot(other, j)]);
    }
  }

  std::vector<std::uint32_t> places_;  // along a curve through space
  std::vector<std::uint32_t> slots_;   // of each place, where it is in places_

  // Node i has the boxes around its children, 4 i + 1 to 4 i + 4; the leaves have what was given.
  std::vector<FourBoxes> boxes_;
  std::size_t leaves_ = 0;            // where they begin
  std::vector<std::uint8_t> wanted_;  // of each leaf, the bits of its boxes
  std::uint32_t last_ = 0;            // what distance() found
};

}  // namespace discmc::meshing

#endif
