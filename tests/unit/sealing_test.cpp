// Rows of cells are cut off where records may not suffice, as late as possible, and for sinks alone
// that take no fragments: the surface is the same.
#include <doctest/doctest.h>

#include <vector>

#include "oracle/agreement.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

struct Bordered {
  BitVolume volume;
  Border border;

  bool is_closed() const { return border == Border::closed; }
  Collector scanned(uint32_t records) const {
    Collector collector(false);
    scan_into<uint16_t>(collector, volume, {border, false}, Capacities{records, records});
    return collector;
  }
  bool is_cut(uint32_t records) const {
    return unlike_merge(scanned(records).regions(), volume, is_closed()) != "";
  }
};

// Of one word and of several, and of more rows than there are bits in a word.
std::vector<Bordered> volumes() {
  std::vector<Bordered> volumes;
  for (const Border border : {Border::closed, Border::open})
    for (const Size size : {Size{5, 4, 6}, Size{65, 3, 4}, Size{3, 67, 4}, Size{3, 63, 3}})
      for (const uint32_t density : {30U, 128U, 240U})
        volumes.push_back({random(size, density, density), border});
  return volumes;
}

}  // namespace

TEST_CASE(
    "whatever rows of cells are cut off, the surface and the counts are those of the volume") {
  for (const Bordered& bordered : volumes())
    for (const uint32_t records : {4U, 100U, 300U, 800U, 2000U, 5000U}) {
      CAPTURE(bordered.is_closed());
      CAPTURE(bordered.volume.width);
      CAPTURE(records);
      const Collector collector = bordered.scanned(records);
      CHECK(unlike_surface(collector.regions(), bordered.volume, bordered.is_closed()) == "");
      CHECK(miscounted(collector, bordered.volume, bordered.is_closed()) == "");
    }
}

TEST_CASE("with the fewest records every cell is cut off, and none of its facets merges") {
  const Bordered box{reference::box({4, 3, 3}, {1, 1, 1}, {2, 1, 1}), Border::closed};
  // Eight corners and four edges of two voxels side by side.
  CHECK(box.scanned(4).regions().size() == 12);
  CHECK(box.scanned(4).statistics().cells == 12);
}

TEST_CASE("holes wait for the ring around them, however few may wait to go out loose") {
  BitVolume plate = box({13, 7, 3}, {0, 0, 1}, {12, 6, 1});
  for (const int64_t x : {2, 6, 10}) plate.on[plate.index(x, 2, 1)] = 0;
  Collector collector(false);
  scan_into<uint16_t>(collector, plate, {Border::closed, false}, Capacities{30000, 1});
  CHECK(unlike_merge(collector.regions(), plate, true) == "");
}

TEST_CASE("so many records are just enough for nothing to be cut off") {
  struct Known {
    Bordered bordered;
    uint32_t records;
  };
  const Known all[] = {
      {{box({3, 3, 3}, {0, 0, 0}, {2, 2, 2}), Border::closed}, 786},
      {{box({3, 6, 6}, {0, 0, 0}, {1, 5, 5}), Border::open}, 243},
      {{box({3, 40, 3}, {1, 0, 1}, {1, 39, 1}), Border::closed}, 2956},
      {{box({3, 67, 4}, {0, 0, 0}, {1, 66, 3}), Border::open}, 2317},
      {{box({40, 3, 3}, {0, 0, 1}, {39, 2, 1}), Border::closed}, 8402},
      {{box({40, 3, 3}, {0, 0, 1}, {39, 2, 1}), Border::open}, 5309},
  };
  for (const Known& known : all) {
    CAPTURE(known.records);
    CHECK(known.bordered.is_cut(known.records - 1));
    CHECK_FALSE(known.bordered.is_cut(known.records));
  }
}

TEST_CASE("a longer volume needs no more records for nothing to be cut off") {
  for (const uint32_t length : {3U, 30U, 90U}) {
    const Bordered along_z{box({3, 3, length}, {0, 0, 0}, {2, 2, 2}), Border::closed};
    const auto last = static_cast<int32_t>(length) - 1;
    const Bordered bar{box({1, 1, length}, {0, 0, 0}, {0, 0, last}), Border::closed};
    CAPTURE(length);
    CHECK(bar.is_cut(297));
    CHECK_FALSE(bar.is_cut(298));
    CHECK_FALSE(along_z.is_cut(786));
  }
}

TEST_CASE(
    "a sink that refuses cells is offered them again, and after a reset the scan begins anew") {
  const BitVolume volume = random({33, 5, 4}, 128, 1);
  Capacities few{200, 10};
  const auto scanned = [&](const EventLog::Refuses& refuses, uint32_t broken_off_after) {
    EventLog log(refuses);
    const Limits limits = limits_of(volume, Border::closed);
    Block block(bytes_for<uint16_t>(limits, few));
    Extractor16 extractor;
    require_ok(extractor.start(limits, few, 1, block.memory(), region_sink_to(log)));
    if (broken_off_after > 0) {
      (void)extractor.push(volume.on.data(), broken_off_after);
      require_ok(extractor.reset());
      log = EventLog();
    }
    push_all(extractor, volume.on);
    finish_all(extractor);
    CHECK(block.is_intact());
    return log.events;
  };
  for (const uint32_t records : {200U, 3000U}) {
    few.records = records;
    const Events expected = scanned({}, 0);
    CHECK(scanned(refuses_first, 0) == expected);
    const auto samples = static_cast<uint32_t>(volume.voxels());
    for (uint64_t refused = 0; refused < expected.size(); refused += expected.size() / 20 + 1)
      CHECK(scanned([&](uint64_t offer) { return offer >= refused; }, samples) == expected);
  }
}
