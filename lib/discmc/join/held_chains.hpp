// The chains that a joiner holds: fragments, and the rings that they become.
#ifndef DISCMC_JOIN_HELD_CHAINS_HPP
#define DISCMC_JOIN_HELD_CHAINS_HPP

#include <discmc/chain.hpp>
#include <discmc/join/waiting_table.hpp>
#include <discmc/normal.hpp>
#include <discmc/pool.hpp>

namespace discmc::join {

constexpr uint32_t no_chain = no_slot, no_run = no_slot;

/// A run of a chain, and the normal where it starts.
struct HeldRun {
  uint32_t next;  ///< no_run behind the last
  Run run;
  OctahedralNormal normal;
};

struct HeldChain {
  enum class State : uint8_t {
    unused,
    open,
    outer,
    hole,
    hole_inside,   ///< of the region under way, as far as its runs have gone
    hole_claimed,  ///< by that region
  };

  uint32_t next;  ///< of a ring in a list of rings
  uint32_t first_run;
  uint32_t last_run;
  Vertex start;
  Vertex end;         ///< of an open one
  int32_t low, high;  ///< from where to where it reaches, along v (chain.hpp)
  Incidence incidence;
  Direction incoming;  ///< the direction of the link by which it came to its start
  uint8_t turn;        ///< the sum of its turns, the one at its start included, modulo 256
  State state;

  constexpr bool is_hole() const { return state >= State::hole; }
};

static_assert(sizeof(HeldChain) == 48 && sizeof(HeldRun) == 12, "what joiner.hpp reckons with");

/// Chains and their runs in two pools, named by index from 1 on. Owner: the slots lie in the
/// arena. Cost of every function but contains() and give(): a few instructions.
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

  /// An open chain without runs, or no_chain when there is no room.
  uint32_t take(Incidence incidence, const Vertex& start, Direction incoming);

  /// Gives a chain back, and its runs. Cost: its runs.
  void give(uint32_t chain);

  /// Puts a run behind a chain. False when there is no room; then nothing has changed.
  bool append(uint32_t index, Run run, OctahedralNormal normal);

  /// Puts another chain behind the one at whose end it starts; the other is then no more.
  void join(uint32_t index, uint32_t other_index);

  /// Makes a ring of a chain that ends where it starts, after two runs at least: outer when it
  /// turns left, else a hole.
  void close(uint32_t index);

  void drop_first_run(uint32_t index);

  HeldChain& operator[](uint32_t chain) { return chains_[chain]; }
  const HeldChain& operator[](uint32_t chain) const { return chains_[chain]; }
  const HeldRun& run(uint32_t index) const { return runs_[index]; }

  /// The directed link that comes before a chain and the one that ends it, as keys to match by.
  WaitingKey start_key(uint32_t index) const;
  WaitingKey end_key(uint32_t index) const;

  /// A point of the region beside a ring.
  PlanePoint point_beside(uint32_t index) const;
  /// Whether a ring goes round a point of its plane. Cost: its runs, where it reaches so far.
  bool contains(uint32_t index, const PlanePoint& point) const;

  /// No chain in use has a larger index.
  uint32_t last_used() const { return chains_.high_water(); }
  uint32_t high_water() const { return chains_.high_water(); }
  uint32_t run_high_water() const { return runs_.high_water(); }

 private:
  Pool<HeldChain, uint32_t> chains_;
  Pool<HeldRun, uint32_t> runs_;
};

}  // namespace discmc::join

#endif
