// A stream of slices over a lossy link: every loss is reported at its position, and no row is
// wrong.
#include "oracle/slice_stream.hpp"
#include "oracle/thinned.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using reference::BitVolume;
using Kind = RowEvent::Kind;

namespace {

constexpr reference::Size size{40, 12, 60};
constexpr uint32_t all_rows = size.height * size.depth;

struct Sent {
  explicit Sent(uint32_t interval)
      : volume(reference::random(size, 128, 3)),
        stream(encode_slices(volume, {{interval}})),
        frames(frames_of(stream)) {}
  BitVolume volume;
  Bytes stream;
  std::vector<Bytes> frames;
};

const Sent& sent_with_keys() {
  static const Sent sent(4);
  return sent;
}

// Checks that every decoded row is correct and at its position. Returns the number of missing rows.
uint64_t check_told_rows(const BitVolume& volume, const ReceivedRows& received) {
  size_t next = 0, lost = 0;
  bool is_over = false;
  for (const RecordedRow& row : received.rows) {
    REQUIRE_FALSE(is_over);
    is_over = row.is(Kind::finish);
    if (is_over) break;
    const size_t at = size_t{row.event.slice} * volume.height + row.event.row;
    REQUIRE(at == next);
    if (row.is(Kind::lost)) {
      REQUIRE(row.event.count > 0);
      lost += row.event.count;
      next += row.event.count;
      continue;
    }
    REQUIRE(row.is(Kind::row));
    const uint8_t* const first = &volume.on[next * volume.width];
    REQUIRE(row.bits == Bytes(first, first + volume.width));
    ++next;
  }
  CHECK(received.report.lost_rows == lost);
  CHECK(received.report.rows + lost == next);
  if (is_over) CHECK(next == uint64_t{volume.height} * volume.depth);
  return lost;
}

ReceivedRows arrive(const std::vector<Bytes>& frames) {
  return decode_slices(joined(frames), size);
}

}  // namespace

TEST_CASE("a lost packet loses only the rows up to the next key slice") {
  const Sent& sent = sent_with_keys();
  REQUIRE(sent.frames.size() > 20);
  for (size_t i = 1; i + 1 < sent.frames.size(); ++i) {
    CAPTURE(i);
    std::vector<Bytes> frames = sent.frames;
    frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(i));
    const ReceivedRows received = arrive(frames);
    const uint64_t lost = check_told_rows(sent.volume, received);
    CHECK(lost > 0);
    CHECK(lost <= 4 * size.height);
    CHECK(received.report.lost_packets == 1);
    CHECK_FALSE(received.report.is_complete());
    CHECK(received.rows.back().is(Kind::finish));
  }
}

TEST_CASE("a loss of 256 packets before a header is detected, even after other losses") {
  constexpr reference::Size small{40, 3, 200};
  const BitVolume volume = reference::random(small, 128, 3);
  SlicePlan plan{{1}};
  plan.flush_every = 1;  // one packet per row
  const std::vector<Bytes> frames = frames_of(encode_slices(volume, plan));
  constexpr size_t from_header_to_header = 1 + detail::wire::header_interval;
  constexpr size_t end = 4 * from_header_to_header, gap = 256;
  for (size_t header = 0; header + end < frames.size(); header += from_header_to_header) {
    CAPTURE(header);
    REQUIRE(packet_of(frames[header + end]).is(detail::wire::PacketKind::header));
    std::vector<Bytes> kept;
    for (size_t i = 0; i < frames.size(); ++i) {
      const bool is_lost = i == header + 1 || (i + gap >= header + end && i < header + end);
      if (!is_lost) kept.push_back(frames[i]);
    }
    const ReceivedRows received = decode_slices(joined(kept), small);
    check_told_rows(volume, received);
    CHECK(received.report.lost_packets == 1 + gap);
  }
}

TEST_CASE("a trailer with more rows than the maximum of a scan is ignored") {
  const Sent& sent = sent_with_keys();
  Packet trailer = packet_of(sent.frames.back());
  std::fill_n(trailer.payload.begin() + 5, 8, uint8_t{0xFF});
  std::vector<Bytes> frames = sent.frames;
  frames.back() = frame_of(trailer);
  const ReceivedRows received = arrive(frames);
  CHECK(received.report.rows == all_rows);
  CHECK(received.report.lost_rows == uint64_t{Limits::max_slices} * size.height - all_rows);
  CHECK_FALSE(received.report.is_complete());
}

TEST_CASE("a lost packet loses all later rows if the stream has no key slices") {
  const Sent sent(0);
  for (size_t i = 1; i + 1 < sent.frames.size(); i += 5) {
    std::vector<Bytes> frames = sent.frames;
    frames.erase(frames.begin() + static_cast<std::ptrdiff_t>(i));
    const ReceivedRows received = arrive(frames);
    CHECK(check_told_rows(sent.volume, received) > 0);
    CHECK(received.report.rows < all_rows);
  }
}

TEST_CASE("a late receiver receives all rows from the next key slice on") {
  const Sent& sent = sent_with_keys();
  for (size_t first = 1; first + 2 < sent.frames.size(); first += 3) {
    CAPTURE(first);
    // Headers are repeated after 64 packets; one of them is where the receiver starts.
    std::vector<Bytes> frames(sent.frames.begin() + static_cast<std::ptrdiff_t>(first),
                              sent.frames.end());
    frames.insert(frames.begin(), sent.frames[0]);
    const ReceivedRows received = arrive(frames);
    check_told_rows(sent.volume, received);
    CHECK(received.report.lost_packets == first - 1);
  }
}

TEST_CASE("every decoded row is right for any mixture of lost packets") {
  const Sent& sent = sent_with_keys();
  Chance chance(4);
  for (int round = 0; round < 300; ++round) {
    CAPTURE(round);
    std::vector<Bytes> frames;
    const uint32_t percent = chance.below(70);
    for (const Bytes& frame : sent.frames)
      if (chance.below(100) >= percent) frames.push_back(frame);
    if (frames.empty()) continue;
    const ReceivedRows received = arrive(frames);
    check_told_rows(sent.volume, received);
  }
}

TEST_CASE("repeated packets of slices are decoded once") {
  const Sent& sent = sent_with_keys();
  for (const size_t back : {0U, 1U, 7U, 30U}) {
    std::vector<Bytes> frames;
    for (size_t i = 0; i < sent.frames.size(); ++i) {
      frames.push_back(sent.frames[i]);
      if (i >= back) frames.push_back(sent.frames[i - back]);
    }
    const ReceivedRows received = arrive(frames);
    CHECK(check_told_rows(sent.volume, received) == 0);
    CHECK(received.report.is_complete());
    CHECK(received.report.repeated_packets + back == sent.frames.size());
  }
}

TEST_CASE("the later of two swapped packets is decoded") {
  const Sent& sent = sent_with_keys();
  for (size_t i = 1; i + 2 < sent.frames.size(); ++i) {
    CAPTURE(i);
    std::vector<Bytes> frames = sent.frames;
    std::swap(frames[i], frames[i + 1]);
    const ReceivedRows received = arrive(frames);
    CHECK(check_told_rows(sent.volume, received) <= 8 * size.height);
    CHECK(received.report.repeated_packets == 1);
  }
}

TEST_CASE("a stream of slices truncated anywhere yields only right rows") {
  const Sent& sent = sent_with_keys();
  for (size_t bytes = 0; bytes < sent.stream.size(); bytes += bytes < 600 ? 1 : 37) {
    CAPTURE(bytes);
    const Bytes part(sent.stream.begin(), sent.stream.begin() + static_cast<std::ptrdiff_t>(bytes));
    const ReceivedRows received = decode_slices(part, size);
    CHECK(check_told_rows(sent.volume, received) == 0);
    CHECK_FALSE(received.report.is_complete());
  }
}

TEST_CASE("a flipped bit damages one or two packets and yields no wrong row") {
  const BitVolume volume = reference::random({20, 6, 12}, 60, 9);
  const Bytes stream = encode_slices(volume, {{3}});
  uint32_t complete = 0;
  for (size_t bit = 0; bit < 8 * stream.size(); ++bit) {
    CAPTURE(bit);
    Bytes damaged = stream;
    damaged[bit / 8] = static_cast<uint8_t>(damaged[bit / 8] ^ 1U << bit % 8);
    const ReceivedRows received = decode_slices(damaged, {20, 6, 12});
    check_told_rows(volume, received);
    if (received.report.is_complete()) ++complete;
  }
  // A header lost before any other leaves no trace. All other damage is detected.
  CHECK(complete == 0);
}

TEST_CASE("packets with random bytes under a correct checksum yield a bounded number of rows") {
  const Sent& sent = sent_with_keys();
  Chance chance(6);
  for (uint32_t round = 0; round < 2000; round += reference::step(5)) {
    CAPTURE(round);
    std::vector<Bytes> frames = sent.frames;
    Packet packet = packet_of(frames[1 + chance.below(5)]);
    const uint32_t at = chance.below(static_cast<uint32_t>(packet.payload.size()));
    if (round % 2 == 0)
      packet.payload.resize(at);
    else
      packet.payload[at] = chance.byte();
    if (round % 3 == 0) packet.kind = static_cast<uint8_t>(8 + chance.below(8));
    frames[1 + chance.below(5)] = frame_of(packet);
    const ReceivedRows received = arrive(frames);
    CHECK(received.report.rows <= all_rows + 100000);
  }
}

TEST_CASE("a key slice and its first row are coded independently of earlier rows") {
  const BitVolume volume = reference::random({40, 1, 12}, 128, 3);
  Line line;
  StartedSliceEncoder encoder(header_of(volume), line.output(), 2);
  for (uint32_t row = 0; row < 12; ++row) {
    const PushResult result = row % 4 == 2 ? encoder.skip_row(Substitute::previous_row)
                                           : encoder.push(&volume.on[row * 40], 40);
    reference::require_ok(result.status);
  }
  reference::require_ok(encoder.finish());
  const ReceivedRows whole = decode_slices(line.bytes, {40, 1, 12});
  REQUIRE(whole.report.is_complete());
  std::vector<Bytes> frames = frames_of(line.bytes);
  frames.erase(frames.begin() + 1);
  const ReceivedRows received = arrive(frames);
  REQUIRE(received.rows.size() == 12);
  CHECK(received.rows[0].is(Kind::lost));
  CHECK(received.rows[0].event.count == 2);
  for (size_t row = 2; row < 12; ++row) CHECK(received.rows[row - 1].bits == whole.rows[row].bits);
  CHECK(whole.rows[2].bits == Bytes(40));
}
