// Events of the C API as those of C++, so that the two can be compared.
#ifndef DISCMC_TESTS_ORACLE_C_EVENTS_HPP
#define DISCMC_TESTS_ORACLE_C_EVENTS_HPP

#include <discmc/discmc.h>

#include "event_log.hpp"

namespace discmc::reference {

inline Statistics from_c(const discmc_statistics& s) {
  return {s.cells, s.facets, s.classic_triangles, s.regions,
          s.rings, s.links,  s.fragments,         s.skipped_rows};
}

inline StreamHeader from_c(const discmc_stream_header& header) {
  return {
      header.width,
      header.height,
      header.depth,
      {header.spacing_nm[0], header.spacing_nm[1], header.spacing_nm[2]},
      header.threshold,
      static_cast<Border>(header.border),
      header.channel,
      header.scan,
      header.further_surfaces,
      {header.further_thresholds[0], header.further_thresholds[1], header.further_thresholds[2]}};
}

inline ApplicationRecord from_c(const discmc_application_record& record) {
  return {record.kind, record.slice, record.row, record.bytes, record.count};
}

inline RecordedEvent from_c(const discmc_event& event) {
  Event same{};
  same.kind = static_cast<Event::Kind>(event.kind);
  same.incidence = event.incidence;
  same.came = event.came;
  same.hole = event.hole != 0;
  same.repeated = event.repeated != 0;
  same.abandoned = event.abandoned != 0;
  same.normal = {event.normal.u, event.normal.v};
  same.run = Run::from_code(event.run);
  same.slice = event.slice;
  same.row = event.row;
  same.start = {event.start.x, event.start.y, event.start.z};
  Statistics statistics{};
  StreamHeader header;
  ApplicationRecord application;
  if (same.kind == Event::Kind::finish) {
    statistics = from_c(*event.of.statistics);
    same.statistics = &statistics;
  } else if (same.kind == Event::Kind::start) {
    header = from_c(*event.of.header);
    same.header = &header;
  } else if (same.kind == Event::Kind::application) {
    application = from_c(*event.of.application);
    same.application = &application;
  }
  return RecordedEvent(same);
}

/// An event as C sees it: both sides have one layout.
inline const discmc_event* to_c(const Event& event) {
  return reinterpret_cast<const discmc_event*>(&event);
}

inline discmc_limits to_c(const Limits& limits) {
  return {limits.width,
          limits.height,
          static_cast<uint8_t>(limits.border),
          {limits.slab.first, limits.slab.continues_below, limits.slab.continues_above}};
}

/// An EventLog as a sink of the C API. Owner: the log must outlive the sink.
inline discmc_sink c_sink_to(EventLog& log) {
  const auto take = [](void* context, const discmc_event* event) {
    const Answer answer = static_cast<EventLog*>(context)->take(from_c(*event).event());
    return static_cast<discmc_answer>(answer);
  };
  return {&log, take};
}

}  // namespace discmc::reference

#endif
