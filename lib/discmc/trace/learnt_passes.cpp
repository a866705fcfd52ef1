#include <discmc/trace/learnt_passes.hpp>

namespace discmc::trace {

void LearntPasses::learn_in(Memory memory) {
  uint32_t bits = 0;
  while (bits < key_bits && sizeof(Entry) << (bits + 1) <= memory.bytes) ++bits;
  tag_bits_ = key_bits - bits;
  Arena arena(memory);
  entries_ = arena.take<Entry>(1U << bits);
  if (arena.is_exhausted()) entries_ = nullptr;
  for (uint32_t i = 0; entries_ != nullptr && i < 1U << bits; ++i) entries_[i].tag = no_tag;
}

// Apart, so that a look-up stays short.
const PassList& LearntPasses::derived(const EdgePlace& edge, uint32_t absent, PassList& passes) {
  derive_passes(edge, absent, passes);
  return passes;
}

}  // namespace discmc::trace
