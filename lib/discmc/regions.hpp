// Regions under construction: union-find, their closed rings, and the queue of complete ones.
#ifndef DISCMC_REGIONS_HPP
#define DISCMC_REGIONS_HPP

#include <discmc/frontier.hpp>

namespace discmc {

/// A region is known by any node of its tree. Every unresolved edge and every child node counts as
/// a reference; a root without references is complete and goes to the queue, a node that is no root
/// leaves with its last reference. Union is by rank, so that a search takes a few steps.
template <class Index, class Normal = NoNormal>
class Regions {
 public:
  using Ring = ClosedRing<Index, Normal>;

  void start(RegionNode<Index>* nodes, uint32_t node_capacity, Ring* rings,
             uint32_t ring_capacity) {
    nodes_.start(nodes, node_capacity);
    rings_.start(rings, ring_capacity);
  }

  void clear() {
    nodes_.clear();
    rings_.clear();
    first_complete_ = no_record;
    last_complete_ = no_record;
  }

  /// A new region with one reference.
  Index create(Incidence incidence) {
    const Index node = nodes_.take();
    nodes_[node] = {{node}, no_record, 1, incidence, 0};
    return node;
  }

  Incidence incidence(Index node) const { return nodes_[node].incidence; }

  Index root(Index node) const {
    while (nodes_[node].parent != node) node = nodes_[node].parent;
    return node;
  }

  /// Makes one region of two different roots and returns its root.
  Index unite(Index a, Index b) {
    if (nodes_[a].rank < nodes_[b].rank) {
      const Index other = a;
      a = b;
      b = other;
    }
    RegionNode<Index>& root = nodes_[a];
    RegionNode<Index>& child = nodes_[b];
    if (root.rank == child.rank) ++root.rank;
    root.rings = joined_rings(root.rings, child.rings);
    child.parent = a;
    ++root.references;
    return a;
  }

  void refer(Index node) { ++nodes_[node].references; }

  void release(Index node) {
    while (--nodes_[node].references == 0) {
      const Index parent = nodes_[node].parent;
      if (parent == node) return enqueue(node);
      nodes_.give(node);
      node = parent;
    }
  }

  /// Adds a closed ring to a region. The fragment's runs go with it.
  Index add_ring(Index node, const Fragment<Index, Normal>& fragment, const Vertex& start,
                 bool hole) {
    const Index ring = rings_.take();
    Ring& record = rings_[ring];
    record.move_from(fragment);
    record.next = ring;
    record.x = static_cast<uint16_t>(start.x + 1);
    record.y = static_cast<uint16_t>(start.y + 1);
    record.z = start.z;
    record.hole = hole;
    RegionNode<Index>& region = nodes_[root(node)];
    region.rings = joined_rings(region.rings, ring);
    return ring;
  }

  bool has_complete() const { return first_complete_ != no_record; }
  /// The region that has been complete for the longest. Limit: has_complete().
  Index first_complete() const { return first_complete_; }

  /// The last ring of a region's circular list, turned so that the outer ring is its first.
  Index rings_outer_first(Index node) const {
    Index last = nodes_[node].rings;
    const Index end = last;
    while (rings_[rings_[last].next].hole != 0) {
      last = rings_[last].next;
      if (last == end) break;
    }
    return last;
  }

  Ring& ring(Index index) { return rings_[index]; }
  static Vertex start_of(const Ring& ring) {
    return {int32_t{ring.x} - 1, int32_t{ring.y} - 1, ring.z};
  }

  /// Gives a ring of the first complete region back, whose runs were given back before. Returns the
  /// ring after it.
  Index give_ring(Index ring) {
    const Index next = rings_[ring].next;
    rings_.give(ring);
    return next;
  }

  /// Removes the first complete region, whose rings were given back before.
  void remove_first_complete() {
    const Index node = first_complete_;
    const Index next = nodes_[node].next;
    first_complete_ = next == node ? Index{no_record} : next;
    nodes_.give(node);
  }

  const Pool<RegionNode<Index>, Index>& nodes() const { return nodes_; }
  const Pool<Ring, Index>& rings() const { return rings_; }

 private:
  // A complete root is in the queue; the last one names itself, as any root does.
  void enqueue(Index node) {
    if (first_complete_ == no_record)
      first_complete_ = node;
    else
      nodes_[last_complete_].next = node;
    last_complete_ = node;
  }

  Index joined_rings(Index a, Index b) {
    if (a == no_record) return b;
    if (b == no_record) return a;
    const Index first = rings_[a].next;
    rings_[a].next = rings_[b].next;
    rings_[b].next = first;
    return b;
  }

  Pool<RegionNode<Index>, Index> nodes_;
  Pool<Ring, Index> rings_;
  Index first_complete_ = no_record;
  Index last_complete_ = no_record;
};

}  // namespace discmc

#endif
