// Fuzz target. The rings of any small surface, cut anywhere, are joined to its regions. They arrive
// in the order of a sweep, of several slabs, or in any order. A second joiner joins the fragments
// that a first one with little memory passed on. If fragments are lost, all other regions are
// correct. Neither refusals nor invalid events do harm.
//
//   fuzz_joiner -max_len=300 corpus/joiner      with libFuzzer
//   fuzz_joiner corpus/joiner                   with replay_main.cpp

#include <algorithm>

#include "input.hpp"
#include "oracle/join.hpp"
#include "oracle/loose.hpp"
#include "oracle/merge.hpp"
#include "oracle/stream.hpp"
#include "require.hpp"
#include "small_volume.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

struct Scenario {
  bool is_open, has_losses, has_little_memory;
  JoinPlan plan;
  Cuts cuts;
  uint32_t refusals;  ///< refused offers per 256
  test::Chance chance;
};

JoinCapacities read_little_memory(Input& input) {
  const uint32_t fragments = 1 + input.byte();
  return {fragments, 1 + input.word() % 1000};
}

void read_scenario(Input& input, Scenario& scenario) {
  const uint32_t flags = input.byte();
  scenario.is_open = (flags & 1) != 0;
  scenario.plan.order = (flags & 2) != 0 ? InputOrder::any : InputOrder::sweep;
  scenario.plan.unjoined = (flags & 4) == 0 ? Unjoined::passed_on : Unjoined::dropped;
  scenario.has_little_memory = (flags & 8) != 0;
  scenario.has_losses = (flags & 16) != 0;
  if (scenario.has_little_memory) scenario.plan.capacities = read_little_memory(input);
  scenario.refusals = input.byte() % 200;
  scenario.cuts.loose_outers = input.byte() % 101;
  scenario.cuts.loose_holes = input.byte() % 101;
  scenario.cuts.max_pieces = 1 + input.below(9);
  if (scenario.plan.order == InputOrder::any)
    scenario.cuts.slab = static_cast<int32_t>(input.below(6));
  scenario.chance = test::Chance(input.word());
}

// The pieces in an order that the plan allows.
Pieces dealt(const Pieces& pieces, const Scenario& scenario) {
  if (scenario.plan.order == InputOrder::sweep) return pieces;
  if (scenario.cuts.slab > 0) return interleaved(pieces, scenario.cuts.below);
  Pieces shuffled = pieces;
  shuffle(shuffled, scenario.cuts.below);
  std::stable_partition(shuffled.begin(), shuffled.end(),
                        [](const Piece& piece) { return piece.is_fragment(); });
  return shuffled;
}

// Loses some fragments, and counts them by region.
Pieces without_losses(const Pieces& pieces, Scenario& scenario, std::vector<size_t>& lost) {
  Pieces left;
  for (const Piece& piece : pieces) {
    if (piece.is_fragment() && scenario.chance.below(10) == 0)
      ++lost[piece.region];
    else
      left.push_back(piece);
  }
  return left;
}

// If all events arrived, the regions are those of the surface.
void check_regions(const Joined& joined, const Scenario& scenario,
                   const std::vector<Region>& regions) {
  require(joined.report.unmatched == 0, "a fragment without a partner");
  require((joined.status == Status::ok) == (joined.report.short_of_memory == 0),
          "short without saying so");
  if (!scenario.has_little_memory) require(joined.status == Status::ok, "short of what is enough");
  const Delivered delivered(joined.events);
  if (scenario.plan.unjoined == Unjoined::dropped) {
    require(delivered.fragments.empty(), "a loose fragment");
    if (joined.report.short_of_memory > 0) return;
  }
  require(joined.report.short_of_memory == delivered.fragments.size(), "fragments not counted");
  JoinPlan other = scenario.plan;
  other.capacities = enough_for(joined.events);
  const Joined second = join_all(joined.events, other);
  require(second.status == Status::ok, to_string(second.status));
  const std::string difference =
      describe_difference(canonical(Delivered(second.events).regions), regions);
  require(difference.empty(), difference.c_str());
}

// A region without lost fragments is correct.
void check_rest(const Joined& joined, const Scenario& scenario, const std::vector<Region>& regions,
                const std::vector<size_t>& lost) {
  if (scenario.has_little_memory) return;
  const Delivered delivered(joined.events);
  const std::vector<Region> left = canonical(delivered.regions);
  for (size_t region = 0; region < regions.size(); ++region)
    if (lost[region] == 0)
      require(std::count(left.begin(), left.end(), regions[region]) == 1,
              "a region that lost nothing is not right");
  if (scenario.plan.unjoined == Unjoined::passed_on)
    require(joined.report.unmatched == delivered.fragments.size(), "fragments not counted");
}

void check_surface(Input& input, Scenario& scenario) {
  const std::vector<Region> regions =
      canonical(merge(read_small_volume(input, {12, 12, 6}), !scenario.is_open));
  const Pieces pieces = dealt(cut(regions, scenario.cuts), scenario);
  std::vector<size_t> lost(regions.size());
  const Events events =
      events_of(scenario.has_losses ? without_losses(pieces, scenario, lost) : pieces);
  if (!scenario.has_little_memory) scenario.plan.capacities = enough_for(events);
  const Joined joined = join_all(events, scenario.plan);
  if (scenario.has_losses)
    check_rest(joined, scenario, regions, lost);
  else
    check_regions(joined, scenario, regions);
  JoinPlan slow = scenario.plan;
  slow.refuses = [&](uint64_t) { return scenario.chance.below(256) < scenario.refusals; };
  require(join_all(events, slow).events == joined.events, "refusals show");
}

// Events that break the grammar, with invalid members.
void check_any_events(Input& input, Scenario& scenario) {
  const Statistics statistics{};
  Events events;
  Event event{};
  while (!input.is_empty()) {
    event.kind = static_cast<Event::Kind>(input.below(10));
    if (event.kind == Event::Kind::run) {
      event.run = Run::from_code(input.number(UINT32_MAX));
    } else {
      // Sometimes other events, so that some fragments meet.
      const uint32_t changes = input.byte();
      if ((changes & 3) == 0) event.incidence = static_cast<Incidence>(input.below(28));
      if ((changes & 12) == 0) event.incoming_direction = static_cast<Direction>(input.below(9));
      if ((changes & 48) == 0) event.start.x = static_cast<int32_t>(input.number(UINT32_MAX));
      if ((changes & 192) == 0) event.start.z = static_cast<int32_t>(input.number(UINT32_MAX));
      event.is_hole = (changes & 5) == 0;
    }
    event.statistics = &statistics;
    events.emplace_back(event);
  }
  scenario.plan.refuses = [&](uint64_t) { return scenario.chance.below(256) < scenario.refusals; };
  if (!scenario.has_little_memory) scenario.plan.capacities = enough_for(events);
  (void)join_all(events, scenario.plan);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  Scenario scenario{false, false, false, {}, {}, 0, test::Chance(0)};
  scenario.cuts.below = [&](uint32_t limit) { return scenario.chance.below(limit); };
  const bool is_of_a_surface = input.below(4) != 0;
  read_scenario(input, scenario);
  try {
    if (is_of_a_surface)
      check_surface(input, scenario);
    else
      check_any_events(input, scenario);
  } catch (const std::exception& error) {
    require(false, error.what());
  }
  return 0;
}
