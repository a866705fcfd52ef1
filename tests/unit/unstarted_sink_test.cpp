// An unstarted sink is an error. If it were busy instead, its source would wait forever.
#include <discmc/joiner.hpp>
#include <discmc/receiver.hpp>

#include "oracle/slice_stream.hpp"
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using reference::Block;
using reference::require_ok;

namespace {

constexpr Limits limits{6, 5};

BitVolume volume() {
  return reference::random({6, 5, 4}, 100, 1);
}

Bytes regions() {
  return encode(events_of(volume()), header_of(volume()));
}

// Checks that decoding fails at the start event, and continues once the encoder is started.
template <class Decoding>
void check_refusal(Decoding& decoder, Encoder& encoder, const Bytes& stream) {
  const Decoded first = decoder.push(stream.data(), stream.size());
  CHECK(first.status == Status::bad_sink);
  CHECK(first.bytes < stream.size());
  CHECK(decoder.push(nullptr, 0).status == Status::bad_sink);
  CHECK(decoder.finish() == Status::bad_sink);
  Line line;
  require_ok(encoder.start(header_of(volume()).label(), line.output()));
  const Decoded rest = decoder.push(stream.data() + first.bytes, stream.size() - first.bytes);
  CHECK(rest.status == Status::ok);
  CHECK(decode(line.bytes).report.is_complete());
}

}  // namespace

TEST_CASE("an extractor refuses an unstarted encoder, directly or behind a joiner") {
  Block block(Extractor16::minimum_bytes(limits));
  Extractor16 extractor;
  Encoder encoder;
  CHECK(extractor.start(limits, 1, block.memory(), make_sink(encoder)) == Status::bad_sink);
  Joiner joiner;
  CHECK(extractor.start(limits, 1, block.memory(), make_sink(joiner)) == Status::bad_sink);
  Bytes memory(Joiner::minimum_bytes());
  require_ok(joiner.start({memory.data(), memory.size()}, make_sink(encoder), InputOrder::sweep));
  CHECK(extractor.start(limits, 1, block.memory(), make_sink(joiner)) == Status::bad_sink);
  CHECK(extractor.finish() == Status::not_started);
}

TEST_CASE("a decoder reports an unstarted encoder, and continues after the encoder is started") {
  Encoder encoder;
  Decoder decoder;
  require_ok(decoder.start(make_sink(encoder)));
  check_refusal(decoder, encoder, regions());
}

TEST_CASE("a decoder reports an unstarted joiner, and an unstarted encoder behind a joiner") {
  Encoder encoder;
  Joiner joiner;
  Decoder decoder;
  require_ok(decoder.start(make_sink(joiner)));
  const Bytes stream = regions();
  const Decoded first = decoder.push(stream.data(), stream.size());
  CHECK(first.status == Status::bad_sink);
  Bytes memory(4000);
  require_ok(joiner.start({memory.data(), memory.size()}, make_sink(encoder), InputOrder::sweep));
  require_ok(decoder.start(make_sink(joiner)));
  check_refusal(decoder, encoder, stream);
}

TEST_CASE("finish() of a joiner reports an unstarted sink") {
  struct Listener {
    SinkResult accept(const Event& event) {
      return event.kind == Event::Kind::finish ? SinkResult::not_started : SinkResult::accepted;
    }
  } listener;
  Bytes memory(4000);
  Joiner joiner;
  require_ok(joiner.start({memory.data(), memory.size()}, make_sink(listener), InputOrder::any));
  for (const RecordedEvent& event : events_of(volume()))
    REQUIRE(joiner.accept(event.event()) == SinkResult::accepted);
  CHECK(joiner.finish() == Status::bad_sink);
}

TEST_CASE("a surface decoder reports an unstarted encoder for both kinds of streams") {
  for (const Bytes& stream : {regions(), encode_slices(volume())}) {
    Bytes memory(Receiver::minimum_bytes(limits) + 20000);
    Encoder encoder;
    SurfaceDecoder decoder;
    require_ok(decoder.start({memory.data(), memory.size()}, make_sink(encoder)));
    check_refusal(decoder, encoder, stream);
  }
}

TEST_CASE("an encoder refuses events before the header of the stream") {
  std::vector<Bytes> frames = frames_of(regions());
  REQUIRE(frames.size() > 2);
  frames.erase(frames.begin());
  const Bytes headless = joined(frames);
  Line line;
  Encoder encoder;
  Decoder decoder;
  require_ok(encoder.start({}, line.output()));
  require_ok(decoder.start(make_sink(encoder)));
  CHECK(decoder.push(headless.data(), headless.size()).status == Status::bad_sink);
  CHECK(line.bytes.empty());
}
