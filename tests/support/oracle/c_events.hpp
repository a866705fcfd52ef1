// Shared by the tests of the C API: converts its events to C++, and allocates memory for objects.
#pragma once

#include <discmc/discmc.h>

#include <algorithm>
#include <discmc/encoder.hpp>

#include "event_log.hpp"

namespace discmc::reference {

inline Statistics from_c(const discmc_statistics& s) {
  return {s.cells, s.facets, s.classic_triangles, s.regions,
          s.rings, s.links,  s.fragments,         s.skipped_rows};
}

inline StreamHeader from_c(const discmc_stream_header& header) {
  StreamHeader converted;
  converted.width = header.width;
  converted.height = header.height;
  converted.depth = header.depth;
  std::copy_n(header.spacing_nm, 3, converted.spacing_nm);
  std::copy_n(header.thresholds, StreamHeader::max_surfaces, converted.thresholds);
  converted.border = static_cast<Border>(header.border);
  converted.channel = header.channel;
  converted.scan = header.scan;
  converted.surface_count = header.surface_count;
  return converted;
}

inline RecordedEvent from_c(const discmc_event& event) {
  Event converted{};
  converted.kind = static_cast<Event::Kind>(event.kind);
  converted.incidence = event.incidence;
  converted.incoming_direction = event.incoming_direction;
  converted.is_hole = event.is_hole != 0;
  converted.is_repeated = event.is_repeated != 0;
  converted.is_abandoned = event.is_abandoned != 0;
  converted.normal = {event.normal[0], event.normal[1]};
  converted.run = Run::from_code(event.run);
  converted.slice = event.slice;
  converted.row = event.row;
  converted.start = {event.start.x, event.start.y, event.start.z};
  Statistics statistics{};
  StreamHeader header;
  ApplicationRecord application;
  if (converted.kind == Event::Kind::finish) {
    statistics = from_c(*event.of.statistics);
    converted.statistics = &statistics;
  } else if (converted.kind == Event::Kind::start) {
    header = from_c(*event.of.header);
    converted.header = &header;
  } else if (converted.kind == Event::Kind::application) {
    const discmc_application_record& record = *event.of.application;
    application = {record.kind, record.slice, record.row, record.bytes, record.count};
    converted.application = &application;
  }
  return RecordedEvent(converted);
}

/// An EventLog as a sink of the C API. Owner: the log must outlive the sink.
inline discmc_sink c_sink_to(EventLog& log) {
  const auto take = [](void* context, const discmc_event* event) {
    const SinkResult answer = static_cast<EventLog*>(context)->accept(from_c(*event).event());
    return static_cast<discmc_sink_result>(answer);
  };
  return {&log, take};
}

inline discmc_byte_output in_c(const ByteOutput& output) {
  return {output.context, output.write, output.unsent, output.max_frame};
}

/// Returns rows of bits: a row of each surface, one after the other.
inline std::vector<uint8_t> bits_of(const std::vector<uint8_t>& samples, size_t width,
                                    const std::vector<int32_t>& thresholds) {
  const size_t row_bytes = (width + 7) / 8, surfaces = thresholds.size();
  std::vector<uint8_t> bits(samples.size() / width * surfaces * row_bytes);
  for (size_t i = 0; i < samples.size(); ++i)
    for (size_t surface = 0; surface < surfaces; ++surface)
      if (samples[i] >= thresholds[surface])
        bits[(i / width * surfaces + surface) * row_bytes + i % width / 8] |=
            static_cast<uint8_t>(1 << i % width % 8);
  return bits;
}

/// Repeats a call while it is suspended.
template <class Call>
discmc_status completed(discmc_status status, Call call) {
  while (status == DISCMC_SUSPENDED) status = call();
  return status;
}

}  // namespace discmc::reference
