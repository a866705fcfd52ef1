// The runs of all open boundaries: appending to fragments and joining them, at constant cost.
#ifndef DISCMC_FRAGMENT_STORE_HPP
#define DISCMC_FRAGMENT_STORE_HPP

#include <discmc/limits.hpp>

namespace discmc {

/// Fragments over one pool of runs. append() and join() take at most one record each; that there is
/// one is the caller's care. Where two runs come to meet and do not become one, Normals tells the
/// normal that the second starts with.
template <class Index, class Normals = NoNormals>
class FragmentStore : private Normals {
 public:
  using Normal = typename Normals::Normal;
  using Part = Fragment<Index, Normal>;
  using Node = RunNode<Index, Normal>;

  Normals& normals() { return *this; }
  const Normals& normals() const { return *this; }

  void start(Node* nodes, uint32_t capacity) { nodes_.start(nodes, capacity); }
  void clear() { nodes_.clear(); }

  uint32_t available() const { return nodes_.available(); }
  uint32_t in_use() const { return nodes_.in_use(); }
  uint32_t high_water() const { return nodes_.high_water(); }
  uint32_t capacity() const { return nodes_.capacity(); }

  void append(Part& fragment, Run run) {
    if (fragment.tail.absorb(run)) return;
    if (!fragment.is_empty()) {
      push_tail(fragment);
      fragment.set_start_normal(this->normal_here());
    }
    fragment.tail = run;
  }

  /// Puts `other` behind `fragment`; `other` is then void.
  void join(Part& fragment, const Part& other) {
    if (other.is_empty()) return;
    if (fragment.is_empty()) return fragment.move_from(other);
    if (other.last == no_record) return append(fragment, other.tail);
    absorb_or_push(fragment, other);
    const Index first = nodes_[other.last].next;
    if (fragment.last == no_record) {
      fragment.last = other.last;
    } else {
      nodes_[other.last].next = nodes_[fragment.last].next;
      nodes_[fragment.last].next = first;
      fragment.last = other.last;
    }
    fragment.tail = other.tail;
    fragment.set_start_normal(other.start_normal());
  }

  /// Gives the fragment's nodes back; the run in place stays. Cost: one step a node.
  void give_nodes(Part& fragment) {
    if (fragment.last == no_record) return;
    Index node = nodes_[fragment.last].next;
    for (;;) {
      const Index next = nodes_[node].next;
      const bool was_last = node == fragment.last;
      nodes_.give(node);
      if (was_last) break;
      node = next;
    }
    fragment.last = no_record;
  }

  /// Whether a fragment has more than `count` nodes. Cost: at most that many steps.
  bool is_longer(const Part& fragment, uint32_t count) const {
    Index node = first(fragment);
    for (; node != no_record && count > 0; --count) node = after(fragment, node);
    return node != no_record;
  }

  /// The first node of a fragment, or none when its only run is the one in place.
  Index first(const Part& fragment) const {
    return fragment.last == no_record ? no_record : nodes_[fragment.last].next;
  }
  /// The node after `node`, or none after the last.
  Index after(const Part& fragment, Index node) const {
    return node == fragment.last ? no_record : nodes_[node].next;
  }
  Run run(Index node) const { return nodes_[node].run(); }
  Normal start_normal(Index node) const { return nodes_[node].start_normal(); }

  /// Says that a fragment starts where the last run of its ring ends.
  void close(Part& fragment) {
    const Index node = first(fragment);
    StartNormal<Normal>& run = fragment;
    (node == no_record ? run : nodes_[node]).set_start_normal(this->normal_here());
  }

 private:
  void push_tail(Part& fragment) {
    const Index node = nodes_.take();
    nodes_[node].set(fragment.tail);
    nodes_[node].set_start_normal(fragment.start_normal());
    if (fragment.last == no_record) {
      nodes_[node].next = node;
    } else {
      nodes_[node].next = nodes_[fragment.last].next;
      nodes_[fragment.last].next = node;
    }
    fragment.last = node;
  }

  // The tail of `fragment` goes into the first node of `other`, or into a node of its own.
  void absorb_or_push(Part& fragment, const Part& other) {
    Node& first = nodes_[nodes_[other.last].next];
    Run run = fragment.tail;
    if (run.absorb(first.run())) {
      first.set(run);
      first.set_start_normal(fragment.start_normal());
    } else {
      push_tail(fragment);
      first.set_start_normal(this->normal_here());
    }
  }

  Pool<Node, Index> nodes_;
};

}  // namespace discmc

#endif
