// A sink for tests: writes down what it takes, refuses what it is told to, and passes the rest on.
#ifndef DISCMC_TESTS_REFERENCE_EVENT_LOG_HPP
#define DISCMC_TESTS_REFERENCE_EVENT_LOG_HPP

#include <cstdint>
#include <discmc/sink.hpp>
#include <functional>
#include <vector>

#include "collect.hpp"

namespace discmc::reference {

/// Appends what an event says to a list of words: the members that its kind names and no others.
inline void write_down(const Event& event, std::vector<uint64_t>& words) {
  const auto add = [&](auto... values) { (words.push_back(static_cast<uint64_t>(values)), ...); };
  add(event.kind);
  switch (event.kind) {
    case Event::Kind::region:
      return add(event.incidence);
    case Event::Kind::ring:
      return add(event.start.x, event.start.y, event.start.z, event.hole);
    case Event::Kind::run:
      // In one word, which without a normal is the run alone.
      return add(uint64_t{event.run.code()} | uint64_t{event.normal.u} << 32 |
                 uint64_t{event.normal.v} << 40);
    case Event::Kind::fragment:
      return add(event.incidence, event.came, event.start.x, event.start.y, event.start.z);
    case Event::Kind::skipped:
      return add(event.slice, event.row, event.repeated);
    case Event::Kind::layer:
      return add(event.slice);
    case Event::Kind::finish: {
      const Statistics& s = *event.statistics;
      add(event.slice, event.abandoned, s.cells, s.facets, s.classic_triangles, s.regions);
      return add(s.rings, s.links, s.fragments, s.skipped_rows);
    }
    case Event::Kind::region_end:
    case Event::Kind::fragment_end:
    case Event::Kind::lost:
      return;
  }
}

/// Refuses an offer where `refuses(number of the offer)` says so. What it takes goes into a list
/// that compares, and to a Collector, which checks it. Errors: GrammarError, also when a refused
/// event is not what is offered next, or the events do not end.
class EventLog {
 public:
  using Refuses = std::function<bool(uint64_t offer)>;

  explicit EventLog(Refuses refuses = {}, bool takes_fragments = true)
      : collector_(takes_fragments), refuses_(std::move(refuses)) {}

  Answer take(const Event& event) {
    if (!refused_.empty()) check_offered_again(event);
    if (refuses_ && refuses_(offers_++)) {
      ++refusals_;
      write_down(event, refused_);
      return Answer::not_now;
    }
    if (++events_ > most_events) throw GrammarError("events without end");
    write_down(event, words_);
    kinds_.push_back(event.kind);
    return collector_.take(event);
  }

  /// All that was taken, in numbers: equal lists mean equal events.
  const std::vector<uint64_t>& words() const { return words_; }
  const std::vector<Event::Kind>& kinds() const { return kinds_; }
  uint64_t events() const { return events_; }
  uint64_t refusals() const { return refusals_; }
  const Collector& collector() const { return collector_; }
  const std::vector<Region>& regions() const { return collector_.regions(); }

 private:
  static constexpr uint64_t most_events = 20000000;

  void check_offered_again(const Event& event) {
    std::vector<uint64_t> offered;
    write_down(event, offered);
    if (offered != refused_) throw GrammarError("what was refused is not offered again");
    refused_.clear();
  }

  Collector collector_;
  Refuses refuses_;
  uint64_t offers_ = 0;
  uint64_t events_ = 0;
  uint64_t refusals_ = 0;
  std::vector<uint64_t> refused_;  // the event that was refused last, until it is offered again
  std::vector<uint64_t> words_;
  std::vector<Event::Kind> kinds_;
};

}  // namespace discmc::reference

#endif
