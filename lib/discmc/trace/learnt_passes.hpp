// The passes of a neighbourhood, worked out once and remembered: for hosts, which have memory.
//
// A table without chains: a neighbourhood has one place in it, and what is found there by the next
// with the same place is forgotten. Edges are collected, looked up and taken many at a time, each
// in a loop of its own: so hardly a branch depends on the surface, and look-ups do not wait for one
// another.
#ifndef DISCMC_TRACE_LEARNT_PASSES_HPP
#define DISCMC_TRACE_LEARNT_PASSES_HPP

#include <discmc/arena.hpp>
#include <discmc/trace/passes.hpp>
#include <discmc/trace/swept_row.hpp>

namespace discmc::trace {

/// What DerivedPasses finds, found faster.
class LearntPasses {
 public:
  /// Forgets everything, and remembers in this memory from now on, however it is aligned: in the
  /// largest power of two of entries of 40 bytes that has room, 2^20 at most. Without memory, or
  /// with too little for anything, passes are worked out every time. Cost: 8 bytes cleared an
  /// entry.
  void learn_in(Memory memory);

  // As DerivedPasses has them.
  static constexpr bool finds_many = true;
  void clear() { word_ = passes_ = next_ = 0; }
  bool find(const SweptRow& row, SweepCounts& counts);
  bool has_next() const { return next_ < passes_; }
  const Pass& pass() const { return pass_[next_]; }
  const Vertex& vertex() const { return vertex_[of_[next_]]; }
  void advance() { ++next_; }
  /// How many have been found and not taken.
  uint32_t left() const { return passes_ - next_; }

 private:
  static constexpr uint32_t most_entry_bits = 20;
  static constexpr uint32_t count_bits = 3;
  // Of those with more there are few.
  static constexpr uint32_t most_learnt = 4;
  // Edges at a time: those of a word and many more.
  static constexpr uint32_t most_edges = 256;
  static constexpr uint32_t most_passes = most_edges * PassList::most;

  struct Edge {
    uint32_t key;  // the 27 voxels around the voxel less those not around the edge, and the axis
    uint32_t x;
  };
  struct Known {
    uint32_t code;  // the key, and in the lowest bits how many passes there are; 0 if nothing
    uint32_t parts;
  };
  struct Learnt {
    Pass pass[most_learnt];
  };

  uint32_t collect(const SweptRow& row);
  void look_up(uint32_t edges, const SweptRow& row, SweepCounts& counts);
  void derive(const SweptRow& row, const Edge& edge, uint32_t absent, PassList& passes) const;
  void learn(uint32_t key, uint32_t place, const PassList& passes);

  Known* known_ = nullptr;
  Learnt* learnt_ = nullptr;
  uint32_t shift_ = 31;

  uint32_t word_ = 0;  // the next whose edges are to be collected
  uint32_t passes_ = 0;
  uint32_t next_ = 0;
  Edge edge_[most_edges + 3];
  Vertex vertex_[most_edges];
  Pass pass_[most_passes + most_learnt];
  uint8_t of_[most_passes + most_learnt];  // the vertex of a pass
};

}  // namespace discmc::trace

#endif
