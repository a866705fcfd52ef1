// Groups of extractors and shared outputs do through C what they do in C++.
#include <discmc/discmc.h>
#include <doctest/doctest.h>

#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/shared_output.hpp>
#include <discmc/surface_group.hpp>
#include <vector>

#include "oracle/c_events.hpp"
#include "oracle/stream.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::Bytes;
using discmc::test::Line;

namespace {

constexpr uint32_t width = 11, height = 9, depth = 5;
constexpr uint32_t voxels = width * height * depth;
constexpr uint32_t surfaces = 3;
constexpr int32_t thresholds[surfaces] = {60, 100, 200};
constexpr size_t memory_bytes = 3000;

template <class Sample>
std::vector<Sample> make_samples() {
  std::vector<Sample> samples(voxels);
  test::Chance chance(2);
  for (Sample& sample : samples) sample = static_cast<Sample>(chance.byte());
  return samples;
}

// Every so manyth event is refused.
EventLog::Refuses refuses_every(uint64_t nth) {
  return [nth](uint64_t offer) { return offer % nth == nth - 1; };
}

// The extractors of a group, each with a memory and a sink of its own.
struct GroupInC {
  explicit GroupInC(uint64_t nth) {
    const discmc_limits limits = {width, height, DISCMC_CLOSED, {}};
    for (uint32_t i = 0; i < surfaces; ++i) {
      logs.emplace_back(refuses_every(nth + i));
      memory[i].resize(memory_bytes);
    }
    for (uint32_t i = 0; i < surfaces; ++i) {
      const discmc_sink sink = c_sink_to(logs[i]);
      REQUIRE(discmc_extractor_start(&extractors[i], &limits, nullptr, thresholds[i],
                                     {memory[i].data(), memory_bytes}, &sink) == DISCMC_OK);
    }
    discmc_surface_group_start(&group, extractors, surfaces, width);
  }
  std::vector<EventLog> logs;
  Bytes memory[surfaces];
  discmc_extractor extractors[surfaces] = {};
  discmc_surface_group group = {};
};
struct GroupInCpp {
  explicit GroupInCpp(uint64_t nth) {
    for (uint32_t i = 0; i < surfaces; ++i) {
      logs.emplace_back(refuses_every(nth + i));
      memory[i].resize(memory_bytes);
    }
    for (uint32_t i = 0; i < surfaces; ++i)
      require_ok(extractors[i].start({width, height}, thresholds[i],
                                     {memory[i].data(), memory_bytes}, sink_to(logs[i])));
  }
  std::vector<EventLog> logs;
  Bytes memory[surfaces];
  Extractor16 extractors[surfaces];
  SurfaceGroup<Extractor16> group{extractors, surfaces, width};
};

discmc_push_result push(discmc_surface_group& group, const uint8_t* samples, uint32_t count) {
  return discmc_surface_group_push_u8(&group, samples, count, 1);
}
discmc_push_result push(discmc_surface_group& group, const uint16_t* samples, uint32_t count) {
  return discmc_surface_group_push_u16(&group, samples, count, 1);
}
discmc_push_result push(discmc_surface_group& group, const int16_t* samples, uint32_t count) {
  return discmc_surface_group_push_i16(&group, samples, count, 1);
}

void check_same(const discmc_push_result& c, const PushResult& cpp) {
  REQUIRE(c.status == static_cast<discmc_status>(cpp.status));
  REQUIRE(c.samples == cpp.samples);
}

void check_same_events(const GroupInC& c, const GroupInCpp& cpp) {
  for (uint32_t i = 0; i < surfaces; ++i) {
    CHECK(c.logs[i].events.size() > 50);
    CHECK(c.logs[i].events == cpp.logs[i].events);
  }
}

void finish_both(GroupInC& c, GroupInCpp& cpp) {
  discmc_status status = discmc_surface_group_finish(&c.group);
  REQUIRE(status == static_cast<discmc_status>(cpp.group.finish()));
  while (status == DISCMC_MORE) {
    status = discmc_surface_group_resume(&c.group);
    REQUIRE(status == static_cast<discmc_status>(cpp.group.resume()));
  }
  REQUIRE(status == DISCMC_OK);
}

}  // namespace

TEST_CASE_TEMPLATE("a group does through C what it does in C++, call for call", Sample, uint8_t,
                   uint16_t, int16_t) {
  const std::vector<Sample> samples = make_samples<Sample>();
  GroupInC c(4);
  GroupInCpp cpp(4);
  for (uint32_t done = 0; done < voxels;) {
    const uint32_t count = std::min(voxels - done, 17U);
    const discmc_push_result result = push(c.group, samples.data() + done, count);
    check_same(result, cpp.group.push(samples.data() + done, count));
    done += result.samples;
  }
  finish_both(c, cpp);
  check_same_events(c, cpp);
}

TEST_CASE("a group takes rows of bits, and rows that never came, through C") {
  GroupInC c(1000000);
  GroupInCpp cpp(1000000);
  test::Chance chance(6);
  for (uint32_t row = 0; row < height * depth - 1; ++row) {
    uint8_t bits[surfaces * ((width + 7) / 8)];
    for (uint8_t& byte : bits) byte = chance.byte();
    if (row % 10 == 9)
      check_same(discmc_surface_group_skip_row(&c.group, DISCMC_PREVIOUS_ROW),
                 cpp.group.skip_row(Substitute::previous_row));
    else
      check_same(discmc_surface_group_push_bits(&c.group, bits), cpp.group.push_bits(bits));
  }
  CHECK(discmc_surface_group_finish(&c.group) == DISCMC_SLICE_IN_PROGRESS);
  CHECK(discmc_surface_group_abandon(&c.group) == DISCMC_OK);
  CHECK(cpp.group.abandon() == Status::ok);
  check_same_events(c, cpp);
}

TEST_CASE("a group of zeros is not started") {
  discmc_surface_group group = {};
  const uint8_t samples[3] = {};
  CHECK(push(group, samples, 3).status == DISCMC_NOT_STARTED);
  CHECK(discmc_surface_group_push_bits(&group, samples).status == DISCMC_NOT_STARTED);
  CHECK(discmc_surface_group_skip_row(&group, DISCMC_OFF).status == DISCMC_NOT_STARTED);
  CHECK(discmc_surface_group_resume(&group) == DISCMC_NOT_STARTED);
  CHECK(discmc_surface_group_finish(&group) == DISCMC_NOT_STARTED);
  CHECK(discmc_surface_group_abandon(&group) == DISCMC_NOT_STARTED);
}

namespace {

// The stream of a scan of all surfaces over one link that takes some bytes at a time.
Bytes shared_in_c(size_t bytes_a_time) {
  Line line(bytes_a_time);
  discmc_shared_output shared = {};
  const bool has_output = discmc_shared_output_output(&shared).write != nullptr;
  CHECK_FALSE(has_output);
  const ByteOutput to_line = line.output();
  discmc_shared_output_start(&shared, {to_line.context, to_line.write});
  discmc_encoder encoders[surfaces] = {};
  discmc_extractor extractors[surfaces] = {};
  Bytes memory[surfaces];
  for (uint32_t i = 0; i < surfaces; ++i) {
    const discmc_limits limits = {width, height, DISCMC_CLOSED, {}};
    const discmc_stream_label label = {depth, {0, 0, 0}, 7, static_cast<uint8_t>(i)};
    const discmc_sink sink = {&encoders[i], discmc_encoder_take};
    memory[i].resize(memory_bytes);
    REQUIRE(discmc_encoder_start(&encoders[i], &label, discmc_shared_output_output(&shared)) ==
            DISCMC_OK);
    REQUIRE(discmc_extractor_start(&extractors[i], &limits, nullptr, thresholds[i],
                                   {memory[i].data(), memory_bytes}, &sink) == DISCMC_OK);
  }
  discmc_surface_group group = {};
  discmc_surface_group_start(&group, extractors, surfaces, width);
  const std::vector<uint8_t> samples = make_samples<uint8_t>();
  for (uint32_t done = 0; done < voxels;)
    done += push(group, samples.data() + done, voxels - done).samples;
  discmc_status status = discmc_surface_group_finish(&group);
  while (status == DISCMC_MORE) status = discmc_surface_group_resume(&group);
  REQUIRE(status == DISCMC_OK);
  uint32_t calls = 0;
  while (discmc_shared_output_flush(&shared) == 0) ++calls;
  CHECK((calls > 0) == (bytes_a_time > 0));
  return line.bytes;
}

Bytes shared_in_cpp(size_t bytes_a_time) {
  Line line(bytes_a_time);
  SharedOutput shared;
  shared.start(line.output());
  Encoder encoders[surfaces];
  Extractor16 extractors[surfaces];
  Bytes memory[surfaces];
  for (uint32_t i = 0; i < surfaces; ++i) {
    memory[i].resize(memory_bytes);
    require_ok(encoders[i].start({depth, {0, 0, 0}, 7, static_cast<uint8_t>(i)}, shared.output()));
    require_ok(extractors[i].start({width, height}, thresholds[i], {memory[i].data(), memory_bytes},
                                   sink_to(encoders[i])));
  }
  SurfaceGroup<Extractor16> group(extractors, surfaces, width);
  const std::vector<uint8_t> samples = make_samples<uint8_t>();
  for (uint32_t done = 0; done < voxels;)
    done += group.push(samples.data() + done, voxels - done).samples;
  Status status = group.finish();
  while (status == Status::more) status = group.resume();
  require_ok(status);
  while (!shared.flush()) continue;
  return line.bytes;
}

}  // namespace

TEST_CASE("a shared output carries through C the bytes that it carries in C++") {
  for (const size_t bytes_a_time : {size_t{0}, size_t{5}}) {
    const Bytes stream = shared_in_c(bytes_a_time);
    CHECK(stream.size() > 500);
    CHECK(stream == shared_in_cpp(bytes_a_time));
  }
}
