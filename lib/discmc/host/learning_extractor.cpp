// The extractor that learns: a file of its own, so that firmware does not link it.
#include <discmc/host/learning_extractor.hpp>
#include <discmc/trace/extractor_definitions.hpp>

namespace discmc {

template class BasicExtractor<uint32_t, BitIntake, trace::CornerSweep>;
template PushResult LearningExtractor::BasicExtractor::push_samples(const uint8_t*, uint32_t,
                                                                    uint32_t);
template PushResult LearningExtractor::BasicExtractor::push_samples(const uint16_t*, uint32_t,
                                                                    uint32_t);
template PushResult LearningExtractor::BasicExtractor::push_samples(const int16_t*, uint32_t,
                                                                    uint32_t);
template Status LearningExtractor::BasicExtractor::save(Checkpoint<LearningExtractor>&) const;
template Status LearningExtractor::BasicExtractor::restore(const Checkpoint<LearningExtractor>&,
                                                           Memory, const Sink&);

}  // namespace discmc
