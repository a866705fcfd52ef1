// An extractor for hosts, which take half of the instructions with it.
//
// It remembers what it works out of neighbourhoods, and keeps fragments as lists of corners while
// it has memory to spare: from 37,120 records on, some 600 KiB, and ten for each corner that waits.
// Then it goes on as any other extractor. The events are the same, as long as nothing goes out
// loose; what does may be other pieces of the same regions. high_water() counts what corners take,
// so it does not tell what firmware would need. The object is 137 KiB larger.
#ifndef DISCMC_LEARNING_EXTRACTOR_HPP
#define DISCMC_LEARNING_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include <discmc/trace/corner_sweep.hpp>

namespace discmc {

/// Give it memory with learn_in(), before push().
using LearningExtractor = Extractor<uint32_t, NoNormals, trace::CornerSweep>;

}  // namespace discmc

#endif
