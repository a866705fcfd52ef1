// An extractor for hosts, which take half of the instructions with it.
//
//   static LearningExtractor extractor;
//   extractor.learn_in(learnt);                        // 1 MiB; once, for one scan after another
//   extractor.start(limits, threshold, memory, sink);  // as any extractor, with 600 KiB to spare
//
// It has two memories, which must not overlap. In that of learn_in() it remembers what it works out
// of neighbourhoods: without it the events are the same, but cost more. In that of start() it
// keeps fragments as any extractor, but as lists of corners while there is room: from 37,120
// slots on, some 600 KiB beside the rows, and ten slots for each corner that waits. When that
// is used up it goes on as any other extractor.
//
// The events are the same as of other extractors, as long as nothing goes out loose; what does may
// be other pieces of the same regions. high_water() counts what corners take, so it does not tell
// what firmware would need. The object is 137 KiB larger.
#ifndef DISCMC_LEARNING_EXTRACTOR_HPP
#define DISCMC_LEARNING_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include <discmc/host/corner_sweep.hpp>

namespace discmc {

class LearningExtractor : public BasicExtractor<uint32_t, BitIntake, trace::CornerSweep> {
 public:
  LearningExtractor() = default;

  /// Remembers in this memory, besides that of start(), what it works out of neighbourhoods, from
  /// this scan to the next: 1 MiB is a good size. Call it at any time; what was remembered
  /// elsewhere is forgotten. Nothing is remembered before, and after restore(). Owner: the memory
  /// is the caller's, for as long as scans last. Cost: a quarter of it is written.
  void learn_in(Memory memory) { sweep().learn_in(memory); }

 private:
  friend struct Checkpoint<LearningExtractor>;
  LearningExtractor(const LearningExtractor&) = default;
  LearningExtractor& operator=(const LearningExtractor&) = default;
};

}  // namespace discmc

#endif
