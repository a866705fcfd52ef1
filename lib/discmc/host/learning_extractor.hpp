// An extractor for hosts, which take half of the instructions with it.
//
//   static LearningExtractor extractor;
//   extractor.learn_in(learnt);                        // 1 MiB; once, for one scan after another
//   extractor.start(limits, threshold, memory, sink);  // as any extractor, with 600 KiB to spare
//
// It has two memories, which must not overlap. In that of learn_in() it remembers what it works out
// of neighbourhoods: without it the events are the same, but cost more. In that of start() it
// keeps fragments as any extractor, but as lists of corners while there is room: from 37,120
// records on, some 600 KiB beside the rows, and ten records for each corner that waits. When that
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

/// Give it memory with learn_in(), before push(); after restore() once more.
using LearningExtractor = Extractor<uint32_t, NoNormals, trace::CornerSweep>;

}  // namespace discmc

#endif
