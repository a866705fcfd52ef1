// The joiner: cut regions are joined, in any order and memory, for any refusals of the sink.
// Invalid events end safely.
#include "oracle/join.hpp"
#include "oracle/loose.hpp"
#include "oracle/merge.hpp"
#include "oracle/stream_samples.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using test::Chance;

namespace {

using Kind = Event::Kind;

// Two castles side by side, with walls around walls. Their tops and bottoms have nested rings on
// one plane.
BitVolume walls_around_walls(uint32_t side, uint32_t depth) {
  return volume_of({2 * side + 1, side, depth}, [side](int64_t x, int64_t y, int64_t) {
    const int64_t column = x % (side + 1);
    const int64_t inwards = std::min({column, y, side - 1 - column, side - 1 - y});
    return inwards >= 0 && inwards % 4 < 2;
  });
}

// A plate full of holes, and pits that touch each other and the rim.
BitVolume plate(uint32_t side) {
  BitVolume volume({side, side, 4});
  for (int64_t y = 0; y < side; ++y)
    for (int64_t x = 0; x < side; ++x) {
      volume.on[volume.index(x, y, 1)] = x % 3 == 1 && y % 3 == 1 ? 0 : 1;
      volume.on[volume.index(x, y, 2)] = x % 3 == 1 && y % 2 == 1 ? 0 : 1;
    }
  for (const auto& [x, y] : {std::pair{1, 1}, {2, 2}, {3, 3}, {1, 4}, {2, 5}, {0, 3}, {5, 1}})
    volume.on[volume.index(x, y, 2)] = 0;
  return volume;
}

struct Surface {
  std::string name;
  std::vector<Region> regions;
};

const std::vector<Surface>& surfaces() {
  static const std::vector<Surface> all = [] {
    std::vector<Surface> made;
    const auto add = [&](const char* name, const BitVolume& volume, bool is_closed = true) {
      made.push_back({name, canonical(merge(volume, is_closed))});
    };
    add("walls around walls", walls_around_walls(15, 2));
    add("a plate full of holes", plate(13));
    add("a ball", ball({11, 11, 11}, {10, 10, 10}, 24));
    add("a torus", torus({17, 17, 7}, 10, 5));
    add("a spiral", spiral({13, 13, 5}));
    add("a tiling", tiling_61({7, 7, 7}));
    add("a checkerboard", checkerboard({6, 6, 4}));
    add("noise", random({9, 8, 7}, 128, 1));
    add("thin noise", random({12, 12, 5}, 50, 2));
    add("dense noise", random({12, 12, 5}, 200, 3));
    add("noise with an open border", random({9, 9, 6}, 120, 4), false);
    return made;
  }();
  return all;
}

Cuts cuts_of(Chance& chance, uint32_t loose_outers = 50) {
  Cuts cuts;
  cuts.below = [&chance](uint32_t limit) { return chance.below(limit); };
  cuts.loose_outers = loose_outers;
  return cuts;
}

std::string unlike(const Events& delivered, const std::vector<Region>& regions) {
  return describe_difference(canonical(Delivered(delivered).regions), regions);
}

Events fragment_of(Incidence incidence, const Vertex& start, Direction came,
                   const std::vector<Run>& runs) {
  test::Script script;
  script.fragment(incidence, start, came);
  for (const Run run : runs) script.run(run);
  return script.fragment_end().events;
}

// The runs of a round in all directions, from direction 0 on.
std::vector<Run> square_runs(uint32_t side) {
  return {Run::straight(0, side), Run::straight(2, side), Run::straight(4, side),
          Run::straight(6, side)};
}

// A square as one closed fragment: an outer ring, or a hole of the same shape.
Events square_fragment(const Vertex& corner, uint32_t side, bool is_hole) {
  std::vector<Run> runs = square_runs(side);
  if (!is_hole) return fragment_of(test::up, corner, 6, runs);
  for (Run& run : runs)
    run = Run::straight(static_cast<Direction>((10 - run.direction()) % 8), side);
  return fragment_of(test::up, corner, 4, runs);
}

// A region whose outer ring and hole are such squares.
test::Script square_region(const Vertex& corner, uint32_t side) {
  test::Script script;
  script.region(test::up).square(corner, side);
  return script;
}

// Returns a corner moved inwards by this many links.
Vertex inwards(const Vertex& corner, int32_t links) {
  const Vertex diagonal = direction_vector(test::up, 0) + direction_vector(test::up, 2);
  return corner + Vertex{links * diagonal.x, links * diagonal.y, links * diagonal.z};
}

void append(Events& events, const Events& more) {
  events.insert(events.end(), more.begin(), more.end());
}

RecordedEvent finish_of(const Statistics& statistics, uint32_t slices, bool abandoned) {
  Event event{};
  event.kind = Kind::finish;
  event.statistics = &statistics;
  event.slice = slices;
  event.is_abandoned = abandoned;
  return RecordedEvent(event);
}

uint64_t count(const Events& events, Kind kind) {
  return static_cast<uint64_t>(std::count_if(
      events.begin(), events.end(), [kind](const RecordedEvent& event) { return event.is(kind); }));
}

size_t fragments_in(const Pieces& pieces) {
  return static_cast<size_t>(std::count_if(pieces.begin(), pieces.end(),
                                           [](const Piece& piece) { return piece.is_fragment(); }));
}

}  // namespace

// ---- joined regions ----

TEST_CASE("a joiner joins the loose fragments of a sweep to the regions") {
  Chance chance(1);
  for (const Surface& surface : surfaces())
    for (int round = 0; round < 20; ++round) {
      INFO(surface.name, ", round ", round);
      const Pieces pieces = cut(surface.regions, cuts_of(chance));
      const Joined joined = join_all(events_of(pieces), {});
      REQUIRE(unlike(joined.events, surface.regions) == "");
      CHECK(joined.status == Status::ok);
      CHECK(joined.report.received == fragments_in(pieces));
      CHECK(joined.report.unmatched == 0);
      CHECK(joined.report.short_of_memory == 0);
    }
}

TEST_CASE("a joiner joins loose fragments in any order to the regions") {
  Chance chance(2);
  for (const Surface& surface : surfaces())
    for (int round = 0; round < 20; ++round) {
      INFO(surface.name, ", round ", round);
      const Cuts cuts = cuts_of(chance, 60);
      Pieces pieces = cut(surface.regions, cuts);
      // Whole regions come after the fragments.
      shuffle(pieces, cuts.below);
      std::stable_partition(pieces.begin(), pieces.end(),
                            [](const Piece& piece) { return piece.is_fragment(); });
      const Joined joined = join_all(events_of(pieces), {InputOrder::any});
      REQUIRE(unlike(joined.events, surface.regions) == "");
      CHECK(joined.report.unmatched == 0);
    }
}

TEST_CASE("a joiner joins interleaved streams of several slabs to the regions") {
  Chance chance(3);
  for (const Surface& surface : surfaces())
    for (const int32_t slab : {1, 2, 3, 7})
      for (const uint32_t loose : {0U, 50U, 100U}) {
        INFO(surface.name, ", slab ", slab, ", loose ", loose);
        Cuts cuts = cuts_of(chance, loose);
        cuts.loose_holes = loose;
        cuts.slab = 2 * slab;
        const Pieces pieces = interleaved(cut(surface.regions, cuts), cuts.below);
        const Joined joined = join_all(events_of(pieces), {InputOrder::any});
        REQUIRE(unlike(joined.events, surface.regions) == "");
        CHECK(joined.report.unmatched == 0);
      }
}

TEST_CASE("in sweep order a region is delivered as soon as its last fragment arrives") {
  Chance chance(5);
  const Surface& surface = surfaces()[0];
  const Pieces pieces = cut(surface.regions, cuts_of(chance, 100));
  EventLog log;
  Block block(100000);
  Joiner joiner;
  REQUIRE(joiner.start(block.memory(), make_sink(log), InputOrder::sweep) == Status::ok);
  for (size_t i = 0; i < pieces.size(); ++i) {
    for (const RecordedEvent& event : pieces[i].events)
      REQUIRE(joiner.accept(event.event()) == SinkResult::accepted);
    std::vector<Region> complete;
    for (size_t region = 0; region < surface.regions.size(); ++region) {
      const auto is_of_it = [&](const Piece& piece) { return piece.region == region; };
      if (std::none_of(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1, pieces.end(), is_of_it))
        complete.push_back(surface.regions[region]);
    }
    REQUIRE(unlike(log.events, complete) == "");
  }
}

// Nested squares on one plane, from the outermost in: outer ring, hole, outer ring, hole, ...
class Nest {
 public:
  static constexpr int32_t depth = 6;

  explicit Nest(const Vertex& corner) : corner_(corner) {}

  static bool is_hole(int32_t ring) { return ring % 2 == 1; }
  Events fragment(int32_t ring) const {
    return square_fragment(corner(ring), side(ring), is_hole(ring));
  }
  /// The events of an outer ring, without its end.
  test::Script begin_region(int32_t ring) const { return square_region(corner(ring), side(ring)); }
  /// With the hole, if the region has one.
  Events region(int32_t ring, bool has_hole) const {
    test::Script script = begin_region(ring);
    if (has_hole) {
      script.ring(corner(ring + 1), true);
      for (const RecordedEvent& event : fragment(ring + 1))
        if (event.is(Kind::run)) script.run(event.event().run);
    }
    return script.region_end().events;
  }

 private:
  Vertex corner(int32_t ring) const { return inwards(corner_, ring); }
  static uint32_t side(int32_t ring) { return static_cast<uint32_t>(2 * (2 * depth - ring)); }

  Vertex corner_;
};

TEST_CASE("nested rings get the right holes in any order and despite losses") {
  constexpr int32_t none = -1;
  Chance chance(15);
  const Cuts cuts = cuts_of(chance);
  for (const Vertex& corner : {Vertex{1, 0, 0}, {1001, 2000, 40}, {-1001, -2000, -40}})
    for (const std::set<int32_t>& lost : {std::set<int32_t>{}, {1}, {3}, {1, 3}, {2}, {4}})
      for (const int32_t whole : {none, 0, 2, 4})
        for (int round = 0; round < 20; ++round) {
          if (lost.count(whole) > 0) continue;
          const Nest nest(corner);
          Pieces pieces;
          for (int32_t ring = 0; ring < Nest::depth; ++ring)
            if (ring != whole && lost.count(ring) == 0) pieces.push_back({nest.fragment(ring)});
          shuffle(pieces, cuts.below);
          Events events = events_of(pieces);
          // Whole regions come after the fragments.
          if (whole != none) append(events, nest.region(whole, false));
          const Joined joined = join_all(events, {InputOrder::any, {10, 50}});
          for (int32_t ring = 0; ring < Nest::depth; ring += 2) {
            if (lost.count(ring) > 0) continue;
            const Events region = nest.region(ring, lost.count(ring + 1) == 0);
            REQUIRE(std::search(joined.events.begin(), joined.events.end(), region.begin(),
                                region.end()) != joined.events.end());
          }
          // A hole of a region that is lost.
          REQUIRE(joined.report.unmatched == lost.count(2) + lost.count(4));
        }
}

TEST_CASE("a joiner's result does not depend on the initial contents of its memory") {
  const Nest nest({1, 0, 0});
  const JoinCapacities capacities{10, 60};
  for (int filling = 0; filling < 256; ++filling) {
    Block block(Joiner::bytes_for(capacities));
    std::fill_n(static_cast<uint8_t*>(block.memory().data), block.memory().bytes,
                static_cast<uint8_t>(filling));
    EventLog log;
    Joiner joiner;
    require_ok(joiner.start(capacities, block.memory(), make_sink(log), InputOrder::any));
    for (const int32_t ring : {1, 0})
      for (const RecordedEvent& event : nest.fragment(ring))
        REQUIRE(joiner.accept(event.event()) == SinkResult::accepted);
    REQUIRE(joiner.finish() == Status::ok);
    REQUIRE(log.events == nest.region(0, true));
  }
}

// ---- little memory ----

TEST_CASE("fragments passed on by a joiner short of memory are joined by a second joiner") {
  Chance chance(6);
  for (const size_t index : {size_t{0}, size_t{1}, size_t{5}, size_t{7}}) {
    const Surface& surface = surfaces()[index];
    for (const InputOrder order : {InputOrder::sweep, InputOrder::any})
      for (uint32_t size = 1; size < 500; size += step(10) * (1 + size / 50)) {
        INFO(surface.name, ", size ", size);
        JoinPlan plan{order, {1 + size / 4, size}};
        if (size % 3 == 0) plan.capacities = {size, 1 + size / 2};
        const Joined first = join_all(events_of(cut(surface.regions, cuts_of(chance))), plan);
        plan.capacities = {2000, 20000};
        const Joined second = join_all(first.events, plan);
        REQUIRE(unlike(second.events, surface.regions) == "");
        REQUIRE(second.status == Status::ok);
        REQUIRE(first.status ==
                (first.report.short_of_memory > 0 ? Status::too_little_memory : Status::ok));
        REQUIRE(first.report.short_of_memory == Delivered(first.events).fragments.size());
        REQUIRE(first.report.unmatched == 0);
      }
  }
}

TEST_CASE("more memory never makes a joiner pass on more fragments") {
  Chance chance(7);
  const Surface& surface = surfaces()[7];
  const Events events = events_of(cut(surface.regions, cuts_of(chance)));
  uint64_t passed_before = UINT64_MAX;
  for (uint64_t bytes = Joiner::minimum_bytes(); bytes < 30000;
       bytes += step(5) * (1 + bytes / 50)) {
    CAPTURE(bytes);
    JoinPlan plan;
    plan.capacities = Joiner::default_capacities(bytes);
    REQUIRE(Joiner::bytes_for(plan.capacities) <= bytes);
    const Joined joined = join_all(events, plan);
    REQUIRE(unlike(join_all(joined.events, {}).events, surface.regions) == "");
    REQUIRE(joined.report.short_of_memory <= passed_before);
    passed_before = joined.report.short_of_memory;
  }
  CHECK(passed_before == 0);
}

TEST_CASE("the peaks of a joiner are the smallest sufficient capacities") {
  Chance chance(8);
  for (const Surface& surface : surfaces()) {
    const Events events = events_of(cut(surface.regions, cuts_of(chance)));
    CAPTURE(surface.name);
    const JoinCapacities most = join_all(events, {}).peaks;
    INFO("fragments ", most.fragments, ", runs ", most.runs);
    JoinPlan plan;
    plan.capacities = most;
    CHECK(join_all(events, plan).status == Status::ok);
    plan.capacities = {most.fragments - 1, most.runs};
    CHECK(join_all(events, plan).status == Status::too_little_memory);
    plan.capacities = {most.fragments, most.runs - 1};
    CHECK(join_all(events, plan).status == Status::too_little_memory);
  }
}

namespace {

// Whether a joiner's table has the key near its beginning, for any size of the table.
bool is_crowded(const detail::join::WaitingKey& key) {
  return detail::join::WaitingTable::hash_of(key) >> 27 == 0;
}

// Events that crowd the table of the first joiner. It runs out of buckets, although it has room for
// more chains.
void check_crowd(const Events& events, const JoinPlan& plan, uint64_t regions) {
  const Joined first = join_all(events, plan);
  CHECK(first.status == Status::too_little_memory);
  CHECK(first.events == events);
  CHECK(first.report.short_of_memory == count(events, Kind::fragment));
  JoinPlan slow = plan;
  slow.refuses = refuses_first;
  CHECK(join_all(events, slow).events == events);
  CHECK(join_all(first.events, {}).report.regions == regions);
}

}  // namespace

TEST_CASE("too many fragment ends in one part of the table count as a shortage of memory") {
  const std::vector<Run> runs = square_runs(2);
  for (const auto& [crowds_start, crowds_end] :
       {std::pair{true, true}, {true, false}, {false, true}}) {
    Events events, rest;
    for (int32_t z = 0; count(events, Kind::fragment) < 90; z += 2) {
      const Vertex start{1, 0, z}, end = inwards(start, 2);
      if (is_crowded({start, test::up, 6}) != crowds_start ||
          is_crowded({end, test::up, 2}) != crowds_end)
        continue;
      append(events, fragment_of(test::up, start, 6, {runs[0], runs[1]}));
      append(rest, fragment_of(test::up, end, 2, {runs[2], runs[3]}));
    }
    append(events, rest);
    check_crowd(events, {InputOrder::sweep, {100, 500}}, 90);
  }
}

namespace {

// With room for one fragment of four runs.
Joined joined_in_room_for_one(const Events& events) {
  return join_all(events, {InputOrder::sweep, {1, 4}});
}

}  // namespace

TEST_CASE("joined holes release their memory") {
  Events events;
  for (int32_t z = 0; z < 40; z += 2) {
    const Nest nest({1, 0, z});
    append(events, nest.fragment(1));
    append(events, nest.region(0, false));
  }
  const Joined joined = joined_in_room_for_one(events);
  CHECK(joined.status == Status::ok);
  CHECK(joined.report.rings == 20);
}

TEST_CASE("lost fragments release the memory of their runs") {
  Events events;
  for (int i = 0; i < 10; ++i) {
    append(events, fragment_of(test::up, {1, 0, 0}, 6, square_runs(2)));
    events.back() = test::Script().lost().events[0];
  }
  append(events, square_fragment({1, 0, 0}, 2, false));
  const Joined joined = joined_in_room_for_one(events);
  CHECK(joined.status == Status::ok);
  CHECK(joined.report.regions == 1);
}

TEST_CASE("a joiner with Unjoined::dropped drops fragments that cannot be joined") {
  Chance chance(9);
  for (const Surface& surface : surfaces()) {
    const Events events = events_of(cut(surface.regions, cuts_of(chance)));
    JoinPlan plan;
    plan.unjoined = Unjoined::dropped;
    CHECK(unlike(join_all(events, plan).events, surface.regions) == "");
    plan.capacities = {5, 30};
    const Joined joined = join_all(events, plan);
    CHECK(joined.status == Status::too_little_memory);
    CHECK(joined.report.short_of_memory > 0);
    CHECK(Delivered(joined.events).fragments.empty());
  }
}

// ---- a sink for whole regions ----

namespace {

// The events of an extractor with the minimum memory, as a sink for whole regions receives them.
// bytes: of the joiner.
struct WholeRegions {
  WholeRegions(const BitVolume& volume, size_t bytes, const EventLog::Refuses& refuses = {})
      : log(refuses) {
    const Limits limits = limits_of(volume, Border::closed);
    Block block(Extractor16::minimum_bytes(limits)), room(bytes);
    Extractor16 extractor;
    require_ok(
        extractor.start(limits, 1, block.memory(), make_region_sink(log, joiner, room.memory())));
    push_all(extractor, volume.on);
    finish_all(extractor);
    CHECK(extractor.statistics().fragments > 100);
    CHECK(room.is_intact());
    CHECK(count(log.events, Kind::fragment) == 0);
    CHECK(log.events.back().is(Kind::finish));
  }

  Joiner joiner;
  EventLog log;
};

}  // namespace

TEST_CASE("a region sink delivers the whole regions of an extractor short of memory") {
  for (const BitVolume& volume : {plate(13), random({9, 8, 7}, 128, 1), spiral({13, 13, 5})})
    for (const EventLog::Refuses& refuses : {EventLog::Refuses(), {refuses_first}}) {
      const WholeRegions got(volume, 100000, refuses);
      const std::vector<Region> regions = simple_rings(collected(got.log.events).regions());
      CHECK(describe_difference(canonical(regions), canonical(merge(volume, true))) == "");
      CHECK(got.log.starts.size() == 1);
      CHECK(got.joiner.report().unmatched + got.joiner.report().short_of_memory == 0);
    }
}

TEST_CASE("a region sink lacks the fragments that exceed its joiner, and the report counts these") {
  const BitVolume volume = random({9, 8, 7}, 128, 1);
  const WholeRegions got(volume, Joiner::minimum_bytes());
  CHECK(count(got.log.events, Kind::region) < merge(volume, true).size());
  CHECK(got.joiner.report().short_of_memory > 0);
}

TEST_CASE("make_region_sink() returns no function if the joiner has too little memory") {
  EventLog log;
  Joiner joiner;
  Block room(Joiner::minimum_bytes() - 1);
  const bool has_function = make_region_sink(log, joiner, room.memory()).accept != nullptr;
  CHECK_FALSE(has_function);
}

// ---- refusals ----

TEST_CASE("the events of a joiner are the same even if the sink refuses any event") {
  Chance chance(10);
  const Surface& surface = surfaces()[0];
  for (const InputOrder order : {InputOrder::sweep, InputOrder::any})
    for (const Unjoined unjoined : {Unjoined::passed_on, Unjoined::dropped})
      for (const JoinCapacities& capacities :
           {JoinCapacities{500, 5000}, {12, 100}, {3, 1000}, {1, 1}}) {
        JoinPlan plan{order, capacities, unjoined};
        Pieces pieces = cut(surface.regions, cuts_of(chance));
        pieces.erase(pieces.begin() + 7, pieces.begin() + 9);
        Events events = events_of(pieces);
        events.push_back(finish_of({1, 2, 3, 4, 5, 6, 7, 8}, 10, false));
        const Joined plain = join_all(events, plan);
        for (size_t refused = 0; refused < plain.events.size(); refused += step(17)) {
          plan.refuses = [&](uint64_t offer) { return offer == refused; };
          REQUIRE(join_all(events, plan).events == plain.events);
        }
        plan.refuses = refuses_first;
        const Joined slow = join_all(events, plan);
        CHECK(slow.events == plain.events);
        CHECK(slow.report.received == plain.report.received);
        CHECK(slow.report.unmatched == plain.report.unmatched);
        CHECK(slow.report.short_of_memory == plain.report.short_of_memory);
      }
}

TEST_CASE(
    "completed regions are delivered after the event is accepted, even if the sink refuses first") {
  Chance chance(16);
  for (const JoinCapacities& capacities : {JoinCapacities{500, 5000}, {12, 100}, {1, 1}}) {
    const Events events = events_of(cut(surfaces()[1].regions, cuts_of(chance)));
    EventLog plain, slow(refuses_first);
    Block plain_block(Joiner::bytes_for(capacities)), slow_block(Joiner::bytes_for(capacities));
    Joiner joiner, slow_joiner;
    require_ok(joiner.start(capacities, plain_block.memory(), make_sink(plain), InputOrder::sweep));
    require_ok(
        slow_joiner.start(capacities, slow_block.memory(), make_sink(slow), InputOrder::sweep));
    for (const RecordedEvent& event : events) {
      REQUIRE(joiner.accept(event.event()) == SinkResult::accepted);
      while (slow_joiner.accept(event.event()) != SinkResult::accepted) continue;
      REQUIRE(slow.events.size() == plain.events.size());
    }
  }
}

// ---- losses ----

namespace {

// The expected result after the loss of some fragments: whole rings, and chains between two gaps.
size_t count_chains(const Pieces& left) {
  const auto has = [&](const Piece& wanted, size_t place) {
    return std::any_of(left.begin(), left.end(), [&](const Piece& piece) {
      return piece.is_fragment() && piece.region == wanted.region && piece.ring == wanted.ring &&
             piece.place == place;
    });
  };
  const auto is_whole = [&](const Piece& piece) {
    for (size_t place = 0; place < piece.places; ++place)
      if (!has(piece, place)) return false;
    return true;
  };
  size_t count = 0;
  for (const Piece& piece : left) {
    if (!piece.is_fragment()) continue;
    const size_t before = (piece.place + piece.places - 1) % piece.places;
    if (is_whole(piece) ? piece.place == 0 : !has(piece, before)) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE(
    "a region is right if all its fragments arrive, and fragments of other regions are counted") {
  Chance chance(11);
  for (const Surface& surface : surfaces())
    for (const InputOrder order : {InputOrder::sweep, InputOrder::any})
      for (uint32_t round = 0; round < 20; round += step(5)) {
        INFO(surface.name, ", round ", round);
        std::vector<bool> is_damaged(surface.regions.size());
        Pieces left;
        for (const Piece& piece : cut(surface.regions, cuts_of(chance, 80))) {
          const bool is_lost = piece.is_fragment() && chance.below(20) == 0;
          if (is_lost) is_damaged[piece.region] = true;
          if (!is_lost) left.push_back(piece);
        }
        const Joined joined = join_all(events_of(left), {order});
        const Delivered delivered(joined.events);
        const std::vector<Region> regions = canonical(delivered.regions);
        for (size_t region = 0; region < surface.regions.size(); ++region)
          if (!is_damaged[region])
            REQUIRE(std::count(regions.begin(), regions.end(), surface.regions[region]) == 1);
        REQUIRE(joined.report.rings + joined.report.unmatched == count_chains(left));
        REQUIRE(joined.report.unmatched == delivered.fragments.size());
        REQUIRE(joined.status == Status::ok);
      }
}

TEST_CASE(
    "a fragment lost halfway is discarded, and reported as lost if the sink has received a part") {
  const Events whole = square_region({1, 0, 0}, 3).region_end().events;
  Events events = fragment_of(test::up, {1, 0, 0}, 2, {Run::straight(2, 3)});
  events.back() = test::Script().lost().events[0];
  append(events, whole);
  Joined joined = join_all(events, {});
  CHECK(joined.events == whole);
  CHECK(joined.report.unmatched == 0);

  events = whole;
  events.back() = test::Script().lost().events[0];
  joined = join_all(events, {});
  CHECK(joined.events == events);
}

TEST_CASE("a joiner reports the loss of a passed-on fragment to the sink") {
  // Room for one run, so every fragment is passed on.
  Events events = fragment_of(test::up, {1, 0, 0}, 6, square_runs(2));
  append(events, fragment_of(test::up, {7, 0, 0}, 6, {Run::straight(0, 3)}));
  events.back() = test::Script().lost().events[0];
  JoinPlan plan;
  plan.capacities = {1, 1};
  CHECK(join_all(events, plan).events == events);
  plan.refuses = [](uint64_t offer) { return offer % 2 == 0; };
  CHECK(join_all(events, plan).events == events);
  plan.unjoined = Unjoined::dropped;
  CHECK(join_all(events, plan).events.empty());
}

TEST_CASE("a region lost before its end gets no holes") {
  const Nest nest({1, 0, 0});
  Events begun = nest.begin_region(0).lost().events;
  append(begun, test::Script().region(test::up).region_end().events);
  Events events = nest.fragment(1);
  append(events, begun);
  append(begun, nest.fragment(1));
  CHECK(join_all(events, {}).events == begun);
}

TEST_CASE("an invalid region leaves the waiting holes of its plane unassigned") {
  const Events hole = square_fragment(inwards({1, 0, 0}, 2), 1, true);
  const auto in_region = [&](Incidence incidence, Run first, Run last) {
    test::Script region;
    region.region(incidence).ring({1, 0, 0}).run(first);
    region.run(2, 8).run(4, 8).run(last);
    Events events = hole;
    append(events, region.region_end().events);
    return join_all(events, {});
  };
  const Run first = Run::straight(0, 8), last = Run::straight(6, 8);
  CHECK(in_region(test::up, first, last).report.unmatched == 0);
  for (const Joined& joined :
       {in_region(no_incidence, first, last), in_region(test::up, Run(), last),
        in_region(test::up, first, Run())}) {
    CHECK(joined.report.unmatched == 1);
    CHECK(count(joined.events, Kind::fragment) == 1);
    CHECK(count(joined.events, Kind::region) == 1);
  }
}

// ---- the end ----

TEST_CASE("the finish event of a joiner counts the delivered pieces") {
  Chance chance(12);
  const Surface& surface = surfaces()[0];
  for (const JoinPlan& plan : {JoinPlan{InputOrder::sweep, {500, 5000}},
                               {InputOrder::sweep, {20, 100}},
                               {InputOrder::sweep, {1, 1}},
                               {InputOrder::sweep, {5, 30}, Unjoined::dropped}}) {
    const Pieces pieces = cut(surface.regions, cuts_of(chance));
    Events events = events_of(pieces);
    Statistics sent{};
    sent.cells = 1000;
    sent.links = 2000;
    sent.regions = count(events, Kind::region);
    sent.rings = count(events, Kind::ring);
    sent.fragments = count(events, Kind::fragment);
    events.push_back(finish_of(sent, 7, true));
    const Joined joined = join_all(events, plan);
    Statistics delivered = sent;
    delivered.regions = count(joined.events, Kind::region);
    delivered.rings = count(joined.events, Kind::ring);
    delivered.fragments = count(joined.events, Kind::fragment);
    CHECK(joined.events.back() == finish_of(delivered, 7, true));
    CHECK(delivered.regions - sent.regions == joined.report.regions);
    CHECK(delivered.rings - sent.rings == joined.report.rings);
  }
}

TEST_CASE("several joined streams end with a single finish event") {
  const Statistics one{1, 2, 3, 4, 5, 6, 7, 8}, two{10, 20, 30, 40, 50, 60, 70, 80};
  const Statistics sum{11, 22, 33, 44, 55, 66, 77, 88};
  Events events = {finish_of(one, 3, true), finish_of(two, 4, false)};
  append(events, square_fragment({1, 0, 0}, 2, false));
  const Joined joined = join_all(events, {InputOrder::any});
  REQUIRE(joined.report.regions == 1);
  Statistics expected = sum;
  ++expected.regions;
  ++expected.rings;
  expected.fragments = 0;  // the others were lost
  CHECK(joined.events.back() == finish_of(expected, 7, true));
  CHECK(count(joined.events, Kind::finish) == 1);
}

TEST_CASE("loose fragments of an aborted stream count like loose fragments of other streams") {
  Events events = fragment_of(test::up, {1, 0, 0}, 6, {Run::straight(0, 2)});
  events.push_back(finish_of({}, 3, false));
  const Joined joined = join_all(events, {InputOrder::any});
  Statistics expected{};
  expected.fragments = 1;
  CHECK(joined.events.back() == finish_of(expected, 3, false));
}

TEST_CASE("the first start event of several streams is delivered once the sink accepts") {
  EventLog log;
  struct Late {
    SinkResult accept(const Event& event) {
      return refusals-- > 0 ? SinkResult::busy : log.accept(event);
    }
    EventLog& log;
    int refusals = 2;
  } late{log};
  std::vector<uint8_t> memory(4000);
  Joiner joiner;
  require_ok(joiner.start({memory.data(), memory.size()}, make_sink(late), InputOrder::any));
  StreamHeader header = test::any_header();
  for (const SinkResult answer :
       {SinkResult::busy, SinkResult::busy, SinkResult::accepted, SinkResult::accepted}) {
    header.scan = static_cast<uint16_t>(log.starts.size());
    CHECK(joiner.accept(test::start_of(header)) == answer);
  }
  REQUIRE(log.starts.size() == 1);
  CHECK(log.starts[0].scan == 0);
}

TEST_CASE("a finish event without statistics is accepted") {
  std::vector<uint8_t> memory(4000);
  EventLog log;
  Joiner joiner;
  require_ok(joiner.start({memory.data(), memory.size()}, make_sink(log), InputOrder::sweep));
  Event finish{};
  finish.kind = Kind::finish;
  finish.slice = 7;
  CHECK(joiner.accept(finish) == SinkResult::accepted);
  CHECK(log.events == Events{finish_of({}, 7, false)});
}

TEST_CASE("a joiner is empty and has all of its memory after a finish event") {
  const std::vector<Run> runs = square_runs(2);
  const Events half = fragment_of(test::up, {1, 0, 0}, 6, {runs[0], runs[1]});
  const Events rest = fragment_of(test::up, inwards({1, 0, 0}, 2), 2, {runs[2], runs[3]});
  const auto join_after_half = [&](const Events& second, const JoinCapacities& capacities) {
    Events events = half;
    events.push_back(finish_of({}, 1, false));
    append(events, second);
    Events joined = join_all(events, {InputOrder::sweep, capacities}).events;
    Events expected = half;
    expected.push_back(events[half.size()]);
    expected.back() = joined.at(half.size());  // other tests check its counts
    REQUIRE(joined.size() >= expected.size());
    CHECK(std::equal(expected.begin(), expected.end(), joined.begin()));
    joined.erase(joined.begin(), joined.begin() + static_cast<std::ptrdiff_t>(expected.size()));
    return joined;
  };
  Events both = half;
  append(both, rest);
  CHECK(join_after_half(both, {2, 10}) == square_region({1, 0, 0}, 2).region_end().events);
  CHECK(join_after_half(rest, {2, 10}) == rest);
  // One fragment more than the room.
  Events many;
  for (const int32_t z : {2, 4, 6})
    append(many, fragment_of(test::up, {1, 0, z}, 6, {runs[0], runs[1]}));
  CHECK(join_after_half(many, {2, 10}) == many);
}

TEST_CASE("a stream without a finish event is joined without a finish event") {
  const Events events = fragment_of(test::up, {1, 0, 0}, 6, {Run::straight(0, 2)});
  CHECK(join_all(events, {}).events == events);
  Events begun = events;
  begun.pop_back();
  CHECK(join_all(begun, {}).events.empty());
}

// ---- any events ----

TEST_CASE("the second of two fragments with the same start or end counts as unmatched") {
  const Events first = fragment_of(test::up, {1, 0, 0}, 6, {Run::straight(0, 2)});
  const Events same_start = fragment_of(test::up, {1, 0, 0}, 6, {Run::straight(2, 2)});
  const Events same_end =
      fragment_of(test::up, {-1, 0, 0}, 0, {Run::straight(2, 1), Run::straight(0, 2)});
  for (const Events& second : {same_start, same_end}) {
    Events events = first;
    append(events, second);
    const Joined joined = join_all(events, {});
    CHECK(joined.report.unmatched == 2);
    Events swapped = second;
    append(swapped, first);
    CHECK(joined.events == swapped);
  }
}

TEST_CASE("invalid fragments are dropped and counted") {
  const std::vector<Events> none = {
      fragment_of(no_incidence, {1, 0, 0}, 0, {Run::straight(0, 1)}),
      fragment_of(27, {1, 0, 0}, 0, {Run::straight(0, 1)}),
      fragment_of(255, {1, 0, 0}, 0, {Run::straight(0, 1)}),
      fragment_of(test::up, {1, 0, 0}, 8, {Run::straight(0, 1)}),
      fragment_of(incidence_of({1, 1, 0}), {1, 0, 0}, 4, {Run::straight(0, 1)}),
      fragment_of(incidence_of({1, 1, 1}), {1, 0, 0}, 0, {Run::straight(6, 1)}),
      fragment_of(incidence_of({1, 1, 1}), {1, 0, 0}, 0, {Run::straight(1, 1), Run()}),
      fragment_of(test::up, {1, 0, 0}, 0, {Run::straight(1, Run::max_length + 1)}),
      fragment_of(test::up, {1, 0, 0}, 0, {}),
  };
  for (const Events& events : none) {
    const Joined joined = join_all(events, {});
    CHECK(joined.events.empty());
    CHECK(joined.report.unmatched == 0);
    CHECK(joined.report.invalid == 1);
    CHECK(joined.report.received == 1);
  }
}

TEST_CASE("a fragment without an end is discarded when the next piece begins") {
  Events begun = fragment_of(test::up, {101, 0, 0}, 6, {Run::straight(0, 2)});
  begun.pop_back();
  const Events square = square_region({1, 0, 0}, 3).region_end().events;
  for (const Events& next :
       {square, square_fragment({1, 0, 0}, 3, false), test::Script().layer(1).events}) {
    Events events = begun;
    append(events, next);
    append(events, square);
    Events expected = next.size() > 1 ? square : next;
    append(expected, square);
    CHECK(join_all(events, {}).events == expected);
  }
}

TEST_CASE("an end event without a beginning is ignored") {
  const RecordedEvent lost = test::Script().lost().events[0];
  Events events = fragment_of(test::up, {1, 0, 0}, 6, {Run::straight(0, 2)});
  events.insert(events.end() - 1, lost);
  Joined joined = join_all(events, {});
  CHECK(joined.events.empty());
  CHECK(joined.report.received == 0);

  events = fragment_of(no_incidence, {1, 0, 0}, 0, {Run::straight(0, 1)});
  events.push_back(events.back());
  joined = join_all(events, {});
  CHECK(joined.events.empty());
  CHECK(joined.report.received == 1);
}

TEST_CASE("a region interrupted by a fragment leaves its holes to the next region") {
  const Nest nest({1, 0, 0});
  Events events = square_fragment(inwards({1, 0, 0}, 2), 2, true);
  append(events, nest.begin_region(0).events);
  append(events, square_fragment(inwards({1, 0, 0}, 6), 2, true));
  events.push_back(test::Script().region_end().events[0]);
  append(events, nest.region(0, false));
  const Joined joined = join_all(events, {});
  CHECK(joined.report.unmatched == 0);
  CHECK(joined.report.rings == 2);
  const Events first = nest.region(0, false);
  REQUIRE(joined.events.size() > first.size());
  CHECK(std::equal(first.begin(), first.end(), joined.events.begin()));
}

TEST_CASE("a region interrupted by the finish event gets no holes") {
  // The hole lies beside it, and its ray meets two sides.
  const Events hole = square_fragment(inwards({1, 0, 0}, 2) + Vertex{-60, 0, 0}, 2, true);
  const Events whole = Nest({1, 0, 0}).region(0, false);
  const auto end = whole.begin() + 2;  // before its first run
  const RecordedEvent finish = finish_of({1, 2, 3, 4, 5, 6, 7, 8}, 1, false);
  Events events = hole;
  events.insert(events.end(), whole.begin(), end);
  events.push_back(finish);
  events.insert(events.end(), end, whole.end());
  Events joined = join_all(events, {}).events;
  joined.erase(std::remove_if(joined.begin(), joined.end(),
                              [](const RecordedEvent& event) { return event.is(Kind::finish); }),
               joined.end());
  Events expected(whole.begin(), end);
  append(expected, hole);
  expected.insert(expected.end(), end, whole.end());
  CHECK(joined == expected);
}

TEST_CASE("a ring with winding number zero is not delivered as a region") {
  // An eight.
  std::vector<Run> runs = square_runs(2);
  for (const int direction : {4, 2, 0, 6})
    runs.push_back(Run::straight(static_cast<Direction>(direction), 2));
  for (const InputOrder order : {InputOrder::sweep, InputOrder::any}) {
    const Joined joined = join_all(fragment_of(test::up, {1, 0, 0}, 6, runs), {order});
    CHECK(joined.report.regions == 0);
    CHECK(joined.report.unmatched == 1);
  }
}

TEST_CASE("runs of a side are merged into one run up to the maximal length") {
  constexpr uint32_t most = Run::max_length;
  const auto rings = [&](uint32_t before, uint32_t behind) {
    // One side in two runs, then the rest of the triangle.
    Events events = fragment_of(test::up, {1, 0, 0}, 0, {Run::straight(0, behind)});
    const Vertex step = direction_vector(test::up, 0);
    const Vertex start = Vertex{1, 0, 0} + Vertex{step.x * static_cast<int32_t>(behind),
                                                  step.y * static_cast<int32_t>(behind), 0};
    append(events,
           fragment_of(test::up, start, 0,
                       {Run::straight(2, 5), Run::straight(4, before), Run::straight(4, behind),
                        Run::straight(6, 5), Run::straight(0, before)}));
    return join_all(events, {});
  };
  CHECK(count(rings(most - 7, 7).events, Kind::run) == 4);
  CHECK(count(rings(most - 7, 8).events, Kind::run) == 6);
  CHECK(rings(most - 7, 7).report.regions == 1);
}

TEST_CASE("coordinates wrap for fragments with any start and length") {
  Chance chance(13);
  for (int round = 0; round < 500; ++round) {
    Events events;
    for (int i = 0; i < 20; ++i) {
      const auto coordinate = [&] {
        return static_cast<int32_t>(chance.next()) >> chance.below(31);
      };
      const Incidence incidence = i < 10 ? test::up : static_cast<Incidence>(chance.below(28));
      const Vertex start{coordinate(), coordinate(), coordinate()};
      std::vector<Run> runs;
      for (uint32_t count = chance.below(9); count > 0; --count)
        runs.push_back(Run::from_code(static_cast<uint32_t>(chance.next()) >> chance.below(32)));
      append(events, fragment_of(incidence, start, static_cast<Direction>(chance.below(9)), runs));
      // A ring that wraps; it may get any hole of its plane.
      test::Script script;
      script.region(incidence).ring(start);
      for (const Run run : runs) script.run(run);
      append(events, script.region_end().events);
    }
    JoinPlan plan;
    plan.order = round % 2 == 0 ? InputOrder::sweep : InputOrder::any;
    if (round % 3 == 0) plan.capacities = {1 + chance.below(20), 1 + chance.below(100)};
    const Joined joined = join_all(events, plan);
    CHECK(joined.report.received == 20);
  }
}

TEST_CASE("events in an invalid order terminate and write only to the joiner's memory") {
  Chance chance(14);
  for (int round = 0; round < 300; ++round) {
    const Surface& surface = surfaces()[static_cast<size_t>(round) % surfaces().size()];
    Events events = events_of(cut(surface.regions, cuts_of(chance)));
    if (events.size() > 2000) events.erase(events.begin() + 2000, events.end());
    for (uint32_t damage = 1 + chance.below(20); damage > 0; --damage) {
      const size_t at = chance.below(static_cast<uint32_t>(events.size()));
      const size_t other = chance.below(static_cast<uint32_t>(events.size()));
      if (chance.below(2) == 0) std::swap(events[at], events[other]);
      if (chance.below(2) == 0) events[at] = events[other];
    }
    JoinPlan plan;
    plan.order = round % 2 == 0 ? InputOrder::sweep : InputOrder::any;
    if (round % 3 == 0) plan.capacities = {1 + chance.below(50), 1 + chance.below(200)};
    plan.unjoined = round % 5 != 0 ? Unjoined::passed_on : Unjoined::dropped;
    (void)join_all(events, plan);
  }
}

// ---- the start ----

TEST_CASE("a refused start() of a joiner changes nothing") {
  std::vector<uint8_t> memory(4000, 0xA5);
  const Memory all{memory.data(), memory.size()};
  EventLog log, other;
  Joiner joiner;
  Event layer{};
  layer.kind = Kind::layer;
  CHECK(joiner.finish() == Status::not_started);
  CHECK(joiner.accept(layer) == SinkResult::not_started);
  CHECK(joiner.start(all, Sink{}, InputOrder::any) == Status::bad_sink);
  CHECK(joiner.start({nullptr, 4000}, make_sink(log), InputOrder::any) ==
        Status::too_little_memory);
  CHECK(joiner.start({memory.data(), Joiner::minimum_bytes() - 1}, make_sink(log),
                     InputOrder::any) == Status::too_little_memory);
  for (const JoinCapacities& bad :
       {JoinCapacities{0, 1}, {1, 0}, {JoinCapacities::max_fragments + 1, 1}, {1, UINT32_MAX}})
    CHECK(joiner.start(bad, all, make_sink(log), InputOrder::any) == Status::bad_capacities);
  for (const JoinCapacities& more : {JoinCapacities{100, 100},
                                     {JoinCapacities::max_fragments, 1},
                                     {1, JoinCapacities::max_runs}})
    CHECK(joiner.start(more, all, make_sink(log), InputOrder::any) == Status::too_little_memory);
  CHECK(joiner.finish() == Status::not_started);
  CHECK(memory == std::vector<uint8_t>(4000, 0xA5));

  require_ok(
      joiner.start({memory.data(), Joiner::minimum_bytes()}, make_sink(log), InputOrder::sweep));
  CHECK(joiner.start({memory.data(), 3}, make_sink(other), InputOrder::any) ==
        Status::too_little_memory);
  CHECK(joiner.accept(layer) == SinkResult::accepted);
  CHECK(log.events.size() == 1);
  CHECK(joiner.finish() == Status::ok);
}

TEST_CASE("a restarted joiner is empty") {
  std::vector<uint8_t> memory(4000, 0xA5);
  EventLog log;
  Joiner joiner;
  const Events half = fragment_of(test::up, {1, 0, 0}, 6, {Run::straight(0, 2)});
  for (int i = 0; i < 2; ++i) {
    require_ok(joiner.start({memory.data(), memory.size()}, make_sink(log), InputOrder::sweep));
    CHECK(joiner.peaks().fragments == 0);
    for (const RecordedEvent& event : half)
      REQUIRE(joiner.accept(event.event()) == SinkResult::accepted);
    CHECK(joiner.report().received == 1);
    CHECK(joiner.peaks().fragments == 1);
    CHECK(joiner.peaks().runs == 1);
  }
  CHECK(log.events.empty());
}

TEST_CASE("default_capacities() uses all of the memory and no more") {
  CHECK(Joiner::default_capacities(0).fragments == 1);
  for (const uint32_t fragments : {2U, 3U, 1000U}) {
    const uint64_t bytes = Joiner::bytes_for({fragments, 8 * fragments});
    CHECK(Joiner::default_capacities(bytes).fragments == fragments);
    CHECK(Joiner::default_capacities(bytes - 1).fragments == fragments - 1);
  }
  for (uint64_t bytes = Joiner::bytes_for({1, 8}); bytes < uint64_t{1} << 50;
       bytes = bytes * 5 / 4 + 1) {
    const JoinCapacities split = Joiner::default_capacities(bytes);
    REQUIRE(Joiner::bytes_for(split) <= bytes);
    REQUIRE(split.runs == 8 * split.fragments);
    const bool is_most = split.fragments == JoinCapacities::max_fragments;
    REQUIRE((is_most || Joiner::bytes_for(split) + 5 * split.fragments + 192 + 8 > bytes));
  }
}
