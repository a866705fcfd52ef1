// The events of scans with little memory, and of their regions after a joiner.
#pragma once

#include "hand_made.hpp"
#include "oracle/stream.hpp"
#include "surface/surface_builder.hpp"
#include "test.hpp"

namespace joined_events {

using discmc::Event;
using discmc::test::Events;

/// A scan with so little memory that most regions are sent as fragments.
inline Events pieces() {
  return discmc::test::events_of(discmc::reference::random({20, 20, 20}, 128, 5),
                                 discmc::minimum_capacities());
}

/// options: of the joiner, after its sink.
template <class Joiner, class... Options>
Events joined_by(const Events& events, const Options&... options) {
  discmc::test::EventLog log;
  Joiner joiner(discmc::make_sink(log), options...);
  for (const auto& one : events)
    REQUIRE(joiner.accept(one.event()) == discmc::SinkResult::accepted);
  joiner.finish();
  return log.events;
}

inline std::size_t count(const Events& events, Event::Kind kind) {
  return static_cast<std::size_t>(std::count_if(events.begin(), events.end(),
                                                [kind](const auto& one) { return one.is(kind); }));
}

inline discmc::meshing::SurfaceBuilder built(const Events& events) {
  discmc::meshing::SurfaceBuilder builder;
  for (const auto& one : events) builder.accept(one.event());
  return builder;
}

}  // namespace joined_events
