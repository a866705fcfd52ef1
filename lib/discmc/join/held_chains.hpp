// The chains in a joiner: fragments, and the rings that they become.
#ifndef DISCMC_JOIN_HELD_CHAINS_HPP
#define DISCMC_JOIN_HELD_CHAINS_HPP

#include <discmc/base/pool.hpp>
#include <discmc/chain.hpp>
#include <discmc/join/waiting_table.hpp>
#include <discmc/normal.hpp>

namespace discmc::detail::join {

constexpr uint32_t no_chain = no_slot, no_run = no_slot;

/// A run of a chain, and the normal where it starts.
struct HeldRun {
  uint32_t next;  ///< no_run after the last
  Run run;
  OctahedralNormal normal;
};

/// The data of a ring for the tree of waiting rings: links, and a note of the nearest side before
/// the ring.
struct RingNode {
  uint32_t left, right;
  int32_t crossing;
};

struct HeldChain {
  enum class State : uint8_t { unused, open, outer, hole };

  // Marks of a ring.
  static constexpr uint8_t noted = 1;       ///< a side before it is noted
  static constexpr uint8_t leads_left = 2;  ///< the side leads to the left of its ring
  static constexpr uint8_t sorted = 4;      ///< it is delivered soon
  static constexpr uint8_t within = 8;      ///< another ring inside the same region surrounds it

  uint32_t next;  ///< the next ring in a list
  uint32_t first_run;
  uint32_t last_run;
  Vertex start;
  union {
    Vertex end;     ///< of an open chain
    RingNode node;  ///< of a ring
  };
  int32_t high;         ///< largest v at the ends of its runs (ring_tree.hpp)
  uint32_t next_noted;  ///< next ring in the list of rings with a note
  Incidence incidence;
  Direction incoming;  ///< of the link to its start
  union {
    uint8_t turn;   ///< of an open chain: sum of its turns with the one at its start, mod 256
    uint8_t marks;  ///< of a ring
  };
  State state;

  constexpr bool is_hole() const { return state == State::hole; }
  constexpr bool has(uint8_t mark) const { return (marks & mark) != 0; }
  constexpr void set(uint8_t mark) { marks = static_cast<uint8_t>(marks | mark); }
  constexpr void clear(uint8_t mark) { marks = static_cast<uint8_t>(marks & ~mark); }
};

static_assert(sizeof(HeldChain) == 48 && sizeof(HeldRun) == 12,
              "joiner.hpp computes with these sizes");

/// Chains and their runs in two pools, with indexes from 1 on. Owner: the slots lie in the arena.
/// Cost of every function except freeing: a few instructions.
class HeldChains {
 public:
  /// Call clear() before using it.
  void start(HeldChain* chains, uint32_t chain_capacity, HeldRun* runs, uint32_t run_capacity) {
    chains_.start(chains, chain_capacity);
    runs_.start(runs, run_capacity);
  }
  void clear() {
    chains_.clear();
    runs_.clear();
  }

  /// Lets the caller access free memory.
  DISCMC_ALWAYS_INLINE void unpoison_free() {
    chains_.unpoison_free();
    runs_.unpoison_free();
  }

  /// Allocates an open chain without runs, or returns no_chain if there is no room.
  uint32_t add(Incidence incidence, const Vertex& start, Direction incoming);

  /// Frees a chain and its runs. Cost: its runs.
  void release(uint32_t chain);

  /// Appends a run to a chain. Returns false if there is no room; then nothing has changed.
  bool append(uint32_t index, Run run, OctahedralNormal normal);

  /// Appends another chain, which starts at the end of this one and then no longer exists.
  void join(uint32_t index, uint32_t other_index);

  /// Makes a ring of a chain that ends where it starts and has at least two runs: outer if it turns
  /// left, else a hole.
  void close(uint32_t index);

  void drop_first_run(uint32_t index);

  /// The state of any chain up to peak(), in use or not.
  DISCMC_NO_ADDRESS_CHECK HeldChain::State state(uint32_t chain) const {
    return chains_[chain].state;
  }

  HeldChain& operator[](uint32_t chain) { return chains_[chain]; }
  const HeldChain& operator[](uint32_t chain) const { return chains_[chain]; }
  const HeldRun& run(uint32_t index) const { return runs_[index]; }

  /// The directed link before a chain, and the one that ends it, as keys for matching.
  WaitingKey start_key(uint32_t index) const;
  WaitingKey end_key(uint32_t index) const;

  /// No chain in use has a larger index.
  uint32_t peak() const { return chains_.peak(); }
  uint32_t run_peak() const { return runs_.peak(); }

 private:
  Pool<HeldChain, uint32_t> chains_;
  Pool<HeldRun, uint32_t> runs_;
};

}  // namespace discmc::detail::join

#endif
