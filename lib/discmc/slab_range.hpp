// Which slices of a volume a stream holds: a standard application record, for whoever joins the
// streams of slabs.
#ifndef DISCMC_SLAB_RANGE_HPP
#define DISCMC_SLAB_RANGE_HPP

#include <discmc/application_record.hpp>

namespace discmc {

/// The own slices of a slab, without those of its neighbours that its extractor was given as well.
/// A stream that was joined of several slabs has a record for each range of theirs; one of a whole
/// volume has none. Units: slices.
struct SlabRange {
  uint32_t first = 0;
  uint32_t slices = 0;
  uint32_t depth = 0;  ///< of the volume; Limit: at least first + slices

  /// The slice after the last one.
  constexpr uint32_t end() const { return first + slices; }

  static constexpr uint8_t record_kind = ApplicationRecord::first_standard_kind + 1;
  static constexpr size_t record_bytes = 12;
};

/// The record of a slab, for tell(), at any time in its scan. bytes: room for
/// SlabRange::record_bytes, which are written; Owner: the caller, until the record has been told.
ApplicationRecord record_of(const SlabRange& range, uint8_t* bytes);

/// Reads the range in a record. False, and nothing is written, where it holds none: the kind is
/// another, or the number of bytes, or the slices are none, or beyond the depth.
[[nodiscard]] bool read_slab_range(const ApplicationRecord& record, SlabRange& range);

}  // namespace discmc

#endif
