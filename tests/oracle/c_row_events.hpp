// Row events of the C API as those of C++, and as numbers that can be compared.
#ifndef DISCMC_TESTS_ORACLE_C_ROW_EVENTS_HPP
#define DISCMC_TESTS_ORACLE_C_ROW_EVENTS_HPP

#include <discmc/slice_decoder.hpp>
#include <vector>

#include "c_events.hpp"

namespace discmc::reference {

/// What a row event says: its kind, then the members that its kind names, and what they point to;
/// bits of so many voxels.
inline std::vector<int64_t> numbers_of(const RowEvent& event, uint32_t width) {
  std::vector<int64_t> numbers{static_cast<int64_t>(event.kind)};
  const auto add = [&](auto... values) { (numbers.push_back(static_cast<int64_t>(values)), ...); };
  const auto add_bytes = [&](const uint8_t* bytes, size_t count) {
    numbers.insert(numbers.end(), bytes, bytes + count);
  };
  switch (event.kind) {
    case RowEvent::Kind::start:
      add(event.header->width, event.header->height, event.header->scan, event.header->channel,
          event.header->further_surfaces, event.header->further_thresholds[2]);
      break;
    case RowEvent::Kind::skipped:
      add(event.repeated);
      [[fallthrough]];
    case RowEvent::Kind::row:
      add(event.slice, event.row, event.channel);
      add_bytes(event.bits, (width + 7) / 8);
      break;
    case RowEvent::Kind::lost:
      add(event.slice, event.row, event.count);
      break;
    case RowEvent::Kind::application:
      add(event.application->kind, event.application->slice, event.application->row);
      add_bytes(event.application->bytes, event.application->count);
      break;
    case RowEvent::Kind::finish:
      add(event.slice, event.abandoned);
      break;
  }
  return numbers;
}

/// header, application: hold what the event then refers to.
inline RowEvent from_c(const discmc_row_event& event, StreamHeader& header,
                       ApplicationRecord& application) {
  RowEvent same{};
  same.kind = static_cast<RowEvent::Kind>(event.kind);
  same.repeated = event.repeated != 0;
  same.abandoned = event.abandoned != 0;
  same.channel = event.channel;
  same.slice = event.slice;
  same.row = event.row;
  same.count = event.count;
  if (event.kind == DISCMC_ROWS_START) {
    header = from_c(*event.of.header);
    same.header = &header;
  } else if (event.kind == DISCMC_ROWS_APPLICATION) {
    application = from_c(*event.of.application);
    same.application = &application;
  } else {
    same.bits = event.of.bits;
  }
  return same;
}

}  // namespace discmc::reference

#endif
