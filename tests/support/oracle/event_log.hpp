// A sink that records accepted events as comparable values.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <discmc/sink.hpp>
#include <discmc/stream/crc32.hpp>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "collector.hpp"

namespace discmc::reference {

inline std::array<uint64_t, 8> counts(const Statistics& s) {
  return {s.cells, s.facets, s.classic_triangles, s.regions,
          s.rings, s.links,  s.fragments,         s.skipped_rows};
}

inline bool are_equal(const StreamHeader& a, const StreamHeader& b) {
  return a.width == b.width && a.height == b.height && a.depth == b.depth &&
         std::equal(a.spacing_nm, a.spacing_nm + 3, b.spacing_nm) &&
         std::equal(a.thresholds, a.thresholds + StreamHeader::max_surfaces, b.thresholds) &&
         a.border == b.border && a.channel == b.channel && a.scan == b.scan &&
         a.surface_count == b.surface_count;
}

/// Calls add(number) with the contents of an event: its kind, then only the members of that kind.
template <class Add>
void for_each_number(const Event& event, Add add) {
  const auto add_all = [&](auto... values) { (add(static_cast<uint64_t>(values)), ...); };
  add_all(event.kind);
  switch (event.kind) {
    case Event::Kind::start:
      add_all(event.header->width, event.header->height, event.header->depth,
              event.header->thresholds[0], event.header->border, event.header->scan,
              event.header->channel, event.header->surface_count);
      for (const int32_t spacing : event.header->spacing_nm) add_all(spacing);
      return;
    case Event::Kind::application:
      add_all(event.application->kind, event.application->slice, event.application->row,
              event.application->count, crc32(event.application->bytes, event.application->count));
      return;
    case Event::Kind::region:
      return add_all(event.incidence);
    case Event::Kind::ring:
      return add_all(event.start.x, event.start.y, event.start.z, event.is_hole);
    case Event::Kind::run:
      // One number holds run and normal; without a normal it equals the run.
      return add_all(uint64_t{event.run.code()} | uint64_t{event.normal.u} << 32 |
                     uint64_t{event.normal.v} << 40);
    case Event::Kind::fragment:
      return add_all(event.incidence, event.incoming_direction, event.start.x, event.start.y,
                     event.start.z);
    case Event::Kind::skipped:
      return add_all(event.slice, event.row, event.is_repeated);
    case Event::Kind::fractions:
      return add_all(event.slice, event.row);
    case Event::Kind::layer:
      return add_all(event.slice);
    case Event::Kind::finish:
      add_all(event.slice, event.is_abandoned);
      for (const uint64_t count : counts(*event.statistics)) add(count);
      return;
    case Event::Kind::region_end:
    case Event::Kind::fragment_end:
    case Event::Kind::lost:
      return;
  }
}

/// An event as a value. Two events are equal if their contents are equal.
class RecordedEvent {
 public:
  explicit RecordedEvent(const Event& event) : event_(event) {
    if (event.kind == Event::Kind::finish) statistics_ = *event.statistics;
    if (event.kind == Event::Kind::start) header_ = *event.header;
    if (event.kind == Event::Kind::application) {
      application_ = *event.application;
      bytes_.assign(application_.bytes, application_.bytes + application_.count);
    }
  }

  Event::Kind kind() const { return event_.kind; }
  bool is(Event::Kind kind) const { return event_.kind == kind; }
  /// Owner: this object must outlive the event.
  Event event() const {
    Event event = event_;
    if (is(Event::Kind::finish)) event.statistics = &statistics_;
    if (is(Event::Kind::start)) event.header = &header_;
    if (is(Event::Kind::application)) {
      application_.bytes = bytes_.data();
      event.application = &application_;
    }
    return event;
  }

  bool operator==(const RecordedEvent& other) const { return numbers() == other.numbers(); }
  bool operator!=(const RecordedEvent& other) const { return !(*this == other); }

 private:
  // Unused numbers are zero. A start has the most.
  std::array<uint64_t, 13> numbers() const {
    std::array<uint64_t, 13> all{};
    size_t count = 0;
    for_each_number(event(), [&](uint64_t number) { all.at(count++) = number; });
    return all;
  }

  Event event_;
  Statistics statistics_{};
  StreamHeader header_;
  mutable ApplicationRecord application_;  // its bytes are after the vector
  std::vector<uint8_t> bytes_;
};

using Events = std::vector<RecordedEvent>;

/// Refuses every offer once, so that the second offer is accepted.
inline bool refuses_first(uint64_t offer) {
  return offer % 2 == 0;
}

/// Refuses an offer if `refuses(number of the offer)`, and records the others. Accepts all starts,
/// and stores their headers separately. Errors: throws GrammarError if another event follows a
/// refused one, or if the events do not end.
class EventLog {
 public:
  using Refuses = std::function<bool(uint64_t offer)>;

  explicit EventLog(Refuses refuses = {}) : refuses_(std::move(refuses)) {}

  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) {
      starts.push_back(*event.header);
      return SinkResult::accepted;
    }
    const RecordedEvent offered(event);
    if (refused_ && *refused_ != offered)
      throw GrammarError("what was refused is not offered again");
    refused_.reset();
    if (refuses_ && refuses_(offers_++)) {
      ++refusals_;
      refused_ = offered;
      return SinkResult::busy;
    }
    if (events.size() == max_events) throw GrammarError("events without end");
    events.push_back(offered);
    return SinkResult::accepted;
  }

  uint64_t refusals() const { return refusals_; }

  Events events;
  std::vector<StreamHeader> starts;

 private:
  static constexpr size_t max_events = 20000000;

  Refuses refuses_;
  uint64_t offers_ = 0;
  uint64_t refusals_ = 0;
  std::optional<RecordedEvent> refused_;  // the last refused event, until it is offered again
};

/// Collects the events with a Collector. Errors: throws GrammarError.
inline Collector collected(const Events& events, const Slab& slab = {}) {
  Collector collector(slab);
  for (const RecordedEvent& event : events) (void)collector.accept(event.event());
  return collector;
}

/// Returns the region of these events, from region to region_end. Likewise a fragment, as one ring.
inline Region region_of(const Events& piece) {
  Region region{};
  Vertex at{};
  for (const RecordedEvent& recorded : piece) {
    const Event event = recorded.event();
    const bool is_fragment = recorded.is(Event::Kind::fragment);
    if (is_fragment || recorded.is(Event::Kind::region)) region.incidence = event.incidence;
    if (is_fragment || recorded.is(Event::Kind::ring)) {
      region.rings.emplace_back();
      at = event.start;
    }
    if (!recorded.is(Event::Kind::run)) continue;
    const Ring side = vertices_of(region.incidence, at, {event.run});
    region.rings.back().insert(region.rings.back().end(), side.begin(), side.end());
    translate(at, region.incidence, event.run.direction(), event.run.length());
  }
  return region;
}

/// Returns the regions, loose fragments and counts of a slab as sorted numbers, independent of
/// their order.
inline std::vector<std::vector<uint64_t>> sorted_parts(const Events& events) {
  std::vector<std::vector<uint64_t>> parts(1);
  for (const RecordedEvent& event : events) {
    for_each_number(event.event(), [&](uint64_t number) { parts.back().push_back(number); });
    if (event.is(Event::Kind::region_end) || event.is(Event::Kind::fragment_end) ||
        event.is(Event::Kind::start) || event.is(Event::Kind::layer))
      parts.emplace_back();
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

}  // namespace discmc::reference
