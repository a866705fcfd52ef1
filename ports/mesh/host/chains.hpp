// The open chains of the extractor for PCs: linked nodes, where firmware has fragments of runs.
//
// A node is a vertex that a chain passes. Nodes are numbered as they are made, and linked in the
// direction of the chain. A fragment is a piece of a chain. Both ends of a fragment wait: the last
// node in a queue of tails, the first node in a queue of begins. A pass makes a node, and links
// it with those that the pass removes from its two queues. A pass that only lengthens a fragment,
// without a corner, makes none: the waiting node moves to the next queue. All passes run the same
// instructions, so no branch depends on the surface.
//
// A join is a node that removes an end from both of its queues: it connects two fragments, or
// closes a ring. find_ring() follows the chain from a join as long as its nodes are older. A ring
// returns to its join. A long walk without a ring adds a shortcut, a node that names the end of the
// walk, so that no walk is repeated.
//
// Nodes are never removed one by one. When their area is full, copy_open() copies the nodes of open
// fragments to a second area, without those that have no corner. All other nodes are forgotten.
//
// At the seam of a slab, a chain from another slab begins at a node, and a leaving chain ends at a
// node. One end of this node waits in a queue of the seam, from which no pass removes ends. A
// fragment between two such nodes is complete.
//
// A queue is an array of seats; each seat holds the number of a waiting node.
#ifndef DISCMC_MESH_HOST_CHAINS_HPP
#define DISCMC_MESH_HOST_CHAINS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "array.hpp"
#include "found_passes.hpp"
#include "node.hpp"

namespace discmc::host {

/// The initial numbers of nodes and seats, which grow. The longest walk that adds no shortcut.
struct ChainSizes {
  // A pass adds at most one node. If it is a join, find_ring() may add a shortcut.
  static constexpr std::uint32_t max_new = 2 * FoundPasses::max_passes;
  // The passes that may cross a seam: all passes of an edge.
  static constexpr std::uint32_t max_across =
      Edges::max_at_seam * detail::trace::PassList::max_passes;
  static constexpr std::uint32_t max_walk = 256;

  std::uint32_t nodes = 4096;
  /// The seats of a queue, and of a queue of the seam. No powers of two, so that the first seats of
  /// the queues lie in different sets of a cache.
  std::uint32_t seats = 4 * Edges::max_edges + 16;
  std::uint32_t seats_at_seam = 2 * max_across + 16;
  std::uint32_t short_walk = 64;  ///< nodes; at most max_walk

  /// The sizes that one batch of edges needs. Tests use them, so that all memory grows.
  static constexpr ChainSizes minimum() { return {max_new, Edges::max_edges, max_across, 1}; }
};

static_assert(ChainSizes{}.nodes >= ChainSizes::max_new && ChainSizes{}.seats >= Edges::max_edges &&
                  ChainSizes{}.seats_at_seam >= ChainSizes::max_across &&
                  ChainSizes{}.short_walk <= ChainSizes::max_walk,
              "the initial sizes hold a batch");

class Chains {
 public:
  /// Sets the initial sizes, from the next clear() on. Limit: at least ChainSizes::minimum().
  void set_sizes(const ChainSizes& sizes) { sizes_ = sizes; }
  /// Forgets all chains.
  void clear();

  /// Whether copy_open() is due before further passes.
  bool is_full() const { return nodes() + ChainSizes::max_new > max_nodes_; }
  /// Makes room for more nodes: copies those of open fragments. Limit: no ring and no complete
  /// fragment is due. Throws std::bad_alloc.
  void copy_open();

  /// Adds the passes at this many edges to the chains. Limit: no ring is due, and the chains are
  /// not full.
  void process(const FoundPasses& passes, std::uint32_t edges);

  /// Finds the next closed ring, in the order of closing. Returns false if there is none.
  bool find_ring();
  /// Finds the complete fragments, between two seams. Cost: follows the fragments that begin at a
  /// seam.
  void find_complete();
  bool has_complete() const { return next_complete_ != complete_.size(); }
  /// Finds the next complete fragment, in the order of completion. Limit: there is one.
  void find_fragment();

  /// The corners (CornerCode) of what was found last, in order. The array has room for as many
  /// again.
  std::uint64_t* corners() { return corner_.begin(); }
  std::uint32_t corner_count() const { return corner_count_; }

 private:
  // Node 0 is none: passes without a node before them write it, and nothing reads it.
  static constexpr std::uint32_t first_node = 1;
  std::uint32_t nodes() const { return top_ - first_node; }

  std::uint32_t& front(std::uint32_t queue) {
    return queue < first_begins ? next_in_seat_[queue] : next_out_seat_[queue];
  }
  std::uint32_t& back(std::uint32_t queue) {
    return queue < first_begins ? next_out_seat_[queue] : next_in_seat_[queue];
  }
  static bool is_at_seam(std::uint32_t queue) {
    return queue == seam_tails || queue == seam_begins;
  }
  std::uint32_t waiting(std::uint32_t queue) { return back(queue) - front(queue); }
  std::uint32_t seats(std::uint32_t queue) const { return end_seat_[queue] - first_seat_[queue]; }
  std::uint32_t free_seats(std::uint32_t queue) { return end_seat_[queue] - back(queue); }
  // Whether each queue has seats for the passes of max_edges.
  bool has_seats() {
    return min_free_seats_ >= Edges::max_edges &&
           free_seats(seam_tails) >= ChainSizes::max_across &&
           free_seats(seam_begins) >= ChainSizes::max_across;
  }
  void find_min_free_seats();
  void make_seats();
  void grow_queue(std::uint32_t queue);
  void move_waiting(std::uint32_t queue, std::uint32_t first);
  bool leads_to(std::uint32_t join, std::uint32_t at);
  void list_corners(std::uint32_t first, std::uint32_t end);

  ChainSizes sizes_;
  meshing::Array<Node> area_, spare_area_;
  std::uint32_t top_ = 0;  // behind the last node
  // The most nodes before the next copy_open(), and after it. They do not depend on earlier scans,
  // nor does the order of events.
  std::uint32_t max_nodes_ = 0, next_max_nodes_ = 0;
  meshing::Array<std::uint32_t> seat_;
  std::uint32_t min_free_seats_ = 0;  // of all queues but those of the seam
  // Per queue: the next seat of arriving chains, and of leaving chains. An arriving chain removes
  // an end from a queue of tails, or adds an end to a queue of begins.
  std::uint32_t next_in_seat_[queue_codes] = {};
  std::uint32_t next_out_seat_[queue_codes] = {};
  std::uint32_t first_seat_[queue_codes] = {};
  std::uint32_t end_seat_[queue_codes] = {};
  meshing::Array<std::uint32_t> join_;  // of the last batch
  std::uint32_t joins_ = 0;
  std::uint32_t next_join_ = 0;  // the first join that find_ring() has not followed
  struct Complete {
    std::uint32_t newest, first;
  };
  std::vector<Complete> complete_;
  std::size_t next_complete_ = 0;
  meshing::Array<std::uint64_t> corner_;  // of what was found
  std::uint32_t corner_count_ = 0;
};

}  // namespace discmc::host

#endif
