// What the extractors of the C API share: their storage, and values of C's as those of C++.
#ifndef DISCMC_C_EXTRACTORS_HPP
#define DISCMC_C_EXTRACTORS_HPP

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/extractor.hpp>

namespace discmc {

inline Capacities cpp(const discmc_capacities& from) {
  return {from.records, from.holes};
}
inline discmc_capacities c(const Capacities& from) {
  return {from.records, from.holes};
}
inline discmc_high_water c(const HighWater& from) {
  return {from.records, from.holes};
}

/// capacities: null for as many records as the memory has room for.
template <class AnyExtractor>
discmc_status start(SinkAdapter<AnyExtractor>& adapter, const discmc_limits* limits,
                    const discmc_capacities* capacities, int32_t threshold, discmc_memory memory,
                    const discmc_sink* sink) {
  return adapter.start_to(*sink, [&](const Sink& to) {
    const Memory bytes = cpp(memory);
    return capacities == nullptr
               ? adapter.object.start(cpp(*limits), threshold, bytes, to)
               : adapter.object.start(cpp(*limits), cpp(*capacities), threshold, bytes, to);
  });
}

/// checkpoint: storage of C's.
template <class AnyExtractor, class CheckpointOfC>
discmc_status save(const AnyExtractor& extractor, CheckpointOfC* checkpoint) {
  return c(extractor.save(*reinterpret_cast<Checkpoint<AnyExtractor>*>(checkpoint)));
}
template <class AnyExtractor, class CheckpointOfC>
discmc_status restore(SinkAdapter<AnyExtractor>& adapter, const CheckpointOfC* checkpoint,
                      discmc_memory memory, const discmc_sink* sink) {
  return adapter.start_to(*sink, [&](const Sink& to) {
    return adapter.object.restore(*reinterpret_cast<const Checkpoint<AnyExtractor>*>(checkpoint),
                                  cpp(memory), to);
  });
}

}  // namespace discmc

#endif
