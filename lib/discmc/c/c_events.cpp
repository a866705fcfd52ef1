// The text of a status, the queries of events, and checks that both languages have the same layout.
#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/chain.hpp>
#include <discmc/checkpoint_store.hpp>
#include <discmc/joiner.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

static_assert(sizeof(Event) == sizeof(discmc_event) &&
                  offsetof(Event, is_abandoned) == offsetof(discmc_event, is_abandoned) &&
                  offsetof(Event, normal) == offsetof(discmc_event, normal) &&
                  offsetof(Event, run) == offsetof(discmc_event, run) &&
                  offsetof(Event, row) == offsetof(discmc_event, row) &&
                  offsetof(Event, start) == offsetof(discmc_event, start) &&
                  offsetof(Event, statistics) == offsetof(discmc_event, of),
              "events have one layout; the tests compare their members");
static_assert(
    sizeof(StreamHeader) == sizeof(discmc_stream_header) &&
        offsetof(StreamHeader, spacing_nm) == offsetof(discmc_stream_header, spacing_nm) &&
        offsetof(StreamHeader, thresholds) == offsetof(discmc_stream_header, thresholds) &&
        offsetof(StreamHeader, channel) == offsetof(discmc_stream_header, channel) &&
        offsetof(StreamHeader, surface_count) == offsetof(discmc_stream_header, surface_count) &&
        offsetof(StreamHeader, levels) == offsetof(discmc_stream_header, levels),
    "headers have one layout");
static_assert(sizeof(ApplicationRecord) == sizeof(discmc_application_record) &&
                  offsetof(ApplicationRecord, row) == offsetof(discmc_application_record, row) &&
                  offsetof(ApplicationRecord, count) == offsetof(discmc_application_record, count),
              "application records have one layout");
static_assert(sizeof(Statistics) == sizeof(discmc_statistics) &&
                  offsetof(Statistics, regions) == offsetof(discmc_statistics, regions),
              "totals have one layout");
static_assert(DISCMC_DEVICE_ERROR == static_cast<int>(Status::device_error) &&
                  DISCMC_TOO_MANY_SLICES == static_cast<int>(Status::too_many_slices) &&
                  DISCMC_FINISHED == static_cast<int>(Status::finished) &&
                  DISCMC_LOST == static_cast<int>(Event::Kind::lost) &&
                  DISCMC_FRACTIONS == static_cast<int>(Event::Kind::fractions) &&
                  DISCMC_SINK_NOT_STARTED == static_cast<int>(SinkResult::not_started) &&
                  DISCMC_OPEN == static_cast<int>(Border::open) &&
                  DISCMC_SUBSTITUTE_PREVIOUS_ROW == static_cast<int>(Substitute::previous_row) &&
                  DISCMC_ANY_ORDER == static_cast<int>(InputOrder::any),
              "enumerations are in the same order");
static_assert(DISCMC_MAX_EXTENT == Limits::max_extent && DISCMC_MAX_SLICES == Limits::max_slices &&
                  DISCMC_WIRE_VERSION == detail::wire::version &&
                  DISCMC_MAX_FRAME == detail::wire::max_frame &&
                  DISCMC_MAX_CHANNEL == StreamLabel::max_channel &&
                  DISCMC_MAX_SURFACES == StreamHeader::max_surfaces &&
                  DISCMC_ANY_CHANNEL == any_channel &&
                  DISCMC_MAX_RECORD_BYTES == ApplicationRecord::max_bytes &&
                  DISCMC_FIRST_STANDARD_KIND == ApplicationRecord::first_standard_kind &&
                  DISCMC_MAX_PARTS == CheckpointStore::max_parts,
              "constants are the same");

extern "C" {

const char* discmc_status_string(discmc_status status) {
  if (status == DISCMC_BAD_SAMPLES)
    return "the kind does not accept this type of samples, or bits are not a row: push its "
           "type, or whole rows";
  if (status == DISCMC_NO_KIND)
    return "the kind in the config is null: set it, for example to &discmc_plain_u8";
  return to_string(static_cast<Status>(status));
}

discmc_vertex discmc_incidence_normal(uint8_t incidence) {
  return c(incidence_normal(incidence));
}
discmc_vertex discmc_run_vector(uint8_t incidence, uint32_t run) {
  return c(after_run(incidence, {0, 0, 0}, Run::from_code(run)));
}
discmc_vertex discmc_unit_normal(const uint8_t normal[2]) {
  const UnitNormal unit = unit_normal(OctahedralNormal{normal[0], normal[1]});
  return {unit.x, unit.y, unit.z};
}

}  // extern "C"

}  // namespace discmc
