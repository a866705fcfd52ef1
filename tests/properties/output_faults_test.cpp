// An output fails at any byte: once, twice or permanently. The scan waits, and the stream equals
// that without a failure.
#include "oracle/stream_samples.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using namespace discmc::reference;

namespace {

// Accepts bytes up to each of its stops, then refuses several calls.
class Stopping {
 public:
  static constexpr size_t for_ever = SIZE_MAX;

  explicit Stopping(std::vector<size_t> stops = {}, size_t patience = 1)
      : stops_(std::move(stops)), patience_(patience) {}

  ByteOutput output() {
    return {this, [](void* context, const uint8_t* data, size_t count) {
              return static_cast<Stopping*>(context)->write(data, count);
            }};
  }
  void recover() { stops_.clear(); }

  Bytes bytes;

 private:
  size_t write(const uint8_t* data, size_t count) {
    if (!stops_.empty() && bytes.size() == stops_.front()) {
      if (asked_ == for_ever || ++asked_ <= patience_) return 0;
      asked_ = 0;
      stops_.erase(stops_.begin());
    }
    if (!stops_.empty()) count = std::min(count, stops_.front() - bytes.size());
    bytes.insert(bytes.end(), data, data + count);
    return count;
  }

  std::vector<size_t> stops_;
  size_t patience_;
  size_t asked_ = 0;
};

// A scan with little memory, whose stream is sent by an encoder.
struct Scenario {
  BitVolume volume;
  Capacities capacities;
  uint32_t refused_in = 0;  // one offer in this many is refused before the encoder receives it
};

// A sink in front of the encoder, which may also be busy.
struct Gate {
  Encoder& encoder;
  uint32_t refused_in;
  uint32_t offers = 0;
  uint64_t accepted = 0;

  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) return encoder.accept(event);
    if (refused_in > 0 && ++offers % refused_in == 0) return SinkResult::busy;
    const SinkResult answer = encoder.accept(event);
    accepted += answer == SinkResult::accepted;
    return answer;
  }
};

class Device {
 public:
  Device(const Scenario& scenario, Stopping& output)
      : scenario_(scenario),
        limits_(limits_of(scenario.volume, Border::closed)),
        block_(Extractor16::bytes_for(limits_, scenario.capacities)) {
    begin_stream(output);
    require_ok(
        extractor_.start(limits_, scenario.capacities, 1, block_.memory(), make_sink(gate_)));
  }

  /// Scans until `patience` successive calls make no progress. Returns true at the end.
  bool run(size_t patience) {
    const BitVolume& volume = scenario_.volume;
    const auto total = static_cast<uint32_t>(volume.voxels());
    for (size_t busy = 0; busy < patience;) {
      const uint64_t before = gate_.accepted;
      Status status = Status::ok;
      if (at_ < total) {
        const PushResult pushed = extractor_.push(volume.on.data() + at_, total - at_);
        status = pushed.status;
        at_ += pushed.samples;
      } else {
        status = extractor_.finish();
        if (status == Status::ok) return true;
      }
      if (status != Status::suspended) require_ok(status);
      busy = status == Status::suspended && gate_.accepted == before ? busy + 1 : 0;
    }
    return false;
  }

  /// Begins the scan again, with another output.
  void reset(Stopping& output) {
    begin_stream(output);
    require_ok(extractor_.reset());
    at_ = 0;
  }

  bool is_intact() const { return block_.is_intact(); }
  uint64_t bytes() const { return encoder_.bytes(); }

 private:
  void begin_stream(Stopping& output) {
    require_ok(encoder_.start(header_of(scenario_.volume).label(), output.output()));
  }

  const Scenario& scenario_;
  Limits limits_;
  Block block_;
  Encoder encoder_;
  Gate gate_{encoder_, scenario_.refused_in};
  Extractor16 extractor_;
  uint32_t at_ = 0;
};

constexpr size_t many = 100;

std::vector<Scenario> scenarios() {
  const BitVolume noise = random({6, 5, 4}, 110, 1);
  const Capacities few{60, 4};
  return {{noise, few},
          {noise, few, 3},
          {noise, minimum_capacities()},
          {ball({12, 12, 12}, {11, 11, 11}, 30), minimum_capacities()}};
}

Bytes stream_of(const Scenario& scenario, const std::vector<size_t>& stops = {},
                size_t patience = 1) {
  Stopping output(stops, patience);
  Device device(scenario, output);
  if (!device.run(many)) throw std::runtime_error("the scan does not end");
  if (!device.is_intact()) throw std::runtime_error("a write outside the arena");
  return output.bytes;
}

// Samples whose streams are short enough to test a stop at every byte.
std::vector<Sample> short_samples() {
  std::vector<Sample> all;
  for (const Sample& sample : samples())
    if (encode(sample.events, sample.header).size() < 4000) all.push_back(sample);
  return all;
}

}  // namespace

TEST_CASE(
    "an output that fails permanently at any byte suspends the encoder, and no byte is lost") {
  for (const Sample& sample : short_samples()) {
    CAPTURE(sample.name);
    const Bytes whole = encode(sample.events, sample.header);
    for (size_t stop = 0; stop < whole.size(); stop += step(7)) {
      CAPTURE(stop);
      Stopping output({stop}, Stopping::for_ever);
      Encoder encoder;
      REQUIRE(begin_stream(encoder, sample.header, output.output()) == Status::ok);
      size_t next_event = 0;
      while (encoder.accept(sample.events[next_event].event()) == SinkResult::accepted)
        ++next_event;
      for (int i = 0; i < 5; ++i) {
        CHECK(encoder.accept(sample.events[next_event].event()) == SinkResult::busy);
        CHECK(encoder.flush() == Status::suspended);
        CHECK(encoder.bytes() == stop);
      }
      output.recover();
      encode_all(encoder, {sample.events.begin() + static_cast<std::ptrdiff_t>(next_event),
                           sample.events.end()});
      CHECK(output.bytes == whole);
    }
  }
}

TEST_CASE(
    "an output that fails once at any byte leaves the stream of a scan short of memory unchanged") {
  for (const Scenario& scenario : scenarios()) {
    const Bytes whole = stream_of(scenario);
    for (size_t stop = 0; stop < whole.size(); stop += step(5)) {
      CAPTURE(stop);
      CHECK(stream_of(scenario, {stop}, 1 + stop % 3) == whole);
    }
  }
}

TEST_CASE("an output that fails repeatedly leaves the stream unchanged") {
  const Scenario scenario = scenarios()[1];
  const Bytes whole = stream_of(scenario);
  for (size_t stop = 0; stop < whole.size(); stop += step(13))
    for (const size_t more : {1U, 2U, 254U, 256U}) {
      INFO("stop ", stop, ", more ", more);
      CHECK(stream_of(scenario, {stop, stop + more, stop + 2 * more}, 2) == whole);
    }
}

TEST_CASE("a scan whose output fails at any byte waits, and resumes or restarts") {
  for (const Scenario& scenario : scenarios()) {
    const Bytes whole = stream_of(scenario);
    for (size_t stop = 0; stop < whole.size(); stop += step(5)) {
      CAPTURE(stop);
      Stopping output({stop}, Stopping::for_ever);
      Device device(scenario, output);
      REQUIRE_FALSE(device.run(many));
      CHECK(device.bytes() == stop);
      if (stop % 2 == 0) {
        output.recover();
        REQUIRE(device.run(many));
        CHECK(output.bytes == whole);
      } else {
        Stopping another;
        device.reset(another);
        REQUIRE(device.run(many));
        const bool is_cut = stop > 0 && whole[stop - 1] != 0;
        Bytes expected(is_cut ? 1 : 0);  // the zero that ends the frame
        expected.insert(expected.end(), whole.begin(), whole.end());
        CHECK(another.bytes == expected);
      }
      CHECK(device.is_intact());
    }
  }
}

TEST_CASE("flushes between faults move the ends of packets and lose no event") {
  for (const Sample& sample : short_samples()) {
    CAPTURE(sample.name);
    const size_t size = encode(sample.events, sample.header).size();
    for (size_t stop = 0; stop < size; stop += 5 * step(3)) {
      CAPTURE(stop);
      Stopping output({stop, stop + 3, stop + 259}, 2);
      Encoder encoder;
      REQUIRE(begin_stream(encoder, sample.header, output.output()) == Status::ok);
      size_t calls = 0;
      for (const RecordedEvent& recorded : sample.events)
        while (encoder.accept(recorded.event()) == SinkResult::busy)
          if (++calls % 2 == 0) (void)encoder.flush();
      const Received arrival = decode(output.bytes);
      REQUIRE(arrival.events == sample.events);
      CHECK(arrival.report.is_complete());
    }
  }
}
