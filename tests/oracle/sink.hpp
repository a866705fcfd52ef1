// A sink for a receiver that takes loose fragments, or for one that takes none.
#ifndef DISCMC_TESTS_ORACLE_SINK_HPP
#define DISCMC_TESTS_ORACLE_SINK_HPP

#include <discmc/sink.hpp>

namespace discmc {

template <class Receiver>
Sink sink_to(Receiver& receiver, bool takes_fragments) {
  return takes_fragments ? sink_to(receiver) : region_sink_to(receiver);
}

}  // namespace discmc

#endif
