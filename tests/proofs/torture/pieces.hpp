// The pieces that the slabs of a volume send, and the surface to which a joiner joins them.
#pragma once

#include <cstdint>
#include <discmc/joiner.hpp>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "oracle/scan.hpp"
#include "surface.hpp"

namespace discmc::torture {

/// The number of refused offers per 256.
class Refusals {
 public:
  Refusals(uint32_t of_256, uint32_t seed) : of_256_(of_256), seed_(seed) {}
  bool refuses() { return of_256_ > 0 && reference::mix(seed_ + ++offers_) >> 56 < of_256_; }

 private:
  uint32_t of_256_;
  uint64_t seed_;
  uint64_t offers_ = 0;
};

/// A sink that refuses some events, in front of another sink. Errors: throws if a refused event is
/// not offered again.
template <class Receiver>
class RefusingSink {
 public:
  RefusingSink(Receiver& receiver, const Refusals& refusals)
      : receiver_(receiver), refusals_(refusals) {}

  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) return receiver_.accept(event);
    if (refused_ && *refused_ != reference::RecordedEvent(event))
      throw std::runtime_error("what was refused is not offered again");
    refused_.reset();
    if (!refusals_.refuses()) return receiver_.accept(event);
    refused_.emplace(event);
    return SinkResult::busy;
  }

 private:
  Receiver& receiver_;
  Refusals refusals_;
  std::optional<reference::RecordedEvent> refused_;
};

/// Collects the events of one slab, without its start.
class Pieces {
 public:
  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) return SinkResult::accepted;
    if (events_.size() == max_events) throw std::runtime_error("events without end");
    events_.push_back(event);
    if (event.kind == Event::Kind::finish) totals_ = *event.statistics;
    needed_.fragments += event.kind == Event::Kind::fragment;
    needed_.runs += event.kind == Event::Kind::run;
    return SinkResult::accepted;
  }

  /// Capacities of a joiner for all fragments.
  JoinCapacities needed() const { return needed_; }

  void send_to(Joiner& joiner) const {
    for (Event event : events_) {
      if (event.kind == Event::Kind::finish) event.statistics = &totals_;
      while (joiner.accept(event) != SinkResult::accepted) {
      }
    }
  }

 private:
  static constexpr size_t max_events = 20000000;

  std::vector<Event> events_;
  Statistics totals_{};
  JoinCapacities needed_{0, 0};
};

/// Joins the pieces of slabs, in this order. Errors: throws if a piece is missing.
inline Surface joined(const std::vector<Pieces>& slabs, uint32_t slices_below, InputOrder order,
                      const Refusals& refusals) {
  JoinCapacities capacities{1, 1};
  for (const Pieces& pieces : slabs) {
    capacities.fragments += pieces.needed().fragments;
    capacities.runs += pieces.needed().runs;
  }
  Surface surface(slices_below);
  RefusingSink<Surface> sink(surface, refusals);
  reference::Block block(Joiner::bytes_for(capacities));
  Joiner joiner;
  reference::require_ok(joiner.start(capacities, block.memory(), make_sink(sink), order));
  for (const Pieces& pieces : slabs) pieces.send_to(joiner);
  reference::finish_all(joiner);
  const JoinReport& report = joiner.report();
  if (!block.is_intact()) throw std::runtime_error("a write outside the joiner's memory");
  if (report.unmatched + report.invalid + report.short_of_memory != 0)
    throw std::runtime_error("fragments that match no other");
  return surface;
}

}  // namespace discmc::torture
