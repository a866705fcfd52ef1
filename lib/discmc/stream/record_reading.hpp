// Reads records from a packet. Any symbols are safe.
#ifndef DISCMC_STREAM_RECORD_READING_HPP
#define DISCMC_STREAM_RECORD_READING_HPP

#include <discmc/stream/symbol_coders.hpp>

namespace discmc::detail::stream {

using ReadingModel = RecordModel<SymbolReader>;

/// Read a region, a loose fragment or a part after its kind. Return false if no encoder wrote it.
bool read_region(ReadingModel& model, Record& record, RecordKind kind);
bool read_fragment(ReadingModel& model, Record& record, RecordKind kind);
bool read_part(ReadingModel& model, Record& record);

/// A vector in a plane, in the coordinates of PlaneStep. Limit: below 2^28.
struct PlaneVector {
  int32_t u, v;
};

/// The lengths of the last two runs of a ring, which follow from the vector back to its start.
struct Closure {
  bool is_valid;
  uint32_t first, second;
};

/// Solves for the lengths of two steps that are not parallel and add up to a vector. Invalid if no
/// two lengths of 1 to max_compact_length do.
Closure close_ring(PlaneStep a, PlaneStep b, PlaneVector vector);

/// Returns the run along a vector; empty if no run of at most max_compact_length matches.
Run run_along(const PlaneStep* steps, uint32_t directions, PlaneVector vector);

}  // namespace discmc::detail::stream

#endif
