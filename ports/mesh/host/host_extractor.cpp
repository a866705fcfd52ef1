// The extractor for hosts: a file of its own, so that firmware does not link it.
#include "host_extractor.hpp"
#include <discmc/trace/extractor_definitions.hpp>

namespace discmc {

template class BasicExtractor<uint32_t, detail::trace::BitIntake, host::Sweep>;
template PushResult HostExtractor::BasicExtractor::push_samples(const uint8_t*, uint32_t, uint32_t);
template PushResult HostExtractor::BasicExtractor::push_samples(const uint16_t*, uint32_t,
                                                                uint32_t);
template PushResult HostExtractor::BasicExtractor::push_samples(const int16_t*, uint32_t, uint32_t);

}  // namespace discmc
