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

/// A way in a plane, in the coordinates of PlaneStep. Limit: below 2^28.
struct PlaneWay {
  int32_t u, v;
};

/// The lengths of the last two runs of a ring, which follow from the way that is left.
struct Closure {
  bool is_valid;
  uint32_t first, second;
};

/// Goes a way by two steps that are not parallel. Invalid where no two lengths of 1 to
/// max_compact_length do it.
Closure close_ring(PlaneStep a, PlaneStep b, PlaneWay way);

/// The run that goes a way; empty where no run of at most max_compact_length does.
Run run_along(const PlaneStep* steps, uint32_t directions, PlaneWay way);

}  // namespace discmc::stream

#endif
