// Records read from a packet. Any symbols are safe.
#ifndef DISCMC_STREAM_RECORD_READING_HPP
#define DISCMC_STREAM_RECORD_READING_HPP

#include <discmc/stream/symbol_coders.hpp>

namespace discmc::stream {

using ReadingModel = RecordModel<SymbolReader>;

/// The rest of a region, a loose fragment or a part, behind its kind. False when no encoder has
/// written it.
bool read_region(ReadingModel& model, Record& record, RecordKind kind);
bool read_fragment(ReadingModel& model, Record& record, RecordKind kind);
bool read_part(ReadingModel& model, Record& record);

/// The lengths of the last two runs of a ring, which follow from the way that is left.
struct Closure {
  bool is_valid;
  uint32_t first, second;
};

/// Closes a ring by steps a and b, which lead (u, v) on together. When they are parallel there are
/// `first_length` of the first. Invalid where no two lengths of 1 to max_compact_length do it.
/// Limit: |u|, |v| below 2^28.
Closure close_ring(PlaneStep a, PlaneStep b, int32_t u, int32_t v, uint32_t first_length);

}  // namespace discmc::stream

#endif
