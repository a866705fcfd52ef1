// Extractors that learn: a file of their own, so that firmware does not link them.
#include <discmc/learning_extractor.hpp>
#include <discmc/trace/extractor_definitions.hpp>

namespace discmc {

// NOLINTBEGIN(bugprone-macro-parentheses): the arguments are types.
#define DISCMC_INSTANTIATE_PUSH(Index, Normals, Sample) \
  template PushResult LearningExtractor<Index, Normals>::push(const Sample*, uint32_t, uint32_t);
#define DISCMC_INSTANTIATE_WITH_NORMALS(Index, Sample)                           \
  template class Extractor<Index, GradientNormals<Sample>, trace::LearntPasses>; \
  DISCMC_INSTANTIATE_PUSH(Index, GradientNormals<Sample>, Sample)
#define DISCMC_INSTANTIATE(Index)                                  \
  template class Extractor<Index, NoNormals, trace::LearntPasses>; \
  DISCMC_INSTANTIATE_PUSH(Index, NoNormals, uint8_t)               \
  DISCMC_INSTANTIATE_PUSH(Index, NoNormals, uint16_t)              \
  DISCMC_INSTANTIATE_PUSH(Index, NoNormals, int16_t)               \
  DISCMC_INSTANTIATE_WITH_NORMALS(Index, uint8_t)                  \
  DISCMC_INSTANTIATE_WITH_NORMALS(Index, uint16_t)                 \
  DISCMC_INSTANTIATE_WITH_NORMALS(Index, int16_t)
// NOLINTEND(bugprone-macro-parentheses)

DISCMC_INSTANTIATE(uint16_t)
DISCMC_INSTANTIATE(uint32_t)
#undef DISCMC_INSTANTIATE
#undef DISCMC_INSTANTIATE_WITH_NORMALS
#undef DISCMC_INSTANTIATE_PUSH

}  // namespace discmc
