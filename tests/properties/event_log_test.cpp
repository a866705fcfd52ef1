// The recorder of events: comparisons, and repeated offers of refused events.
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

// Whether two events of a kind differ after `change`.
template <class Change>
bool is_recorded(Event::Kind kind, Change change) {
  Event changed = event_of(kind);
  change(changed);
  return RecordedEvent(changed) != RecordedEvent(event_of(kind));
}

}  // namespace

TEST_CASE("recorded events are equal if all members of their kind are equal") {
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
  CHECK(is_recorded(Kind::region, incidence));
  CHECK(is_recorded(Kind::ring, hole));
  CHECK(is_recorded(Kind::ring, start));
  CHECK(is_recorded(Kind::run, run));
  CHECK(is_recorded(Kind::run, normal));
  CHECK(is_recorded(Kind::fragment, start));
  CHECK(is_recorded(Kind::fragment, came));
  CHECK(is_recorded(Kind::skipped, row));
  CHECK(is_recorded(Kind::layer, slice));
  CHECK(is_recorded(Kind::finish, totals));
  CHECK_FALSE(is_recorded(Kind::region, run));
  CHECK_FALSE(is_recorded(Kind::ring, normal));
  CHECK_FALSE(is_recorded(Kind::layer, row));
  CHECK_FALSE(is_recorded(Kind::layer, totals));
  CHECK_FALSE(is_recorded(Kind::lost, incidence));
}

TEST_CASE("a refused and repeated event is recorded once, when accepted") {
  EventLog log(refuses_first);
  const Event layer = event_of(Event::Kind::layer);
  for (int i = 0; i < 3; ++i) {
    CHECK(log.accept(layer) == SinkResult::busy);
    CHECK(log.accept(layer) == SinkResult::accepted);
  }
  CHECK(log.refusals() == 3);
  CHECK(log.events == Events(3, RecordedEvent(layer)));
}

TEST_CASE("a repeated event that differs from the refused event is detected") {
  EventLog log(refuses_first);
  CHECK(log.accept(event_of(Event::Kind::layer)) == SinkResult::busy);
  CHECK_THROWS_AS(log.accept(event_of(Event::Kind::finish)), GrammarError);
}
