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

/// A binary tree of boxes, in which those near to each other are mostly together.
/// Memory: 44 to 56 bytes per box. Time: n log n to build for n boxes.
class BoxTree {
 public:
  /// Limit: fewer than 2^32.
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Returns the distance of a point from the nearest of the things that lie in the boxes, or
  /// `enough` where it is no more. It takes less time the nearer the point is to the one before.
  /// squared_distance_of: called with the place of a box in what was given, returns that of the
  /// thing. Limit: some boxes.
  template <class SquaredDistance>
  double distance(const Point& point, double enough, SquaredDistance squared_distance_of) {
    struct Waiting {
      std::size_t node;
      double squared_distance;
    };
    const double squared_enough = enough * enough;
    double nearest = squared_distance_of(last_);
    std::array<Waiting, max_waiting> waiting;
    std::size_t count = 0;
    waiting[count++] = {1, nodes_[1].squared_distance(point)};
    while (count > 0 && nearest > squared_enough) {
      const Waiting next = waiting[--count];
      if (next.squared_distance >= nearest) continue;
      if (next.node >= leaves_) {
        for (std::size_t i = begin_of(next.node); i < end_of(next.node); ++i) {
          const double away = squared_distance_of(places_[i]);
          if (away >= nearest) continue;
          nearest = away;
          last_ = places_[i];
        }
        continue;
      }
      Waiting near = {2 * next.node, nodes_[2 * next.node].squared_distance(point)};
      Waiting far = {2 * next.node + 1, nodes_[2 * next.node + 1].squared_distance(point)};
      if (far.squared_distance < near.squared_distance) std::swap(near, far);
      waiting[count++] = far;
      waiting[count++] = near;
    }
    return std::max(std::sqrt(nearest), enough);
  }

  /// Calls with the places of boxes that may overlap this one, until a call returns true. Returns
  /// whether one did.
  template <class Call>
  bool any_near(const Box& box, Call call) const {
    return nodes_[1].overlaps(box) && any_below(1, box, call);
  }
  /// The same, from one place on to those farther and farther away in the tree. It takes less time
  /// where a near one is found. Limit: some boxes.
  template <class Call>
  bool any_near(const Box& box, std::uint32_t from, Call call) const {
    std::size_t node = leaves_ + slots_[from] / leaf_size;
    if (nodes_[node].overlaps(box) && any_below(node, box, call)) return true;
    for (; node > 1; node /= 2)
      if (nodes_[node ^ 1].overlaps(box) && any_below(node ^ 1, box, call)) return true;
    return false;
  }

  /// Replaces a box. The tree answers the slower the farther boxes move.
  void replace(std::uint32_t place, const Box& box);
  /// Where a box was when the tree was built: near boxes have near numbers, from 0 on.
  std::uint32_t order_of(std::uint32_t place) const { return slots_[place]; }

  /// Two nodes on one level, or one twice.
  using NodePair = std::array<std::size_t, 2>;

  /// Divides the search for near pairs: those of all parts, one part after the other, are all.
  std::vector<NodePair> parts() const {
    constexpr std::size_t nodes_a_level = 64;
    std::vector<NodePair> parts;
    const std::size_t first = std::min(nodes_a_level, leaves_);
    descend({1, 1}, first, [&parts](const NodePair& pair) { parts.push_back(pair); });
    return parts;
  }
  /// Leaves out of near pairs those without any of the boxes for whose places this returns true.
  template <class IsWanted>
  void keep_pairs_with(IsWanted is_wanted) {
    std::fill(wanted_.begin(), wanted_.end(), std::uint8_t{0});
    for (std::size_t slot = 0; slot < places_.size(); ++slot)
      if (is_wanted(places_[slot]))
        wanted_[leaves_ + slot / leaf_size] |= static_cast<std::uint8_t>(1U << slot % leaf_size);
    for (std::size_t node = leaves_ - 1; node > 0; --node)
      wanted_[node] = wanted_[2 * node] | wanted_[2 * node + 1];
  }
  /// Calls with the places of two boxes in what was given, once for any two that overlap.
  template <class Call>
  void for_each_near_pair(const NodePair& part, Call call) const {
    descend(part, leaves_, [&](const NodePair& leaves) { for_each_pair_of(leaves, call); });
  }

 private:
  static constexpr std::size_t leaf_size = 4;
  static constexpr std::size_t max_waiting = 128;  // the tree has at most 32 levels

  // The boxes of a leaf, axis by axis, so that vectors of the processor compare all with another.
  // Those that are missing overlap nothing.
  struct Leaf {
    using Floats = std::array<float, leaf_size>;
    using Hits = std::array<std::int32_t, leaf_size>;

    Leaf() {
      for (std::size_t i = 0; i < leaf_size; ++i) set(i, {});
    }
    void set(std::size_t i, const Box& box) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis][i] = box.low[axis];
        high[axis][i] = box.high[axis];
      }
    }
    Box box(std::size_t i) const {
      Box box;
      box.low = {low[0][i], low[1][i], low[2][i]};
      box.high = {high[0][i], high[1][i], high[2][i]};
      return box;
    }
    Hits overlaps(const Box& other) const {
      Hits hits;
      hits.fill(1);
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < leaf_size; ++i) {
          hits[i] &= low[axis][i] <= other.high[axis] ? 1 : 0;
          hits[i] &= other.low[axis] <= high[axis][i] ? 1 : 0;
        }
      return hits;
    }

    std::array<Floats, 3> low, high;
  };

  std::size_t begin_of(std::size_t leaf) const { return (leaf - leaves_) * leaf_size; }
  std::size_t end_of(std::size_t leaf) const {
    return std::min(begin_of(leaf) + leaf_size, places_.size());
  }

  // Limit: the node is near.
  template <class Call>
  bool any_below(std::size_t top, const Box& box, Call& call) const {
    std::array<std::size_t, max_waiting> waiting;
    std::size_t count = 0;
    const auto add_if_near = [&](std::size_t node) {
      waiting[count] = node;
      count += nodes_[node].overlaps(box);
    };
    waiting[count++] = top;
    while (count > 0) {
      const std::size_t node = waiting[--count];
      if (node < leaves_) {
        add_if_near(2 * node);
        add_if_near(2 * node + 1);
        continue;
      }
      const Leaf::Hits hits = boxes_[node - leaves_].overlaps(box);
      for (std::size_t i = begin_of(node); i < end_of(node); ++i)
        if (hits[i % leaf_size] != 0 && call(places_[i])) return true;
    }
    return false;
  }

  // Calls with the pairs of the level that begins at `first` that may hold near boxes.
  template <class Call>
  void descend(const NodePair& from, std::size_t first, Call call) const {
    std::array<NodePair, max_waiting> waiting;
    std::size_t count = 0;
    const auto add_if_near = [&](std::size_t a, std::size_t b) {
      waiting[count] = {a, b};
      count += nodes_[a].overlaps(nodes_[b]) && (wanted_[a] | wanted_[b]) != 0;
    };
    waiting[count++] = from;
    while (count > 0) {
      const auto [a, b] = waiting[--count];
      if (a >= first) {
        call(NodePair{a, b});
        continue;
      }
      add_if_near(2 * a, 2 * b);
      add_if_near(2 * a, 2 * b + 1);
      if (a != b) add_if_near(2 * a + 1, 2 * b);
      add_if_near(2 * a + 1, 2 * b + 1);
    }
  }

  // Pairs in one leaf, or in two.
  template <class Call>
  void for_each_pair_of(const NodePair& leaves, Call& call) const {
    const auto [a, b] = leaves;
    std::array<std::array<std::size_t, 2>, leaf_size * leaf_size> near;
    std::size_t count = 0;
    const Leaf::Hits near_b = boxes_[a - leaves_].overlaps(nodes_[b]);
    for (std::size_t i = begin_of(a); i < end_of(a); ++i) {
      if (near_b[i % leaf_size] == 0) continue;
      const Leaf::Hits hits = boxes_[b - leaves_].overlaps(boxes_[a - leaves_].box(i % leaf_size));
      const unsigned wanted = (wanted_[a] >> i % leaf_size & 1U) != 0 ? ~0U : wanted_[b];
      for (std::size_t j = a == b ? i + 1 : begin_of(b); j < end_of(b); ++j) {
        near[count] = {i, j};
        count += static_cast<unsigned>(hits[j % leaf_size]) & wanted >> j % leaf_size;
      }
    }
    for (std::size_t i = 0; i < count; ++i) call(places_[near[i][0]], places_[near[i][1]]);
  }

  std::vector<std::uint32_t> places_;  // along a curve through space
  std::vector<std::uint32_t> slots_;   // of each place, where it is in places_
  std::vector<Leaf> boxes_;            // in the order of places_
  std::size_t leaves_ = 1;
  std::vector<Box> nodes_;  // node i has the children 2 i and 2 i + 1; the leaves are the last ones
  std::vector<std::uint8_t> wanted_;  // of a leaf: a bit for each box; of another node: whether any
  std::uint32_t last_ = 0;            // what distance() found
};

}  // namespace discmc::meshing

#endif
