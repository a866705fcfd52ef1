// Runs events through a joiner in memory of its exact size.
#pragma once

#include <discmc/joiner.hpp>
#include <stdexcept>

#include "event_log.hpp"
#include "scan.hpp"

namespace discmc::reference {

struct Joined {
  Events events;
  JoinReport report;
  JoinCapacities peaks;
  Status status;
};

struct JoinPlan {
  InputOrder order = InputOrder::sweep;
  JoinCapacities capacities{2000, 20000};
  Unjoined unjoined = Unjoined::passed_on;
  EventLog::Refuses refuses{};
};

/// Returns room for all fragments of the events at once.
inline JoinCapacities enough_for(const Events& events) {
  JoinCapacities capacities{1, 1};
  for (const RecordedEvent& event : events) {
    if (event.is(Event::Kind::fragment)) ++capacities.fragments;
    if (event.is(Event::Kind::run)) ++capacities.runs;
  }
  return capacities;
}

/// Offers every event until it is accepted, then finishes. Errors: throws if the joiner does not
/// progress, accepts an event later than its sink, breaks a promise, or writes outside its memory.
inline Joined join_all(const Events& events, const JoinPlan& plan) {
  const int max_tries = plan.refuses ? 1 << 20 : 1;
  Block block(Joiner::bytes_for(plan.capacities), Block::Kind::guarded);
  EventLog log(plan.refuses);
  Joiner joiner;
  require_ok(
      joiner.start(plan.capacities, block.memory(), make_sink(log), plan.order, plan.unjoined));
  for (const RecordedEvent& event : events)
    for (int tries = 1; joiner.accept(event.event()) != SinkResult::accepted; ++tries)
      if (tries >= max_tries) throw std::runtime_error("an event that is never accepted");
  Status status = joiner.finish();
  for (int tries = 1; status == Status::suspended; ++tries) {
    if (tries >= max_tries) throw std::runtime_error("no end");
    status = joiner.finish();
  }
  if (!block.is_intact()) throw std::runtime_error("a write outside the memory");
  const JoinCapacities peaks = joiner.peaks();
  if (peaks.fragments > plan.capacities.fragments || peaks.runs > plan.capacities.runs)
    throw std::runtime_error("in use beyond the capacity");
  return {std::move(log.events), joiner.report(), peaks, status};
}

}  // namespace discmc::reference
