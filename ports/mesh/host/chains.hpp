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
// A queue is an array of seats; each seat holds the number of a waiting node. Nodes and queues are
// in the pool of slots, so a checkpoint contains them.
#ifndef DISCMC_MESH_HOST_CHAINS_HPP
#define DISCMC_MESH_HOST_CHAINS_HPP

#include <discmc/trace/fragments.hpp>
#include "found_passes.hpp"
#include "node.hpp"

namespace discmc::host {

/// The initial sizes of the area of nodes and of queues, and the limits of a ring's walk.
struct ChainCapacities {
  static constexpr uint32_t seats_per_slot = sizeof(Node) / sizeof(uint32_t);
  // A pass adds at most one node. If it is a join, find_ring() may add a shortcut.
  static constexpr uint32_t max_joins = FoundPasses::max_passes;
  static constexpr uint32_t max_new = FoundPasses::max_passes + max_joins;
  // The passes that may cross a seam: all passes of an edge.
  static constexpr uint32_t max_across = Edges::max_at_seam * detail::trace::PassList::max_passes;
  // Slots that are reserved for handing over. A node that waits at both ends becomes two ends, and
  // both of its sides may be long: up to eight slots of runs.
  static constexpr uint32_t slots_per_node = 10;
  static constexpr uint32_t runs_of_side =
      (2 * (Limits::max_extent + 1) + detail::trace::max_short_length - 1) /
      detail::trace::max_short_length;
  static_assert(2 + (2 * runs_of_side + 2 + 2) / 3 <= slots_per_node,
                "two ends, two long sides, and two short ones at centroids");
  static constexpr uint32_t max_corners = 512;

  uint32_t nodes = 4096;
  /// The seats of a queue, and of a queue of the seam: multiples of seats_per_slot, but no powers
  /// of two. So the first seats of queues do not share sets of a cache.
  uint32_t seats = 4 * Edges::max_edges + 16;
  uint32_t seats_at_seam = 2 * max_across + 16;
  /// find_ring() lists no corners if its walk did not reach the ring's join within this many; up to
  /// one more is listed.
  uint32_t corners = max_corners;
  uint32_t short_walk = 64;

  /// The capacities that one batch of edges needs. With them, tests soon make everything grow.
  static constexpr ChainCapacities minimum() {
    return {max_new, Edges::max_edges, max_across, 1, 1};
  }

  constexpr uint32_t seat_slots() const {
    return 2 * ((queues_each - 1) * seats + seats_at_seam) / seats_per_slot;
  }
  /// The slots that chains need at the start.
  constexpr uint32_t slots() const {
    return 1 + seat_slots() + 2 * nodes + 2 * slots_per_node * max_new;
  }
};

class Chains {
 public:
  using Fragments = detail::trace::Fragments<uint32_t, NoNormal>;
  using Slots = Fragments::Slots;

  static constexpr uint32_t max_corners = ChainCapacities::max_corners;
  static constexpr uint32_t min_slots = ChainCapacities{}.slots();
  static_assert(ChainCapacities{}.seats >= 2 * Edges::max_edges &&
                    ChainCapacities{}.seats_at_seam >= 2 * ChainCapacities::max_across,
                "half of the seats have room for a batch");
  static_assert(ChainCapacities{}.nodes >= ChainCapacities::max_new,
                "the nodes have room for a batch");
  static_assert(2 * ChainCapacities{}.short_walk <= max_corners, "a node has two corners at most");

  /// Sets the capacities of the next start. Limit: at least ChainCapacities::minimum(), and at most
  /// max_corners corners and half as many nodes of a walk.
  void set_capacities(const ChainCapacities& capacities) {
    DISCMC_LIMIT(capacities.short_walk >= 1 && 2 * capacities.short_walk <= max_corners);
    DISCMC_LIMIT(capacities.corners <= max_corners);
    capacities_ = capacities;
  }
  /// Begins with cleared slots. Returns false if there are too few for the capacities.
  bool start(Slots& slots);

  /// Whether there is room for the passes of max_edges without copying nodes. Limit, here and
  /// below: no ring and no complete fragment is due.
  bool has_room(Slots& slots) {
    DISCMC_LIMIT(joins_ == 0 && complete_ == 0);
    return (has_free_seats() || grow_queues(slots)) && has_room_for(slots, 0);
  }
  /// Makes room for the passes of max_edges. Returns false if too many slots would be in use; then
  /// call hand_over(). Limit: no fragment is complete. Cost: copies all open fragments.
  bool compact(Slots& slots);

  /// Adds passes to the chains. Limit: there is room.
  void process(Slots& slots, const FoundPasses& passes, uint32_t edges);

  /// Finds the next closed ring, in the order of closing. Returns false if there is none.
  bool find_ring(Slots& slots);
  /// Returns the corners of the found ring, in order from any corner. Returns none if the walk did
  /// not reach its join within `corners` corners; up to one more is listed. The array has room for
  /// as many corners again.
  uint64_t* corners() { return corner_; }
  uint32_t corner_count() const { return corner_count_; }
  /// Makes the found ring outgoing, as slots.
  void set_outgoing_ring(Fragments& fragments) const;

  /// Finds the complete fragments, between two seams. Makes the chain of each circular, and puts
  /// its newest node in the seat. Cost: follows the fragments that begin at a seam.
  void find_complete(Slots& slots);
  bool has_complete() const { return complete_ > 0; }
  /// Makes the next complete fragment outgoing, as slots. Limit: there is one.
  void set_outgoing_fragment(Fragments& fragments);

  /// Hands all fragments over to the firmware's sweep, which continues at a word of a row. Limit:
  /// no fragment is complete.
  void hand_over(Fragments& fragments, const detail::trace::SweptRow& row, uint32_t word);
  /// Forgets everything, and releases all slots.
  void release_all(Slots& slots);

 private:
  static constexpr uint32_t max_new = ChainCapacities::max_new;
  static constexpr uint32_t max_across = ChainCapacities::max_across;
  static constexpr uint32_t slots_per_node = ChainCapacities::slots_per_node;
  static constexpr uint32_t seats_per_slot = ChainCapacities::seats_per_slot;

  struct Area {
    uint32_t first, slots;
  };

  // Node n is slot n + 1 of the pool; slot 0 is no slot. Passes without a node before them write
  // node 0, which is never read.
  static Node* nodes(Slots& slots) { return reinterpret_cast<Node*>(&slots[1]); }
  static uint32_t* seats(Slots& slots) { return reinterpret_cast<uint32_t*>(&slots[1]); }
  uint32_t& front(uint32_t queue) {
    return queue < first_begins ? next_in_seat_[queue] : next_out_seat_[queue];
  }
  uint32_t& back(uint32_t queue) {
    return queue < first_begins ? next_out_seat_[queue] : next_in_seat_[queue];
  }

  static bool is_at_seam(uint32_t queue) { return queue == seam_tails || queue == seam_begins; }
  uint32_t free_seats(uint32_t queue) { return end_seat_[queue] - back(queue); }
  bool is_within_seats(uint32_t queue) {
    return first_seat_[queue] <= front(queue) && front(queue) <= back(queue) &&
           back(queue) <= end_seat_[queue];
  }

  // Recomputes the state that has_room() caches; for checks.
  bool is_ready_for_batch(const Slots& slots) {
    const uint32_t end = area_[0].first + area_[0].slots;
    bool is_ready = end_ == end && has_room_for(slots, 0);
    for (uint32_t queue = 0; queue < queue_codes; ++queue)
      is_ready = is_ready && is_within_seats(queue) &&
                 free_seats(queue) >= (is_at_seam(queue) ? max_across : Edges::max_edges);
    return is_ready;
  }

  uint32_t reserve() const { return slots_per_node * (top_ - area_[0].first + max_new); }
  bool has_room_for(const Slots& slots, uint32_t nodes) const {
    return top_ + nodes + max_new <= end_ &&
           slots.available() >= reserve() + slots_per_node * nodes;
  }
  Area new_area(Slots& slots, uint32_t count);
  void release(Slots& slots, const Area& area);
  bool ensure_spare_area(Slots& slots, uint32_t count);
  bool has_free_seats() {
    return min_free_seats_ >= Edges::max_edges && free_seats(seam_tails) >= max_across &&
           free_seats(seam_begins) >= max_across;
  }
  bool grow_queues(Slots& slots);
  void find_min_free_seats();
  void grow_queue(Slots& slots, uint32_t queue);
  void mark_tails(Slots& slots);
  void copy_open(Slots& slots);
  bool follow_to_join(Slots& slots, uint32_t at);

  ChainCapacities capacities_;
  Area area_[2] = {};            // the first holds the nodes; the other is free
  uint32_t top_ = 0;             // behind the last node
  uint32_t end_ = 0;             // the limit of top_
  uint32_t min_free_seats_ = 0;  // of all queues but those of the seam
  uint32_t complete_ = 0;        // complete fragments, the first of seam_begins
  uint32_t joins_ = 0;           // joins of the last batch, in join_
  uint32_t next_join_ = 0;       // the first join that find_ring() has not followed
  uint32_t ring_ = 0;            // the join of the found ring
  uint32_t corner_count_ = 0;    // of the found ring, in corner_
  // Per queue: the next seat of arriving chains, and of leaving chains. An arriving chain removes
  // an end from a queue of tails, or adds an end to a queue of begins.
  uint32_t next_in_seat_[queue_codes] = {};
  uint32_t next_out_seat_[queue_codes] = {};
  uint32_t first_seat_[queue_codes] = {};
  uint32_t end_seat_[queue_codes] = {};
  uint32_t join_[ChainCapacities::max_joins + 1] = {};
  uint64_t corner_[2 * (max_corners + 2)] = {};
};

}  // namespace discmc::host

#endif
