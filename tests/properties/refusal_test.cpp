// A busy sink changes nothing: for any refused offer, and any way to continue, the events are
// equal.
#include "oracle/event_log.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// How the caller continues after Status::suspended:
enum class Way : uint8_t {
  again,   ///< by the same call, with the remaining samples
  resume,  ///< by resume() until it is ok, then by the same call
  busy,    ///< by pushing nothing, then by the same call; an ending by resume()
};

enum class Ending : uint8_t { finish, abandon };

struct Scenario {
  BitVolume volume;
  Border border = Border::closed;
  Capacities capacities = ample;
  Ending ending = Ending::finish;
  uint32_t samples = 0;  ///< that are pushed; all, or those before abandon()
};

Scenario scenario_of(const BitVolume& volume, Border border) {
  Scenario scenario{volume};
  scenario.border = border;
  scenario.samples = static_cast<uint32_t>(volume.voxels());
  return scenario;
}

template <class Index>
Status go_on(Extractor<Index>& extractor, Way way, const uint8_t* samples) {
  if (way == Way::resume) {
    Status status = extractor.resume();
    while (status == Status::suspended) status = extractor.resume();
    return status;
  }
  if (way == Way::busy) {
    const PushResult pushed = extractor.push(samples, 0);
    if (pushed.samples != 0) throw std::runtime_error("took samples where there are none");
  }
  return Status::ok;
}

template <class Index>
void push_samples(Extractor<Index>& extractor, const Scenario& scenario, Way way) {
  const uint8_t* samples = scenario.volume.on.data();
  for (uint32_t at = 0; at < scenario.samples;) {
    const PushResult pushed = extractor.push(samples + at, scenario.samples - at);
    at += pushed.samples;
    if (pushed.status != Status::suspended) require_ok(pushed.status);
    if (pushed.status == Status::suspended) require_ok(go_on(extractor, way, samples));
  }
}

// After the first call of finish(), resume() continues the ending, even if samples of a push
// remain. A second finish() is not needed.
template <class Index>
void end(Extractor<Index>& extractor, Ending ending, Way way) {
  const auto call = [&] {
    return ending == Ending::finish ? extractor.finish() : extractor.abandon();
  };
  Status status = call();
  while (status == Status::suspended) {
    status = way == Way::again ? call() : extractor.resume();
  }
  require_ok(status);
}

template <class Index>
EventLog run(const Scenario& scenario, EventLog::Refuses refuses = {}, Way way = Way::again) {
  EventLog log(std::move(refuses));
  const Limits limits = limits_of(scenario.volume, scenario.border);
  Block block(Extractor<Index>::bytes_for(limits, scenario.capacities));
  Extractor<Index> extractor;
  require_ok(extractor.start(limits, scenario.capacities, 1, block.memory(), make_sink(log)));
  push_samples(extractor, scenario, way);
  end(extractor, scenario.ending, way);
  if (!block.is_intact()) throw std::runtime_error("a write outside the arena");
  if (!collected(log.events).is_finished())
    throw std::runtime_error("ended without a finish event");
  return log;
}

// Compares a scan with these refusals with the events of `plain`. Empty if they are equal.
std::string difference(const Scenario& scenario, const EventLog& plain, EventLog::Refuses refuses,
                       Way way) {
  try {
    const EventLog log = run<uint16_t>(scenario, std::move(refuses), way);
    if (log.refusals() == 0) return "nothing was refused";
    return log.events == plain.events ? "" : "other events";
  } catch (const std::exception& error) {
    return error.what();
  }
}

// Accepts several events, then refuses until it is opened for another log.
struct Gate {
  EventLog* log;
  uint64_t left;
  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) return log->accept(event);
    if (left == 0) return SinkResult::busy;
    --left;
    return log->accept(event);
  }
};

// A scan that the sink stops after some events, or after a skipped row. Then a reset, and the same
// scan without refusals.
EventLog events_after_reset(const Scenario& scenario, uint64_t accepted, bool skips) {
  EventLog before, after;
  Gate gate{&before, accepted};
  const Limits limits = limits_of(scenario.volume, scenario.border);
  Block block(Extractor16::bytes_for(limits, scenario.capacities));
  Extractor16 extractor;
  require_ok(extractor.start(limits, scenario.capacities, 1, block.memory(), make_sink(gate)));
  if (skips) (void)extractor.skip_row(Substitute::off);
  if (extractor.push(scenario.volume.on.data(), scenario.samples).status == Status::ok)
    (void)extractor.finish();
  require_ok(extractor.reset());
  gate = {&after, UINT64_MAX};
  push_samples(extractor, scenario, Way::again);
  end(extractor, Ending::finish, Way::again);
  return after;
}

constexpr Way ways[] = {Way::again, Way::resume, Way::busy};

void check_every_single_refusal(const Scenario& scenario) {
  const EventLog plain = run<uint16_t>(scenario);
  for (uint64_t k = 0; k < plain.events.size(); k += step(17)) {
    CAPTURE(k);
    const auto refuses = [k](uint64_t offer) { return offer == k; };
    CHECK(difference(scenario, plain, refuses, ways[k % 3]) == "");
  }
}

void check_many_refusals(const Scenario& scenario) {
  const EventLog plain = run<uint16_t>(scenario);
  for (const Way way : ways) {
    // Refuses each event once, each four times, all but every 7th, and at random.
    CHECK(difference(
              scenario, plain, [](uint64_t i) { return i % 2 == 0; }, way) == "");
    CHECK(difference(
              scenario, plain, [](uint64_t i) { return i % 5 != 4; }, way) == "");
    CHECK(difference(
              scenario, plain, [](uint64_t i) { return i % 7 != 0; }, way) == "");
    for (uint32_t seed = 1; seed < 20; seed += step(9))
      CHECK(difference(
                scenario, plain,
                [seed](uint64_t i) {
                  const auto mixed = static_cast<uint32_t>(i + 1) * 0x9E3779B1U * (2 * seed + 1);
                  return (mixed >> 24) < 13 * seed;
                },
                way) == "");
  }
}

// Passes the events to the log of the current turn.
struct Switch {
  EventLog* log;
  SinkResult accept(const Event& event) { return log->accept(event); }
};

// Pushes the remaining samples, and finishes, until the sink refuses.
Status push_until_refused(Extractor16& extractor, const Scenario& scenario, uint32_t& at) {
  Status status = Status::ok;
  while (at < scenario.samples && status == Status::ok) {
    const PushResult pushed = extractor.push(scenario.volume.on.data() + at, scenario.samples - at);
    at += pushed.samples;
    status = pushed.status;
  }
  return status == Status::ok ? extractor.finish() : status;
}

// No call has an effect.
bool is_held(Extractor16& extractor, const Scenario& scenario, uint32_t at) {
  const PushResult pushed = extractor.push(scenario.volume.on.data() + at, scenario.samples - at);
  return extractor.resume() == Status::suspended && pushed.samples == 0 &&
         extractor.push_bits(scenario.volume.on.data()).samples == 0 &&
         extractor.skip_row(Substitute::off).samples == 0 &&
         (pushed.status == Status::suspended || pushed.status == Status::finished);
}

// A sink that accepts `k` events stops the scan there, whatever the caller tries. Then the sink
// recovers, or the scan is abandoned and the next one begins in the same memory.
std::string fault_of_dead_sink(const Scenario& scenario, const EventLog& plain, uint64_t k) {
  bool is_dead = false;
  EventLog log([&](uint64_t offer) { return (is_dead = is_dead || offer == k); });
  EventLog next;
  Switch receiver{&log};
  const Limits limits = limits_of(scenario.volume, scenario.border);
  Block block(Extractor16::bytes_for(limits, scenario.capacities));
  Extractor16 extractor;
  require_ok(extractor.start(limits, scenario.capacities, 1, block.memory(), make_sink(receiver)));
  uint32_t at = 0;
  if (push_until_refused(extractor, scenario, at) != Status::suspended) return "not refused";
  for (int i = 0; i < 3; ++i)
    if (!is_held(extractor, scenario, at) || log.events.size() != k) return "not held";
  is_dead = false;
  if (k % 2 == 1) {
    receiver.log = &next;
    at = 0;
    require_ok(extractor.reset());
  }
  Status status = Status::suspended;
  while (status == Status::suspended) status = push_until_refused(extractor, scenario, at);
  require_ok(status);
  if (!block.is_intact()) return "a write outside the arena";
  return receiver.log->events == plain.events ? "" : "other events";
}

// Few slots, so that loose fragments are sent.
Scenario loose(uint64_t seed, Border border) {
  const auto step = static_cast<uint32_t>(seed % 7);
  Scenario scenario = scenario_of(random({6, 5, 5}, 60 + 25 * step, seed), border);
  scenario.capacities = {minimum_capacities().slots + 14 * step, step};
  return scenario;
}

// The same with more randomness.
Scenario pressed(uint64_t seed) {
  const auto density = static_cast<uint32_t>(60 + 30 * (seed % 6));
  Scenario scenario = scenario_of(random({5, 6, 5}, density, seed), Border::closed);
  const auto extra = static_cast<uint32_t>(seed % 40);
  scenario.capacities = {minimum_capacities().slots + 4 * extra, extra / 8};
  return scenario;
}

}  // namespace

TEST_CASE("refusing any single event leaves all events unchanged") {
  for (const Border border : {Border::closed, Border::open}) {
    check_every_single_refusal(scenario_of(random({6, 5, 5}, 90, 1), border));
    check_every_single_refusal(scenario_of(checkerboard({5, 4, 4}), border));
    check_every_single_refusal(scenario_of(ball({9, 9, 9}, {8, 8, 8}, 14), border));
    check_every_single_refusal(scenario_of(from_bits({1, 1, 1}, 1), border));
    check_every_single_refusal(scenario_of(BitVolume({3, 2, 4}), border));
  }
}

TEST_CASE("refusing any single event within a row of several words leaves all events unchanged") {
  for (const Border border : {Border::closed, Border::open})
    check_every_single_refusal(scenario_of(random({99, 2, 2}, 8, 7), border));
}

TEST_CASE("refusing any single event among loose fragments leaves all events unchanged") {
  for (uint64_t seed = 0; seed < 14; ++seed) {
    const Scenario scenario = loose(seed, seed % 2 == 0 ? Border::closed : Border::open);
    CAPTURE(seed);
    check_every_single_refusal(scenario);
  }
  for (uint64_t seed = 0; seed < 36; seed += 6) {
    CAPTURE(seed);
    check_every_single_refusal(pressed(seed));
  }
}

TEST_CASE("refusing events once each, repeatedly or at random leaves all events unchanged") {
  for (const Border border : {Border::closed, Border::open})
    for (uint64_t seed = 0; seed < 6; ++seed) {
      CAPTURE(seed);
      check_many_refusals(loose(seed, border));
      check_many_refusals(pressed(7 * seed));
      check_many_refusals(scenario_of(random({8, 7, 6}, 128, seed), border));
    }
}

TEST_CASE("reset() discards events that the sink has not accepted") {
  for (const Scenario& scenario : {scenario_of(random({5, 5, 4}, 128, 3), Border::open),
                                   loose(4, Border::closed), pressed(7)}) {
    const EventLog plain = run<uint16_t>(scenario);
    for (uint64_t accepted = 0; accepted < plain.events.size(); accepted += 7)
      for (const bool skips : {false, true})
        CHECK(events_after_reset(scenario, accepted, skips).events == plain.events);
  }
}

TEST_CASE(
    "an abandoned scan is closed and reported as abandoned, even if any single event is refused") {
  for (const Border border : {Border::closed, Border::open}) {
    Scenario scenario = scenario_of(random({3, 3, 3}, 140, 9), border);
    scenario.ending = Ending::abandon;
    const auto voxels = static_cast<uint32_t>(scenario.volume.voxels());
    for (scenario.samples = 0; scenario.samples <= voxels; ++scenario.samples) {
      CAPTURE(scenario.samples);
      CHECK(collected(run<uint16_t>(scenario).events).was_abandoned());
      check_every_single_refusal(scenario);
    }
  }
}

TEST_CASE(
    "a sink that dies at any event suspends the scan, which resumes or restarts without loss") {
  for (uint64_t seed = 0; seed < 6; ++seed)
    for (const Scenario& scenario :
         {loose(seed, seed % 2 == 0 ? Border::closed : Border::open), pressed(5 * seed)}) {
      CAPTURE(seed);
      const EventLog plain = run<uint16_t>(scenario);
      for (uint64_t k = 0; k < plain.events.size(); k += step(11)) {
        CAPTURE(k);
        CHECK(fault_of_dead_sink(scenario, plain, k) == "");
      }
    }
}
