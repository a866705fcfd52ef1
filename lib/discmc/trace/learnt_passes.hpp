// The passes of a neighbourhood, worked out once and remembered: for hosts, which have memory.
//
// A table without chains: a neighbourhood has one place in it, and what is found there by the next
// with the same place is forgotten.
#ifndef DISCMC_TRACE_LEARNT_PASSES_HPP
#define DISCMC_TRACE_LEARNT_PASSES_HPP

#include <discmc/arena.hpp>
#include <discmc/trace/passes.hpp>

namespace discmc::trace {

class LearntPasses {
 public:
  /// Forgets everything, and remembers in this memory from now on. Without memory, or with too
  /// little for anything, passes are worked out every time. Cost: a write for every 76 bytes.
  void learn_in(Memory memory);

  /// See DerivedPasses.
  const PassList& at(const EdgePlace& edge, uint32_t absent, PassList& scratch) const {
    // Ends of rows, where cells are absent, are few.
    if (entries_ == nullptr || absent != 0) return derived(edge, absent, scratch);
    // Multiplied by an odd number no two keys become one: so the bits that are not the place tell
    // the keys with one place apart.
    const uint32_t spread = key(edge) * 0x9E375 & (keys - 1);
    Entry& entry = entries_[spread >> tag_bits_];
    const uint32_t tag = spread & ((1U << tag_bits_) - 1);
    if (entry.tag == tag) return entry.passes;
    entry.tag = tag;
    return derived(edge, absent, entry.passes);
  }

 private:
  static constexpr uint32_t key_bits = 20, keys = 1U << key_bits;
  static constexpr uint32_t no_tag = keys;
  struct Entry {
    uint32_t tag;
    PassList passes;
  };

  // The axis, and the 18 voxels of the cells around the edge.
  static uint32_t key(const EdgePlace& edge) {
    const auto& row = edge.rows.row;
    const uint32_t word = edge.word;
    const auto two = [&](int k, int j) { return row[k][j][word] >> edge.bit & 3; };
    const auto three = [&](int k, int j) { return row[k][j][word] >> (edge.bit - 1) & 7; };
    if (edge.axis == 0)
      return two(0, 0) | two(0, 1) << 2 | two(0, 2) << 4 | two(1, 0) << 6 | two(1, 1) << 8 |
             two(1, 2) << 10 | two(2, 0) << 12 | two(2, 1) << 14 | two(2, 2) << 16;
    if (edge.axis == 1)
      return three(0, 1) | three(0, 2) << 3 | three(1, 1) << 6 | three(1, 2) << 9 |
             three(2, 1) << 12 | three(2, 2) << 15 | 1U << 18;
    return three(1, 0) | three(2, 0) << 3 | three(1, 1) << 6 | three(2, 1) << 9 |
           three(1, 2) << 12 | three(2, 2) << 15 | 2U << 18;
  }
  static const PassList& derived(const EdgePlace& edge, uint32_t absent, PassList& passes);

  Entry* entries_ = nullptr;
  uint32_t tag_bits_ = 0;
};

}  // namespace discmc::trace

#endif
