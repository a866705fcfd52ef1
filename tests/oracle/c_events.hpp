// Events of the C API as those of C++, so that the two can be compared.
#ifndef DISCMC_TESTS_ORACLE_C_EVENTS_HPP
#define DISCMC_TESTS_ORACLE_C_EVENTS_HPP

#include <discmc/discmc.h>

#include "event_log.hpp"

namespace discmc::reference {

inline Statistics from_c(const discmc_statistics& s) {
  return {s.cells, s.facets, s.classic_triangles, s.regions, s.rings, s.links,
          s.cuts,  s.spills, s.skipped_rows};
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
  same.number = event.number;
  same.slice = event.slice;
  same.row = event.row;
  same.start = {event.start.x, event.start.y, event.start.z};
  Statistics statistics{};
  if (same.kind == Event::Kind::finish) statistics = from_c(*event.statistics);
  same.statistics = &statistics;
  return RecordedEvent(same);
}

}  // namespace discmc::reference

#endif
