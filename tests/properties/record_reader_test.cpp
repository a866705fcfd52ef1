// Streams of regions as read by a reader that uses WIRE.md alone.
#include "oracle/record_reader.hpp"

#include <doctest/doctest.h>

#include "oracle/golden.hpp"
#include "oracle/stream_samples.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::RecordRead;
using Kind = Event::Kind;

namespace {

// The events that records bring, as the reader has them.
std::vector<RecordRead> records_of(const Events& events) {
  std::vector<RecordRead> records;
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    const Vertex& start = event.start;
    if (recorded.is(Kind::region)) records.push_back({"region", {event.incidence}});
    if (recorded.is(Kind::ring)) records.push_back({"ring", {start.x, start.y, start.z}});
    if (recorded.is(Kind::run))
      records.push_back({"run", {event.run.direction(), event.run.length()}});
    if (recorded.is(Kind::region_end)) records.push_back({"region end", {}});
    if (recorded.is(Kind::fragment))
      records.push_back(
          {"fragment", {event.incidence, event.incoming_direction, start.x, start.y, start.z}});
    if (recorded.is(Kind::fragment_end)) records.push_back({"fragment end", {}});
    if (recorded.is(Kind::layer)) records.push_back({"layer", {event.slice}});
    if (recorded.is(Kind::skipped))
      records.push_back({"skipped", {event.slice, event.row, event.repeated ? 1 : 0}});
  }
  return records;
}

void check_read(const Bytes& stream, const Events& events) {
  CHECK(reference::read_records(stream, DISCMC_SOURCE_DIR) == records_of(events));
}

}  // namespace

TEST_CASE("the reader of WIRE.md decodes the encoder's events") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    check_read(encode(sample.events, sample.header), sample.events);
  }
}

TEST_CASE("the reader of WIRE.md decodes fragments from either end, among regions and in parts") {
  Chance chance(3);
  Script script;
  for (uint32_t i = 0; i < 300; ++i) {
    if (chance.below(2) == 0)
      add_ragged_fragment(script, chance, 1 + chance.below(120), 40);
    else
      add_ragged_region(script, chance, 2 + chance.below(120), 40);
    if (chance.below(9) == 0) script.layer(i);
  }
  check_read(encode(script.events), script.events);
}

TEST_CASE("the reader of WIRE.md decodes the golden streams of regions") {
  for (const char* name : {"single_voxel.dmc", "noise.dmc", "loose_fragments.dmc"}) {
    CAPTURE(name);
    const Bytes stream = golden(name);
    check_read(stream, decode(stream).events);
  }
}
