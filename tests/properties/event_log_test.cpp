// The recorder of events: how it compares events, and that refused events are offered again.
#include "oracle/event_log.hpp"

#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

Event event_of(Event::Kind kind) {
  static const Statistics none{};
  Event event{};
  event.kind = kind;
  event.statistics = &none;
  return event;
}

// Whether events of a kind differ that differ in what `change` does.
template <class Change>
bool tells(Event::Kind kind, Change change) {
  Event changed = event_of(kind);
  change(changed);
  return RecordedEvent(changed) != RecordedEvent(event_of(kind));
}

}  // namespace

TEST_CASE("events are equal if the members of their kind are equal") {
  using Kind = Event::Kind;
  const auto incidence = [](Event& event) { event.incidence = 3; };
  const auto hole = [](Event& event) { event.is_hole = true; };
  const auto start = [](Event& event) { event.start = {0, 0, -1}; };
  const auto run = [](Event& event) { event.run = Run::straight(2, 5); };
  const auto normal = [](Event& event) { event.normal = {7, 9}; };
  const auto slice = [](Event& event) { event.slice = 1; };
  const auto row = [](Event& event) { event.row = 1; };
  const auto came = [](Event& event) { event.incoming_direction = 2; };
  const auto totals = [](Event& event) {
    static const Statistics some{0, 0, 0, 0, 0, 1, 0, 0};
    event.statistics = &some;
  };
  CHECK(tells(Kind::region, incidence));
  CHECK(tells(Kind::ring, hole));
  CHECK(tells(Kind::ring, start));
  CHECK(tells(Kind::run, run));
  CHECK(tells(Kind::run, normal));
  CHECK(tells(Kind::fragment, start));
  CHECK(tells(Kind::fragment, came));
  CHECK(tells(Kind::skipped, row));
  CHECK(tells(Kind::layer, slice));
  CHECK(tells(Kind::finish, totals));
  CHECK_FALSE(tells(Kind::region, run));
  CHECK_FALSE(tells(Kind::ring, normal));
  CHECK_FALSE(tells(Kind::layer, row));
  CHECK_FALSE(tells(Kind::layer, totals));
  CHECK_FALSE(tells(Kind::lost, incidence));
}

TEST_CASE("an event is recorded once, when it is accepted") {
  EventLog log(refuses_first);
  const Event layer = event_of(Event::Kind::layer);
  for (int i = 0; i < 3; ++i) {
    CHECK(log.accept(layer) == SinkResult::busy);
    CHECK(log.accept(layer) == SinkResult::accepted);
  }
  CHECK(log.refusals() == 3);
  CHECK(log.events == Events(3, RecordedEvent(layer)));
}

TEST_CASE("an event that differs from the refused one is detected") {
  EventLog log(refuses_first);
  CHECK(log.accept(event_of(Event::Kind::layer)) == SinkResult::busy);
  CHECK_THROWS_AS(log.accept(event_of(Event::Kind::finish)), GrammarError);
}
