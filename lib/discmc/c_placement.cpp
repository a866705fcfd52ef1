// discmc.h in terms of the C++ library: where a volume lies. A file of its own, so that firmware
// which only scans does not carry it.
#include <discmc/discmc.h>

#include <discmc/c_values.hpp>
#include <discmc/placement.hpp>

namespace discmc {

namespace {

#define DISCMC_SAME_PLACE(member) \
  (offsetof(Placement, member) == offsetof(discmc_placement, member))
static_assert(sizeof(Placement) == sizeof(discmc_placement) && DISCMC_SAME_PLACE(axes_nm) &&
                  DISCMC_SAME_PLACE(origin_nm) && DISCMC_SAME_PLACE(frame),
              "placements have one layout");
#undef DISCMC_SAME_PLACE
static_assert(DISCMC_PLACEMENT_BYTES == Placement::record_bytes &&
                  DISCMC_PLACEMENT_KIND == Placement::record_kind,
              "constants are the same");
static_assert(DISCMC_FRAME_NONE == static_cast<int>(Frame::none) &&
                  DISCMC_FRAME_LPS == static_cast<int>(Frame::lps) &&
                  DISCMC_FRAME_RAS == static_cast<int>(Frame::ras),
              "enumerations are in the same order");

}  // namespace

extern "C" {

discmc_application_record discmc_placement_record(const discmc_placement* placement,
                                                  uint8_t* bytes) {
  return c(record_of(*reinterpret_cast<const Placement*>(placement), bytes));
}
uint8_t discmc_read_placement(const discmc_application_record* record,
                              discmc_placement* placement) {
  return read_placement(cpp(*record), *reinterpret_cast<Placement*>(placement)) ? 1 : 0;
}

}  // extern "C"

}  // namespace discmc
