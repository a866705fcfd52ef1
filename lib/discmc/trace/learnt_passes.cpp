#include <discmc/trace/learnt_passes.hpp>

namespace discmc::trace {

void LearntPasses::learn_in(Memory memory) {
  // What it may take to align the first.
  constexpr size_t lost = Arena::alignment - 1;
  const size_t entries = memory.bytes < lost ? 0 : (memory.bytes - lost) / sizeof(Entry);
  uint32_t bits = 0;
  while (bits < key_bits && size_t{2} << bits <= entries) ++bits;
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
