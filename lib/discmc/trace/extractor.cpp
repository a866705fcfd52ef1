// Extractors without normals.
#include <discmc/trace/extractor_definitions.hpp>

namespace discmc {

#define DISCMC_INSTANTIATE(Index)                                                               \
  template class BasicExtractor<Index, detail::trace::BitIntake,                                \
                                detail::trace::Sweep<Index, detail::trace::NoNormal>>;          \
  template PushResult Extractor<Index>::BasicExtractor::push_samples(const uint8_t*, uint32_t,  \
                                                                     uint32_t);                 \
  template PushResult Extractor<Index>::BasicExtractor::push_samples(const uint16_t*, uint32_t, \
                                                                     uint32_t);                 \
  template PushResult Extractor<Index>::BasicExtractor::push_samples(const int16_t*, uint32_t,  \
                                                                     uint32_t);

DISCMC_INSTANTIATE(uint16_t)
DISCMC_INSTANTIATE(uint32_t)
#undef DISCMC_INSTANTIATE

}  // namespace discmc
