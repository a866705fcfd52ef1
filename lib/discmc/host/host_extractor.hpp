// An extractor for hosts: the same events, several times as fast.
#ifndef DISCMC_HOST_EXTRACTOR_HPP
#define DISCMC_HOST_EXTRACTOR_HPP

#include <discmc/extractor.hpp>
#include <discmc/host/sweep.hpp>

namespace discmc {

class HostExtractor : public BasicExtractor<uint32_t, NoNormals, host::Sweep> {
 public:
  HostExtractor() = default;

 private:
  friend struct Checkpoint<HostExtractor>;
  HostExtractor(const HostExtractor&) = default;
  HostExtractor& operator=(const HostExtractor&) = default;
};

}  // namespace discmc

#endif
