// A scan continues while its link is dead, and the stream resumes with the link.
#include "oracle/slice_config.hpp"
#include "oracle/slice_stream.hpp"
#include "oracle/stream_samples.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;

using reference::BitVolume;
using reference::require_ok;

namespace {

const BitVolume volume = reference::random({24, 20, 16}, 60, 5);

template <class Pushes>
Status push_rows(Pushes& scanner, uint32_t& row, uint32_t end) {
  for (; row < end; ++row) {
    const Status status = scanner.push(&volume.on[row * volume.width], volume.width).status;
    if (status != Status::ok) return status;
  }
  return Status::ok;
}

constexpr uint32_t all_rows = 20 * 16;

// Pushes the rows of a volume as regions until the line fails.
struct RegionScan {
  explicit RegionScan(LimitedLine& line) {
    require_ok(encoder.start(header_of(volume).label(), line.output()));
    require_ok(
        extractor.start({volume.width, volume.height}, 1, memory_of(memory), make_sink(encoder)));
    REQUIRE(push_rows(extractor, row, all_rows) == Status::suspended);
    ++row;  // the row that suspended the scan was accepted
  }
  Encoder encoder;
  Extractor16 extractor;
  Bytes memory = Bytes(60000);
  uint32_t row = 0;
};

// The bytes before the failure, and the time at which the link was repaired.
Bytes arrived(const LimitedLine& dead, const Line& back) {
  Bytes bytes = dead.bytes;
  bytes.insert(bytes.end(), back.bytes.begin(), back.bytes.end());
  return bytes;
}

}  // namespace

TEST_CASE("a scan with a dead link continues or is abandoned, and dropped bytes are counted") {
  const uint64_t whole = encode(events_of(volume), header_of(volume)).size();
  for (const size_t dies_after : {size_t{0}, size_t{100}, size_t{1000}})
    for (const bool is_abandoned : {false, true}) {
      CAPTURE(dies_after);
      LimitedLine line{dies_after};
      RegionScan scan(line);
      REQUIRE(scan.extractor.resume() == Status::suspended);
      REQUIRE(line.bytes.size() == dies_after);
      scan.encoder.set_output({});
      if (is_abandoned) {
        require_ok(scan.extractor.abandon());
        continue;
      }
      require_ok(scan.extractor.resume());
      require_ok(push_rows(scan.extractor, scan.row, all_rows));
      require_ok(scan.extractor.finish());
      CHECK(scan.encoder.bytes() == whole);
      CHECK(line.bytes.size() == dies_after);
    }
}

TEST_CASE("a stream of regions reports its loss after the link recovers") {
  LimitedLine dead{1500};
  Line back;
  RegionScan scan(dead);
  scan.encoder.set_output({});
  require_ok(scan.extractor.resume());
  require_ok(push_rows(scan.extractor, scan.row, all_rows / 2));
  scan.encoder.set_output(back.output());
  require_ok(push_rows(scan.extractor, scan.row, all_rows));
  require_ok(scan.extractor.finish());
  const Received received = decode(arrived(dead, back));
  CHECK(received.report.has_trailer);
  CHECK(received.report.lost_packets > 0);
  CHECK(received.report.lost_pieces > 0);
  CHECK(received.report.regions + received.report.fragments + received.report.lost_pieces ==
        received.report.totals.regions + received.report.totals.fragments);
  CHECK_FALSE(received.report.is_complete());
  // A late receiver finds a header after the first packet.
  CHECK(packet_of(frames_of(back.bytes)[1]).is(detail::wire::PacketKind::header));
}

TEST_CASE("a stream of slices continues with a key slice after the link recovers") {
  LimitedLine dead{300};
  Line back;
  StartedSliceEncoder encoder(header_of(volume), dead.output());
  uint32_t row = 0;
  REQUIRE(push_rows(encoder, row, all_rows) == Status::suspended);
  ++row;
  encoder.set_output({});
  require_ok(encoder.resume());
  require_ok(push_rows(encoder, row, all_rows / 2 + 3));
  encoder.set_output(back.output());
  require_ok(push_rows(encoder, row, all_rows));
  require_ok(encoder.finish());
  const ReceivedRows received =
      decode_slices(arrived(dead, back), {volume.width, volume.height, 0});
  CHECK(received.report.has_trailer);
  CHECK(received.report.rows + received.report.lost_rows == all_rows);
  uint32_t last = 0;
  for (const RecordedRow& recorded : received.rows)
    if (recorded.is(RowEvent::Kind::row) && recorded.event.slice > volume.depth / 2) ++last;
  CHECK(last == volume.height * (volume.depth / 2 - 1));
  // A late receiver reads as many.
  const StreamReport late = decode_slices(back.bytes, {volume.width, volume.height, 0}).report;
  CHECK(late.rows == last);
}

TEST_CASE("a receiver connected between two packets receives a header at once") {
  const uint32_t slice = volume.width * volume.height;
  Line before, after;
  StartedSliceEncoder encoder(header_of(volume), before.output());
  require_ok(encoder.push(volume.on.data(), slice).status);
  require_ok(encoder.flush());
  const uint64_t sent = encoder.bytes();
  encoder.set_output({});
  require_ok(encoder.resume());
  CHECK(encoder.bytes() == sent);
  encoder.set_output(after.output());
  require_ok(encoder.push(&volume.on[slice], slice).status);
  require_ok(encoder.abandon());
  const size_t of_trailer = before.bytes.size();
  encoder.set_output(before.output());
  require_ok(encoder.resume());
  CHECK(before.bytes.size() == of_trailer);
  const StreamReport late = decode_slices(after.bytes, {volume.width, volume.height, 0}).report;
  CHECK(late.rows == volume.height);
  CHECK(decode_slices(before.bytes, {volume.width, volume.height, 0}).report.rows == volume.height);
  CHECK(late.repeated_packets == 0);
}

TEST_CASE("a change of output before the stream begins leaves the stream unchanged") {
  Line line;
  Encoder encoder;
  require_ok(encoder.start(header_of(volume).label(), line.output()));
  encoder.set_output(line.output());
  const StreamHeader header = header_of(volume);
  REQUIRE(encoder.accept(start_of(header)) == SinkResult::accepted);
  encode_all(encoder, events_of(volume));
  CHECK(line.bytes == encode(events_of(volume), header_of(volume)));
}

TEST_CASE("bytes of a finished packet are sent to the new output, followed by a header") {
  LimitedLine dead{SIZE_MAX};
  Line back;
  StartedSliceEncoder encoder(header_of(volume), dead.output());
  require_ok(encoder.resume());
  dead.room = 0;
  const uint8_t bytes[] = {1, 2, 3};
  require_ok(encoder.write_record({1, 0, 0, bytes, 3}));
  encoder.set_output(back.output());
  require_ok(encoder.resume());
  const std::vector<Bytes> frames = frames_of(back.bytes);
  REQUIRE(frames.size() == 2);
  CHECK(packet_of(frames[0]).is(detail::wire::PacketKind::slices_application));
  CHECK(packet_of(frames[1]).is(detail::wire::PacketKind::header));
}

TEST_CASE("a zero byte ends a truncated frame once, before the next stream") {
  LimitedLine line{3};
  Bytes memory(SliceEncoder::minimum_bytes({{1, 1}}));
  SliceEncoder encoder;
  const auto start = [&](const ByteOutput& output) {
    require_ok(encoder.start({{1, 1}}, memory_of(memory), output));
    return encoder.resume();
  };
  CHECK(start(line.output()) == Status::suspended);
  CHECK(start(line.output()) == Status::suspended);  // nothing goes out
  line.room = SIZE_MAX;
  require_ok(start(line.output()));
  CHECK(line.bytes[3] == 0);
  const size_t header = line.bytes.size() - 4;
  require_ok(start(line.output()));
  CHECK(line.bytes.size() == 4 + 2 * header);
}

TEST_CASE("a stream that begins within a truncated frame of another stream is complete") {
  const Bytes regions = encode(events_of(volume), header_of(volume));
  const Bytes slices = encode_slices(volume);
  for (const bool is_of_slices : {false, true}) {
    const Bytes& whole = is_of_slices ? slices : regions;
    const size_t first_frame = frames_of(whole)[0].size();
    for (const size_t before : {size_t{0}, size_t{1}, first_frame - 1, first_frame, size_t{100}}) {
      INFO("is_of_slices ", is_of_slices, ", before ", before);
      LimitedLine line{before};
      Bytes expected(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(before));
      if (before > 0 && before != first_frame) expected.push_back(0);
      expected.insert(expected.end(), whole.begin(), whole.end());
      uint32_t row = 0;
      if (is_of_slices) {
        Bytes memory(SliceEncoder::minimum_bytes({{volume.width, volume.height}}));
        SliceEncoder encoder;
        for (const Status status : {Status::suspended, Status::ok}) {
          require_ok(
              encoder.start(slice_config(header_of(volume)), memory_of(memory), line.output()));
          CHECK(push_rows(encoder, row, all_rows) == status);
          row = 0;
          line.room = SIZE_MAX;
        }
        require_ok(encoder.finish());
      } else {
        RegionScan scan(line);
        line.room = SIZE_MAX;
        require_ok(scan.encoder.start(header_of(volume).label(), line.output()));
        require_ok(scan.extractor.start({volume.width, volume.height}, 1, memory_of(scan.memory),
                                        make_sink(scan.encoder)));
        require_ok(push_rows(scan.extractor, row, all_rows));
        require_ok(scan.extractor.finish());
        CHECK(scan.encoder.flush() == Status::ok);
      }
      CHECK(line.bytes == expected);
    }
  }
}
