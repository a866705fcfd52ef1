// Encoders in C and in C++ write the same bytes.
#include <discmc/discmc.h>

#include "oracle/c_events.hpp"
#include "oracle/normal_events.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;
using discmc::test::Bytes;
using discmc::test::Line;

namespace {

struct Stream {
  Stream(const discmc_encoder_kind& kind, size_t bytes, Line& line) : memory(bytes) {
    config.kind = &kind;
    config.label = {7, {1000, -2000, 3000}, 300, 5};
    config.memory = {memory.memory().data, bytes};
    config.output = in_c(line.output());
  }
  void start() { REQUIRE(discmc_encoder_start(&encoder, &config) == DISCMC_OK); }

  Block memory;
  discmc_encoder_config config{};
  discmc_encoder* encoder = nullptr;
};

const StreamHeader header{12, 9, 7, {1000, -2000, 3000}, {-5}, Border::open, 5, 300};

// Offers a start with a header of C, without the members that C lacks.
discmc_sink_result begin(discmc_encoder* encoder, uint32_t width) {
  const auto scan = std::make_unique<discmc_stream_header>(
      discmc_stream_header{width, 9, 0, {0, 0, 0}, {-5}, DISCMC_OPEN, 0, 0, 1, 0});
  discmc_event event{};
  event.kind = DISCMC_START;
  event.of.header = scan.get();
  return discmc_encoder_accept(encoder, &event);
}

const Events& events() {
  static const Events all =
      test::events_of(random({12, 9, 7}, 128, 3), Extractor32::default_capacities({12, 9}, 3000));
  return all;
}

// With a normal at every run.
Events with_normals(const Events& plain) {
  Events all;
  for (const RecordedEvent& recorded : plain) {
    Event event = recorded.event();
    if (event.kind == Event::Kind::run)
      event.normal = {static_cast<uint8_t>(1 + all.size() % 255), 9};
    all.emplace_back(event);
  }
  return all;
}

void encode_all(discmc_encoder* encoder, const Events& all, size_t first, size_t end) {
  for (size_t i = first; i < end; ++i) {
    const Event event = all[i].event();
    while (discmc_encoder_accept(encoder, reinterpret_cast<const discmc_event*>(&event)) !=
           DISCMC_SINK_ACCEPTED)
      continue;
  }
}

void compare(const discmc_encoder_kind& kind, Encoder& encoder, const Events& all) {
  const size_t bytes = DISCMC_ENCODER_BYTES;
  Line line(5), other_line(5);
  Stream stream(kind, bytes, line);
  stream.start();
  CHECK(begin(stream.encoder, 12) == DISCMC_SINK_ACCEPTED);
  const size_t middle = all.size() / 2;
  encode_all(stream.encoder, all, 0, middle);

  // The power fails after a part of a frame was written; the frame is sent again.
  for (int i = 0; i < 2; ++i) CHECK(discmc_encoder_flush(stream.encoder) == DISCMC_SUSPENDED);
  discmc_memory part;
  REQUIRE(discmc_encoder_save(stream.encoder, &part) == DISCMC_OK);
  CHECK(part.data == stream.config.memory.data);
  CHECK(part.bytes == bytes);
  Stream later(kind, bytes, other_line);
  CHECK(discmc_encoder_restore(&later.encoder, &later.config) == DISCMC_BAD_CHECKPOINT);
  const auto* const saved = static_cast<const uint8_t*>(part.data);
  std::copy_n(saved, bytes, static_cast<uint8_t*>(later.config.memory.data));
  later.config.output.write = nullptr;
  CHECK(discmc_encoder_restore(&later.encoder, &later.config) == DISCMC_BAD_SINK);
  later.config.output = in_c(other_line.output());
  std::copy_n(saved, bytes, static_cast<uint8_t*>(later.config.memory.data));
  REQUIRE(discmc_encoder_restore(&later.encoder, &later.config) == DISCMC_OK);
  CHECK(discmc_encoder_stream_bytes(later.encoder) < line.bytes.size());
  line.bytes.resize(discmc_encoder_stream_bytes(later.encoder));

  encode_all(later.encoder, all, middle, all.size());
  while (discmc_encoder_flush(later.encoder) == DISCMC_SUSPENDED) continue;
  CHECK((stream.memory.is_intact() && later.memory.is_intact()));
  CHECK(discmc_encoder_stream_bytes(later.encoder) == line.bytes.size() + other_line.bytes.size());
  line.bytes.insert(line.bytes.end(), other_line.bytes.begin(), other_line.bytes.end());

  Line expected;
  require_ok(test::begin_stream(encoder, header, expected.output()));
  const auto half = all.begin() + static_cast<std::ptrdiff_t>(middle);
  test::encode_all(encoder, Events(all.begin(), half));
  CHECK(encoder.flush() == Status::ok);
  test::encode_all(encoder, Events(half, all.end()));
  CHECK(encoder.flush() == Status::ok);
  CHECK(line.bytes == expected.bytes);
}

}  // namespace

TEST_CASE("encoders of both kinds write the same bytes in C as in C++") {
  Encoder plain;
  compare(discmc_regions, plain, events());
  test::NormalEncoder normal;
  compare(discmc_regions_with_normals, normal, with_normals(events()));
}

TEST_CASE("records, outputs and further scans of encoders behave in C as in C++") {
  Line line, other_line, cpp_line, other_cpp_line;
  Stream stream(discmc_regions, DISCMC_ENCODER_BYTES, line);
  stream.start();
  Encoder encoder;
  const uint8_t bytes[] = {1, 2, 3};
  const discmc_application_record record = {4, 5, 6, bytes, sizeof bytes};
  CHECK(discmc_encoder_write_record(stream.encoder, &record) == DISCMC_NOT_STARTED);
  require_ok(test::begin_stream(encoder, header, cpp_line.output()));
  CHECK(begin(stream.encoder, 12) == DISCMC_SINK_ACCEPTED);

  CHECK(discmc_encoder_write_record(stream.encoder, &record) == DISCMC_OK);
  require_ok(encoder.write_record({4, 5, 6, bytes, sizeof bytes}));
  const discmc_application_record too_long = {4, 0, 0, bytes, DISCMC_MAX_RECORD_BYTES + 1};
  CHECK(discmc_encoder_write_record(stream.encoder, &too_long) == DISCMC_BAD_RECORD);

  for (const bool drops : {true, false}) {
    discmc_encoder_set_output(stream.encoder,
                              drops ? discmc_byte_output{} : in_c(other_line.output()));
    encoder.set_output(drops ? ByteOutput{} : other_cpp_line.output());
    encode_all(stream.encoder, events(), drops ? 0 : 1000, drops ? 1000 : events().size());
    test::encode_all(encoder, Events(events().begin() + (drops ? 0 : 1000),
                                     drops ? events().begin() + 1000 : events().end()));
  }
  CHECK(discmc_encoder_write_record(stream.encoder, &record) == DISCMC_FINISHED);
  CHECK(begin(stream.encoder, 14) == DISCMC_SINK_ACCEPTED);
  StreamHeader further = header;
  further.width = 14;
  CHECK(encoder.accept(test::start_of(further)) == SinkResult::accepted);
  CHECK(discmc_encoder_flush(stream.encoder) == DISCMC_OK);
  CHECK(encoder.flush() == Status::ok);
  CHECK(line.bytes == cpp_line.bytes);
  CHECK(other_line.bytes == other_cpp_line.bytes);
  CHECK(discmc_encoder_stream_bytes(stream.encoder) == encoder.bytes());
}

TEST_CASE("invalid calls of encoders in C return their status") {
  Line line;
  Stream stream(discmc_regions, DISCMC_ENCODER_BYTES, line);
  stream.config.label.channel = DISCMC_MAX_CHANNEL + 1;
  CHECK(discmc_encoder_start(&stream.encoder, &stream.config) == DISCMC_BAD_LABEL);
  stream.config.label.channel = DISCMC_MAX_CHANNEL;
  stream.config.output.write = nullptr;
  CHECK(discmc_encoder_start(&stream.encoder, &stream.config) == DISCMC_BAD_SINK);
  stream.config.output = in_c(line.output());
  stream.config.memory.bytes = 800;
  CHECK(discmc_encoder_start(&stream.encoder, &stream.config) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(discmc_encoder_restore(&stream.encoder, &stream.config) == DISCMC_TOO_LITTLE_MEMORY);
  CHECK(stream.encoder == nullptr);
  stream.config.memory.bytes = DISCMC_ENCODER_BYTES;
  stream.start();
  discmc_event region{};
  region.kind = DISCMC_REGION;
  CHECK(discmc_encoder_accept(stream.encoder, &region) == DISCMC_SINK_NOT_STARTED);
  CHECK(discmc_encoder_accept(nullptr, &region) == DISCMC_SINK_NOT_STARTED);
  discmc_encoder* none = nullptr;
  discmc_encoder_config without_kind = stream.config;
  without_kind.kind = nullptr;
  CHECK(discmc_encoder_start(&none, &without_kind) == DISCMC_NO_KIND);
  CHECK(discmc_encoder_restore(&none, &without_kind) == DISCMC_NO_KIND);

  // A checkpoint of the other kind.
  discmc_memory part;
  CHECK(discmc_encoder_save(stream.encoder, &part) == DISCMC_NOT_STARTED);
  CHECK(begin(stream.encoder, 12) == DISCMC_SINK_ACCEPTED);
  REQUIRE(discmc_encoder_save(stream.encoder, &part) == DISCMC_OK);
  CHECK(discmc_encoder_restore(&stream.encoder, &stream.config) == DISCMC_OK);
  stream.config.kind = &discmc_regions_with_normals;
  stream.config.memory.bytes += 200;
  CHECK(discmc_encoder_restore(&stream.encoder, &stream.config) == DISCMC_BAD_CHECKPOINT);
}
