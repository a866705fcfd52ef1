// The passes of a neighbourhood, worked out once and remembered: for hosts, which have memory.
//
// A table without chains: a neighbourhood has one place in it, and what is found there by the next
// with the same place is forgotten. Passes are named by their numbers, so that what is known of a
// neighbourhood is a quarter of a cache line. Edges are collected and then looked up, many at a
// time, each in a loop of its own: so hardly a branch depends on the surface, and look-ups do not
// wait for one another.
#ifndef DISCMC_HOST_LEARNT_PASSES_HPP
#define DISCMC_HOST_LEARNT_PASSES_HPP

#include <discmc/arena.hpp>
#include <discmc/host/numbered_passes.hpp>
#include <discmc/trace/swept_row.hpp>

namespace discmc::trace {

/// What DerivedPasses finds, found faster.
class LearntPasses {
 public:
  /// Edges at a time: those of a word and some more.
  static constexpr uint32_t max_edges = 128;

  /// Forgets everything, and remembers in this memory from now on, however it is aligned: in the
  /// largest power of two of entries of 16 bytes that has room, 2^20 at most. Without memory, or
  /// with too little for two, passes are worked out every time. Cost: 4 bytes cleared an entry.
  void learn_in(Memory memory);

  /// Begins a row. False when surely no edge crosses there.
  bool begin_row(const SweptRow& row);
  /// Finds the passes of the next words of the row that have any, and counts what it comes by.
  /// False when there are none left.
  bool find(const SweptRow& row, SweepCounts& counts);

  /// What has been found, at so many edges at most, and in which word they begin.
  const FoundPass* begin() const { return pass_; }
  const FoundPass* end() const { return pass_ + count_; }
  uint32_t count() const { return count_; }
  uint32_t edges() const { return edges_; }
  uint32_t first_word() const { return first_word_; }
  const NumberedPasses& numbered() const { return numbered_; }

 private:
  static constexpr uint32_t max_entry_bits = 20;
  static constexpr uint32_t count_bits = 3;
  static constexpr uint32_t max_learnt = (1U << count_bits) - 1;
  static constexpr uint32_t passes_an_entry = 4;
  static constexpr uint32_t max_at_vertex = PassList::most * CornerPass::max_of_pass;

  struct Edge {
    uint64_t voxel;  // at its lower end: CornerCode::position()
    // The 27 voxels around that less those not around the edge, or all where the four cells around
    // the edge may not all take part; and the axis.
    uint32_t key;
  };
  struct Learnt {
    uint32_t known;  // the key, and in the lowest bits how many passes there are; 0 if nothing is
    uint32_t parts;  // of counts: see CountParts
    uint16_t pass[passes_an_entry];  // their numbers

    uint32_t count() const { return known & max_learnt; }
  };

  struct Derived {
    uint32_t count, parts;
  };

  uint32_t collect(const SweptRow& row);
  void mark_incomplete(const SweptRow& row, Edge* end);
  void look_up(const SweptRow& row, SweepCounts& counts);
  Derived derive(const SweptRow& row, const Edge& edge, uint32_t place, FoundPass* found);

  Learnt* learnt_ = nullptr;   // by place
  uint32_t further_bits_ = 0;  // of a place, which has one at least

  uint32_t word_ = 0;  // the next whose edges are to be collected
  uint32_t first_word_ = 0;
  uint32_t edges_ = 0;
  uint32_t count_ = 0;
  Edge edge_[max_edges + 3] = {};
  FoundPass pass_[max_edges * max_at_vertex] = {};
  NumberedPasses numbered_;
};

}  // namespace discmc::trace

#endif
