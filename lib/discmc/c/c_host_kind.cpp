// The kind of extractors for hosts. A file of its own: see c_normal_kinds.cpp.
#include <discmc/c/extractor_kind.hpp>
#include <discmc/host/host_extractor.hpp>

const discmc_extractor_kind discmc_host =
    discmc::ExtractorKind<discmc::HostExtractor, discmc::Bits, uint8_t, uint16_t,
                          int16_t>::functions;
