// An extractor for hosts, which remembers what it has worked out of neighbourhoods.
//
// The events are those of any other. With 2 MiB to learn in, a scan takes about two thirds of the
// instructions. The object is 23 KiB larger.
#ifndef DISCMC_LEARNING_EXTRACTOR_HPP
#define DISCMC_LEARNING_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include <discmc/trace/learnt_passes.hpp>

namespace discmc {

/// Give it memory with learn_in(), before push().
template <class Index, class Normals = NoNormals>
using LearningExtractor = Extractor<Index, Normals, trace::LearntPasses>;

}  // namespace discmc

#endif
