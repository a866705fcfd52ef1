// Extractors with gradient normals, in a file of their own so that plain scanners do not link them.
#include <discmc/normal_extractor.hpp>
#include <discmc/trace/extractor_definitions.hpp>

namespace discmc {

// NOLINTBEGIN(bugprone-macro-parentheses): the arguments are types.
#define DISCMC_INSTANTIATE(Index, Sample)                                           \
  template class BasicExtractor<Index, detail::trace::GradientIntake<Sample>,       \
                                detail::trace::Sweep<Index, OctahedralNormal>>;     \
  template PushResult NormalExtractor<Index, Sample>::BasicExtractor::push_samples( \
      const Sample*, uint32_t, uint32_t);
// NOLINTEND(bugprone-macro-parentheses)

DISCMC_INSTANTIATE(uint16_t, uint8_t)
DISCMC_INSTANTIATE(uint16_t, uint16_t)
DISCMC_INSTANTIATE(uint16_t, int16_t)
DISCMC_INSTANTIATE(uint32_t, uint8_t)
DISCMC_INSTANTIATE(uint32_t, uint16_t)
DISCMC_INSTANTIATE(uint32_t, int16_t)
#undef DISCMC_INSTANTIATE

}  // namespace discmc
