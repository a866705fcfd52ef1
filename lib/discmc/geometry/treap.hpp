// A search tree in the caller's slots.
#ifndef DISCMC_GEOMETRY_TREAP_HPP
#define DISCMC_GEOMETRY_TREAP_HPP

#include <discmc/base/pool.hpp>

namespace discmc {

/// A treap: sorted from left to right, and a heap of priorities from the root down. The priority of
/// a node is a hash of its number, so no order of insertions makes the tree deep (C. Aragon and
/// R. Seidel, Randomized search trees, 1989). Nodes are numbers from 1 on.
///
/// Nodes: a type with left(node) and right(node), which return links by reference, and with
/// precedes(node, node), a strict total order. Cost of every function: the depth of the tree, about
/// twice the logarithm of its size.
template <class Nodes>
class Treap {
 public:
  uint32_t root() const { return root_; }

  void insert(const Nodes& nodes, uint32_t node) {
    uint32_t* link = &root_;
    while (priority(*link) > priority(node)) link = &towards(nodes, node, *link);
    // Divides the nodes below into nodes before the new one and nodes after it.
    uint32_t rest = *link;
    *link = node;
    uint32_t* before = &nodes.left(node);
    uint32_t* after = &nodes.right(node);
    while (rest != no_slot) {
      if (nodes.precedes(rest, node)) {
        *before = rest;
        before = &nodes.right(rest);
        rest = *before;
      } else {
        *after = rest;
        after = &nodes.left(rest);
        rest = *after;
      }
    }
    *before = *after = no_slot;
  }

  /// Limit: the tree contains the node.
  void remove(const Nodes& nodes, uint32_t node) {
    uint32_t* link = &root_;
    while (*link != node) link = &towards(nodes, node, *link);
    uint32_t before = nodes.left(node), after = nodes.right(node);
    while (before != after) {  // ends when both are no_slot
      const bool is_before = priority(before) > priority(after);
      uint32_t& upper = is_before ? before : after;
      *link = upper;
      link = &(is_before ? nodes.right(upper) : nodes.left(upper));
      upper = *link;
    }
    *link = no_slot;
  }

  /// The first node for which is_behind(node) is true, or no_slot. is_behind: false for the first
  /// nodes, and true for the others.
  template <class IsBehind>
  uint32_t first(const Nodes& nodes, IsBehind is_behind) const {
    uint32_t first = no_slot;
    for (uint32_t node = root_; node != no_slot;) {
      const bool is_candidate = is_behind(node);
      if (is_candidate) first = node;
      node = is_candidate ? nodes.left(node) : nodes.right(node);
    }
    return first;
  }

  /// A node for which order(node) is 0, or no_slot. order: less than 0 for the nodes before it, and
  /// greater than 0 for those after it.
  template <class Order>
  uint32_t find(const Nodes& nodes, Order order) const {
    uint32_t node = root_;
    while (node != no_slot) {
      const int32_t found = order(node);
      if (found > 0)
        node = nodes.left(node);
      else if (found < 0)
        node = nodes.right(node);
      else
        break;
    }
    return node;
  }

 private:
  static uint32_t& towards(const Nodes& nodes, uint32_t node, uint32_t from) {
    return nodes.precedes(node, from) ? nodes.left(from) : nodes.right(from);
  }
  // Each number has a different priority, because every step is invertible. no_slot has the least,
  // 0.
  static uint32_t priority(uint32_t node) {
    node = (node ^ node >> 16) * 0x85EBCA6BU;
    node = (node ^ node >> 13) * 0xC2B2AE35U;
    return node ^ node >> 16;
  }

  uint32_t root_ = no_slot;
};

}  // namespace discmc

#endif
