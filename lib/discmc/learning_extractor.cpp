// Extractors that learn: a file of their own, so that firmware does not link them.
#include <discmc/learning_extractor.hpp>
#include <discmc/trace/extractor_definitions.hpp>

namespace discmc {

#define DISCMC_INSTANTIATE(Index)                                                          \
  template class Extractor<Index, NoNormals, trace::LearntPasses>;                         \
  template PushResult LearningExtractor<Index>::push(const uint8_t*, uint32_t, uint32_t);  \
  template PushResult LearningExtractor<Index>::push(const uint16_t*, uint32_t, uint32_t); \
  template PushResult LearningExtractor<Index>::push(const int16_t*, uint32_t, uint32_t);

DISCMC_INSTANTIATE(uint16_t)
DISCMC_INSTANTIATE(uint32_t)
#undef DISCMC_INSTANTIATE

}  // namespace discmc
