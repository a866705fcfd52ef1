// discmc.h in terms of the C++ library: which slices a stream holds. A file of its own, so that
// firmware which scans whole volumes does not carry it.
#include <discmc/discmc.h>

#include <discmc/c_values.hpp>
#include <discmc/slab_range.hpp>

namespace discmc {

static_assert(DISCMC_SLAB_RANGE_BYTES == SlabRange::record_bytes &&
                  DISCMC_SLAB_RANGE_KIND == SlabRange::record_kind,
              "constants are the same");

extern "C" {

discmc_application_record discmc_slab_range_record(const discmc_slab_range* range, uint8_t* bytes) {
  return c(record_of(SlabRange{range->first, range->slices, range->depth}, bytes));
}
uint8_t discmc_read_slab_range(const discmc_application_record* record, discmc_slab_range* range) {
  SlabRange read;
  if (!read_slab_range(cpp(*record), read)) return 0;
  *range = {read.first, read.slices, read.depth};
  return 1;
}

}  // extern "C"

}  // namespace discmc
