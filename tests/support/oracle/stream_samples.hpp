// Scans that together contain every element of a stream.
#pragma once

#include <string>

#include "stream.hpp"

namespace discmc::test {

struct Sample {
  std::string name;
  StreamHeader header;
  Events events;
};

/// Events written by hand. They need not describe a surface.
class Script {
 public:
  Script& region(Incidence incidence) {
    return add(Event::Kind::region, [&](Event& event) { event.incidence = incidence; });
  }
  Script& ring(Vertex start, bool is_hole = false) {
    return add(Event::Kind::ring, [&](Event& event) {
      event.start = start;
      event.is_hole = is_hole;
    });
  }
  Script& run(Run run) {
    return add(Event::Kind::run, [&](Event& event) { event.run = run; });
  }
  Script& run(Direction direction, uint32_t length) {
    return run(Run::straight(direction, length));
  }
  Script& region_end() {
    ++totals_.regions;
    return add(Event::Kind::region_end);
  }
  Script& fragment(Incidence incidence, Vertex start, Direction came) {
    return add(Event::Kind::fragment, [&](Event& event) {
      event.incidence = incidence;
      event.start = start;
      event.incoming_direction = came;
    });
  }
  Script& fragment_end() {
    ++totals_.fragments;
    return add(Event::Kind::fragment_end);
  }
  Script& lost() { return add(Event::Kind::lost); }
  Script& skipped(uint32_t slice, uint32_t row, bool repeated) {
    return add(Event::Kind::skipped, [&](Event& event) {
      event.slice = slice;
      event.row = row;
      event.is_repeated = repeated;
    });
  }
  Script& layer(uint32_t slice) {
    return add(Event::Kind::layer, [&](Event& event) { event.slice = slice; });
  }
  Script& finish() {
    return add(Event::Kind::finish, [&](Event& event) { event.statistics = &totals_; });
  }
  /// Adds a square of this side across z.
  Script& square(Vertex corner, uint32_t side, bool is_hole = false) {
    ring(corner, is_hole);
    for (uint32_t i = 0; i < 4; ++i)
      run(static_cast<Direction>((is_hole ? 8 - 2 * i : 2 * i) % 8), side);
    return *this;
  }

  Events events;

 private:
  Script& add(Event::Kind kind) {
    return add(kind, [](Event&) {});
  }
  template <class Fill>
  Script& add(Event::Kind kind, Fill fill) {
    Event event{};
    event.kind = kind;
    fill(event);
    events.emplace_back(event);
    return *this;
  }
  Statistics totals_{};
};

constexpr Incidence up = incidence_of({0, 0, 1});

// Adds a random run. Separate statements fix the order in which its numbers are drawn.
inline void add_run(Script& script, Chance& chance, uint32_t directions, uint32_t most) {
  const uint32_t length = 1 + chance.below(most);
  script.run(static_cast<Direction>(chance.below(directions)), length);
}

/// Adds a region of one ring with random runs of up to `most` links, in a plane across z.
inline void add_ragged_region(Script& script, Chance& chance, uint32_t runs, uint32_t most) {
  script.region(up).ring({1, 2, 2 * static_cast<int32_t>(chance.below(50))});
  for (uint32_t i = 0; i < runs; ++i) add_run(script, chance, 8, most);
  script.region_end();
}

/// Adds a loose fragment of random runs of up to `most` links, at any place.
inline void add_ragged_fragment(Script& script, Chance& chance, uint32_t runs, uint32_t most) {
  const auto incidence = static_cast<Incidence>(chance.below(no_incidence));
  const uint32_t directions = direction_count(incidence);
  const auto x = static_cast<int32_t>(chance.next()), y = static_cast<int32_t>(chance.next());
  const auto z = static_cast<int32_t>(chance.next());
  script.fragment(incidence, {x, y, (z & ~1) | ((x ^ y ^ 1) & 1)},
                  static_cast<Direction>(chance.below(directions)));
  for (uint32_t i = 0; i < runs; ++i) add_run(script, chance, directions, most);
  script.fragment_end();
}

/// Returns rings, regions and fragments that no packet can hold, with runs and coordinates at their
/// limits.
inline Events monstrous_events() {
  Script script;
  Chance chance(11);
  for (const uint32_t runs : {1U, 91U, 92U, 93U, 96U, 97U, 500U})
    for (const uint32_t most : {3U, 1000U, Run::max_length}) {
      add_ragged_region(script, chance, runs, most);
      script.layer(runs);
    }
  for (const uint32_t runs : {1U, 2U, 60U, 91U, 92U, 93U, 96U, 500U})
    for (const uint32_t most : {1U, 70000U, Run::max_length})
      add_ragged_fragment(script, chance, runs, most);
  script.region(up).square({-3, -5, 1}, 65535).square({1, 1, 1}, 65536, true).region_end();
  script.region(up).square({-3, -5, 1}, 65535).square({1, 1, 1}, 1, true).region_end();
  script.skipped(3, 2, true).skipped(UINT32_MAX - 1, UINT32_MAX - 1, false);
  return script.finish().events;
}

/// Returns a plate one voxel thick with a hole in every fourth voxel of every fourth row.
inline reference::BitVolume sieve(uint32_t side) {
  return reference::volume_of(
      {side, side, 1}, [](uint32_t x, uint32_t y, uint32_t) { return x % 4 != 2 || y % 4 != 2; });
}

/// Returns a scan with skipped rows that is abandoned after a number of rows (0: never).
inline Events events_with_gaps(const reference::BitVolume& volume, uint32_t rows_until_abandoned) {
  const Limits limits = reference::limits_of(volume, Border::closed);
  reference::Block block(Extractor32::bytes_for(limits, reference::ample));
  EventLog log;
  Extractor32 extractor;
  reference::require_ok(
      extractor.start(limits, reference::ample, 1, block.memory(), make_sink(log)));
  const uint32_t rows = volume.height * volume.depth;
  const bool is_abandoned = rows_until_abandoned > 0;
  for (uint32_t row = 0; row < (is_abandoned ? rows_until_abandoned : rows); ++row) {
    const uint8_t* samples = volume.on.data() + size_t{row} * volume.width;
    const PushResult pushed = row % 5 == 2   ? extractor.skip_row(Substitute::off)
                              : row % 7 == 3 ? extractor.skip_row(Substitute::previous_row)
                                             : extractor.push(samples, volume.width);
    reference::require_ok(pushed.status);
  }
  reference::require_ok(is_abandoned ? extractor.abandon() : extractor.finish());
  return log.events;
}

/// Adds a ring as loose fragments of at most max_runs runs. A cut leaves the last link of a run to
/// the next fragment.
inline void add_loose_ring(Script& script, Incidence incidence, Vertex start,
                           const std::vector<Run>& runs, size_t max_runs) {
  Vertex at = start;
  script.fragment(incidence, at, runs.back().direction());
  for (size_t i = 0; i < runs.size(); ++i) {
    const Direction direction = runs[i].direction();
    const bool is_cut = (i + 1) % max_runs == 0;
    const uint32_t links_left = is_cut && runs[i].length() > 1 ? 1 : 0;
    const Run run = Run::straight(direction, runs[i].length() - links_left);
    script.run(run);
    at = at + displacement(incidence, &run, 1);
    if (is_cut && (links_left > 0 || i + 1 < runs.size()))
      script.fragment_end().fragment(incidence, at, direction);
    if (links_left == 0) continue;
    script.run(direction, links_left);
    at = at + direction_vector(incidence, direction);
  }
  script.fragment_end();
}

/// Returns the events of a scan with each ring of more than max_runs runs as loose fragments.
/// Fragments that the scan itself has sent stay unchanged.
inline Events with_loose_fragments(const Events& events, size_t max_runs) {
  struct Chain {
    Vertex start;
    std::vector<Run> runs;
  };
  Events result, region;
  std::vector<Chain> rings;
  Statistics totals{};
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    if (recorded.is(Event::Kind::finish)) {
      totals.links = event.statistics->links;
      totals.skipped_rows = event.statistics->skipped_rows;
      Event finish = event;
      finish.statistics = &totals;
      result.emplace_back(finish);
      continue;
    }
    region.push_back(recorded);
    if (recorded.is(Event::Kind::ring)) rings.push_back({event.start, {}});
    if (recorded.is(Event::Kind::run) && !rings.empty()) rings.back().runs.push_back(event.run);
    if (recorded.is(Event::Kind::region) || recorded.is(Event::Kind::ring) ||
        recorded.is(Event::Kind::run))
      continue;
    if (std::any_of(rings.begin(), rings.end(),
                    [max_runs](const Chain& ring) { return ring.runs.size() > max_runs; })) {
      const Incidence incidence = region.front().event().incidence;
      Script script;
      for (size_t i = rings.size(); i-- > 0;)  // adds the outer ring last
        add_loose_ring(script, incidence, rings[i].start, rings[i].runs, max_runs);
      region = script.events;
    }
    for (const RecordedEvent& one : region) {
      totals.regions += one.is(Event::Kind::region_end);
      totals.rings += one.is(Event::Kind::ring);
      totals.fragments += one.is(Event::Kind::fragment_end);
    }
    result.insert(result.end(), region.begin(), region.end());
    region.clear();
    rings.clear();
  }
  return result;
}

inline Sample sample_of(const std::string& name, const reference::BitVolume& volume,
                        Border border = Border::closed) {
  reference::Plan plan;
  plan.border = border;
  return {name, header_of(volume, border), events_of(volume, plan)};
}

inline std::vector<Sample> samples() {
  using namespace reference;
  const BitVolume round = ball({24, 24, 24}, {23, 23, 23}, 100);
  const BitVolume noise = random({13, 11, 9}, 128, 1);
  const BitVolume winding = spiral({70, 70, 3});
  std::vector<Sample> all{
      sample_of("an empty volume", BitVolume({3, 3, 3})),
      sample_of("a single voxel", from_bits({1, 1, 1}, 1)),
      sample_of("a ball", round),
      sample_of("a ball with an open border", ball({20, 20, 20}, {19, 19, 19}, 120), Border::open),
      sample_of("noise", noise),
      sample_of("sparse noise", random({40, 9, 33}, 12, 2)),
      sample_of("a checkerboard", checkerboard({9, 9, 9})),
      sample_of("the tiling of configuration 61", tiling_61({10, 10, 6})),
      sample_of("a spiral, whose rings are long", winding),
      sample_of("a sieve, whose regions have many holes", sieve(45)),
      sample_of("a long wire, all of it one run", box({3000, 3, 3}, {1, 1, 1}, {2998, 1, 1})),
  };
  all.push_back(
      {"a ball in hardly any memory", header_of(round), events_of(round, minimum_capacities())});
  all.push_back(
      {"noise in loose fragments", header_of(noise), with_loose_fragments(events_of(noise), 3)});
  all.push_back({"a spiral in loose fragments", header_of(winding),
                 with_loose_fragments(events_of(winding), 5)});
  all.push_back({"a spiral in long loose fragments", header_of(winding),
                 with_loose_fragments(events_of(winding), 150)});
  all.push_back({"rows that never came", header_of(noise), events_with_gaps(noise, 0)});
  all.push_back({"an abandoned scan", header_of(noise), events_with_gaps(noise, 47)});
  all.push_back({"monstrous records", any_header(), monstrous_events()});
  return all;
}

}  // namespace discmc::test
