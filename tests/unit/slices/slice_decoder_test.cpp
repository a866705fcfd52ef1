// The slice decoder alone: refusals, reports, and handwritten packets.
#include <discmc/slice_decoder.hpp>

#include "oracle/slice_stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::test;
using detail::slices::RowNote;
using detail::wire::SliceBits;
using reference::BitVolume;
using Kind = RowEvent::Kind;

namespace {

constexpr reference::Size size{40, 3, 5};
constexpr Limits limits{size.width, size.height};
constexpr uint8_t whole_code = SliceBits::first | SliceBits::last;
constexpr uint8_t of_key = SliceBits::key | whole_code;

SlicePlan plan_of(uint8_t surfaces) {
  SlicePlan plan;
  plan.surface_count = surfaces;
  return plan;
}

// Codes written by hand, from the first row of a key slice on.
class Code {
 public:
  explicit Code(uint8_t surfaces = 1)
      : memory_(SliceEncoder::minimum_bytes({limits, {}, 0, surfaces})) {
    Arena arena({memory_.data(), memory_.size()});
    StreamHeader header = header_of(BitVolume(size));
    header.surface_count = surfaces;
    surfaces_.start(arena, header, detail::slices::rows_kept(limits.height, false));
    surfaces_.clear();
    surfaces_.begin_key_slice();
    begin_code();
  }
  Code(const Code&) = delete;
  Code& operator=(const Code&) = delete;

  Code& note(uint32_t bits) {
    writer_.code_bit(surfaces_.note(), true);
    writer_.raw_bits(detail::slices::note_bits, bits);
    return *this;
  }
  Code& note(RowNote row_note) { return note(static_cast<uint32_t>(row_note)); }
  // The surfaces have their rows in turn.
  Code& row(const Bytes& bits) { return begin_row(bits).rest_of_row(); }
  Code& rows_off(uint32_t count) {
    for (; count > 0; --count) row(Bytes(bytes_of_row));
    return *this;
  }
  // A row up to the first voxel that differs from the row before. The rest follows.
  Code& begin_row(const Bytes& bits) {
    if (surface_ == 0) {
      writer_.code_bit(surfaces_.note(), false);
      if (surfaces_.rows().rows() == 0 && rows_told_ > 0) surfaces_.begin_following_slice();
      ++rows_told_;
    }
    surfaces_[surface_].rows.append_bits(bits.data());
    surfaces_.begin_row(row_, surface_, size.width);
    row_.step(writer_, surfaces_[surface_].model);
    return *this;
  }
  Code& rest_of_row() {
    while (!row_.is_done()) row_.step(writer_, surfaces_[surface_].model);
    if (++surface_ < surfaces_.count()) return *this;
    surface_ = 0;
    surfaces_.next_row();
    return *this;
  }
  // A missing row within a slice.
  Code& repeated_row() {
    note(RowNote::repeated);
    for (detail::slices::CodedSurface& surface : surfaces_) surface.rows.repeat();
    surfaces_.next_row();
    return *this;
  }
  // A run that ends early is coded with a length of at least that of a complete one.
  Code& row_with_a_run_too_long(uint32_t length) {
    writer_.code_bit(surfaces_.note(), false);
    writer_.code_bit(surfaces_[0].model[run_of_a_row], false);
    writer_.raw_bits(6, length);
    return *this;
  }
  Bytes end() { return note(RowNote::end).finish(); }
  // Ends a code without an end mark. The next code continues it.
  Bytes finish() {
    bytes_.resize(writer_.range.finish());
    const Bytes code = bytes_;
    begin_code();
    return code;
  }

 private:
  static constexpr size_t bytes_of_row = (size.width + 7) / 8;
  // The context of 40 voxels, whose number has six bits, to the end of the row.
  static constexpr uint32_t run_of_a_row = detail::slices::context::run + 2 * (6 - 1) + 1;

  void begin_code() {
    bytes_.assign(1000, 0);
    writer_.range = RangeEncoder(bytes_.data(), bytes_.size());
  }

  Bytes memory_, bytes_;
  detail::slices::RowWriter writer_;
  detail::slices::RowCode row_;
  detail::slices::CodedSurfaces surfaces_;
  uint32_t rows_told_ = 0;
  uint32_t surface_ = 0;
};

Bytes little_endian(uint64_t value, int count) {
  Bytes bytes;
  for (; count > 0; --count, value >>= 8) bytes.push_back(static_cast<uint8_t>(value));
  return bytes;
}

// The contents of a packet: the number of a key slice, bytes of code, and a cut.
Bytes payload_of(const std::vector<Bytes>& parts) {
  return joined(parts);
}
Bytes key(uint32_t slice) {
  return little_endian(slice, 4);
}
Bytes cut(uint32_t row, uint32_t left) {
  return payload_of({little_endian(row, 4), little_endian(left, 2)});
}

// A stream of a header and handwritten packets.
class Stream {
 public:
  explicit Stream(uint8_t surfaces = 1) : surfaces_(surfaces) {
    Packet header = packet_of(frames_of(encode_slices(BitVolume(size), plan_of(surfaces))).front());
    header.scan = scan;
    bytes_ = frame_of(header);
  }

  Stream& add(detail::wire::PacketKind kind, uint8_t bits, const Bytes& payload) {
    ++number_;
    const Bytes frame =
        frame_of({static_cast<uint8_t>(static_cast<uint8_t>(kind) + bits),
                  static_cast<uint8_t>(number_), static_cast<uint16_t>(number_ >> 8), payload, scan,
                  static_cast<uint8_t>((surfaces_ - 1) << 6)});
    bytes_.insert(bytes_.end(), frame.begin(), frame.end());
    return *this;
  }
  Stream& slices(uint8_t bits, const std::vector<Bytes>& parts) {
    return add(detail::wire::PacketKind::slices, bits, payload_of(parts));
  }
  // The digest is wrong, so no handwritten stream is complete.
  Stream& trailer(uint64_t rows) {
    return add(detail::wire::PacketKind::slices_trailer, 0,
               payload_of({little_endian(size.depth, 4), Bytes{0}, little_endian(rows, 8),
                           little_endian(0, 8), little_endian(0, 4)}));
  }
  Stream& lose_packets(uint32_t count) {
    number_ += count;
    return *this;
  }

  ReceivedRows received(bool refuses = false) const {
    return decode_slices(bytes_, size, 0, refuses, surfaces_);
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  // Bits after the payload would be voxels of a row if they were read.
  static constexpr uint16_t scan = 0x8000;

  uint8_t surfaces_;
  Bytes bytes_;
  uint32_t number_ = 0;
};

// Checks that a complete but invalid packet delivers nothing and counts as unreadable. The
// following slices are ignored, and the next key slice is decoded.
void check_unreadable(uint8_t bits, const std::vector<Bytes>& parts) {
  const ReceivedRows received = Stream()
                                    .slices(bits, parts)
                                    .slices(whole_code, {Code().rows_off(3).end()})
                                    .slices(of_key, {key(4), Code().rows_off(3).end()})
                                    .received();
  CHECK(received.report.damaged_packets == 1);
  CHECK(received.report.is_unreadable);
  CHECK(received.report.rows == 3);
  CHECK(received.report.lost_rows == 12);
  REQUIRE(received.rows.size() == 4);
  CHECK(received.rows[0].is(Kind::lost));
  CHECK(received.rows[0].event.count == 12);
  CHECK(received.rows[1].event.slice == 4);
}

}  // namespace

TEST_CASE("a slice decoder refuses slices that no encoder produces") {
  const Bytes code = Code().row(Bytes(5, 0x55)).rows_off(2).end();
  REQUIRE(code.size() > 6);
  check_unreadable(SliceBits::key | SliceBits::last, {key(0), code});  // not the first of its code
  check_unreadable(of_key, {Bytes{0, 0, 0}});                          // an incomplete number
  check_unreadable(of_key, {key(Limits::max_slices), code});           // deeper than any scan
  check_unreadable(of_key | SliceBits::cut,
                   {key(0), Bytes{0x80, 0, 0, 0, 1}});  // an incomplete cut
  check_unreadable(of_key | SliceBits::cut, {key(0)});
  check_unreadable(of_key | SliceBits::cut, {key(0), Bytes{0x80}});
  check_unreadable(
      SliceBits::key | SliceBits::first | SliceBits::cut,  // cut, although more follows
      {key(0), code, cut(0, 1)});
  check_unreadable(SliceBits::key | SliceBits::first, {key(0), Bytes{1, 2, 3}});  // ends too soon
  check_unreadable(
      of_key, {key(0), Code().note(RowNote::repeated).end()});  // repeats a row before the slice
  for (const uint32_t length : {size.width, size.width + 1, 63U})
    check_unreadable(of_key, {key(0), Code().row_with_a_run_too_long(length).end()});
  for (uint32_t note = 3; note < 8; ++note)
    check_unreadable(of_key, {key(0), Code().note(note).end()});  // undefined notes
}

TEST_CASE("a code without an end, or with bytes after its end, counts as a damaged packet") {
  const Bytes rows = Code().rows_off(2).finish();
  Bytes more = Code().rows_off(2).end();
  more.resize(more.size() + 8);
  const StreamReport endless = Stream().slices(of_key, {key(0), rows}).received().report;
  CHECK(endless.rows >= 2);
  CHECK(endless.damaged_packets == 1);
  const StreamReport longer =
      Stream().slices(SliceBits::key | SliceBits::first, {key(0), more}).received().report;
  CHECK(longer.rows == 2);
  CHECK(longer.damaged_packets == 1);
}

TEST_CASE("a truncated code counts as a damaged packet and yields fewer than 50 rows") {
  const Bytes dotted = Code().row(Bytes(5, 0x55)).end();
  for (size_t bytes = 0; bytes + 1 < dotted.size(); ++bytes) {
    const Bytes part(dotted.begin(), dotted.begin() + static_cast<std::ptrdiff_t>(bytes));
    const StreamReport report = Stream().slices(of_key, {key(0), part}).received().report;
    CHECK(report.rows < 50);
    CHECK(report.damaged_packets == 1);
  }
}

TEST_CASE("a code continues a row only if the previous code was cut in that row") {
  constexpr uint8_t of_cut = of_key | SliceBits::cut;
  const Bytes one_on{0, 4, 0, 0, 0};
  Code code;
  const Bytes begun = code.begin_row(one_on).finish();
  const Bytes rest = code.rest_of_row().rows_off(2).end();
  const ReceivedRows received =
      Stream().slices(of_cut, {key(0), begun, cut(0, 29)}).slices(whole_code, {rest}).received();
  CHECK(received.report.damaged_packets == 0);
  REQUIRE(received.rows.size() == 3);
  Bytes voxels(size.width);
  voxels[10] = 1;
  CHECK(received.rows[0].bits == voxels);
  CHECK(received.rows[2].bits == Bytes(size.width));

  // The packet claims a cut, but the code has ended.
  const Bytes rows = Code().rows_off(2).end();
  const StreamReport uncut = Stream()
                                 .slices(of_cut, {key(0), rows, cut(1, 29)})
                                 .slices(whole_code, {rest})
                                 .received()
                                 .report;
  CHECK(uncut.rows == 2);
  CHECK(uncut.damaged_packets == 1);
  // A code begins in the middle of a row that the previous code did not finish.
  Bytes dotted = Code().row(Bytes(5, 0x55)).end();
  REQUIRE(dotted.size() > 10);
  dotted.resize(8);
  const StreamReport torn = Stream()
                                .slices(SliceBits::key | SliceBits::first, {key(0), dotted})
                                .slices(whole_code, {rest})
                                .received()
                                .report;
  CHECK(torn.rows == 0);
  CHECK(torn.damaged_packets == 1);
}

TEST_CASE("a code may be cut within the row of any surface") {
  for (const uint32_t surface : {0U, 1U, 2U}) {
    CAPTURE(surface);
    Code code(3);
    code.rows_off(3 + surface);
    const Bytes begun = code.begin_row({0, 4, 0, 0, 0}).finish();
    const Bytes rest = code.rest_of_row().rows_off(3 - surface - 1).rows_off(3).end();
    const ReceivedRows received =
        Stream(3)
            .slices(of_key | SliceBits::cut, {key(0), begun, cut(3 + surface, 29)})
            .slices(whole_code, {rest})
            .received();
    CHECK(received.report.damaged_packets == 0);
    CHECK(received.report.rows == 3);
    REQUIRE(received.rows.size() == 9);
    for (uint32_t i = 0; i < 9; ++i) {
      Bytes voxels(size.width);
      voxels[10] = i == 3 + surface ? 1 : 0;
      CHECK(received.rows[i].bits == voxels);
      CHECK(received.rows[i].event.channel == i % 3);
      CHECK(received.rows[i].event.row == i / 3);
    }
  }
}

TEST_CASE("a lost packet after a cut loses the rows up to the next key slice") {
  Code code;
  const Bytes begun = code.begin_row({0, 4, 0, 0, 0}).finish();
  const ReceivedRows received = Stream()
                                    .slices(of_key | SliceBits::cut, {key(0), begun, cut(0, 29)})
                                    .lose_packets(1)
                                    .slices(of_key, {key(2), Code().rows_off(3).end()})
                                    .received();
  CHECK(received.report.damaged_packets == 0);
  CHECK(received.report.lost_rows == 6);
  CHECK(received.report.rows == 3);
}

TEST_CASE("a key slice before the current position, or amid the current rows, is refused") {
  const ReceivedRows again = Stream()
                                 .slices(of_key, {key(0), Code().rows_off(3).end()})
                                 .slices(of_key, {key(0), Code().rows_off(3).end()})
                                 .received();
  CHECK(again.report.rows == 3);
  CHECK(again.report.is_unreadable);
  for (const uint32_t slice : {0U, 1U, 2U}) {
    CAPTURE(slice);
    const StreamReport report = Stream()
                                    .slices(of_key, {key(0), Code().rows_off(4).end()})
                                    .slices(of_key, {key(slice), Code().rows_off(1).end()})
                                    .received()
                                    .report;
    CHECK(report.rows == (slice == 2 ? 5 : 4));
    CHECK(report.lost_rows == (slice == 2 ? 2 : 0));
    CHECK(report.is_unreadable == (slice < 2));
  }
}

TEST_CASE("a key slice with the last slice number is accepted, and all previous rows are lost") {
  const uint32_t slice = Limits::max_slices - 1;
  const ReceivedRows received =
      Stream().slices(of_key, {key(slice), Code().rows_off(1).end()}).received();
  REQUIRE(received.rows.size() == 2);
  CHECK(received.rows[0].event.count == uint64_t{slice} * size.height);
  CHECK(received.rows[1].event.slice == slice);
}

TEST_CASE("a trailer that counts fewer rows than arrived reports no lost rows") {
  for (const uint64_t rows : {3U, 4U, 5U}) {
    const ReceivedRows received =
        Stream().slices(of_key, {key(0), Code().rows_off(4).end()}).trailer(rows).received();
    CHECK(received.report.has_trailer);
    CHECK(received.report.lost_rows == (rows == 5 ? 1 : 0));
    CHECK(received.rows.back().is(Kind::finish));
    CHECK_FALSE(received.report.is_complete());
  }
}

TEST_CASE("a restarted slice decoder is independent of the previous stream") {
  const BitVolume volume = reference::random({40, 9, 8}, 60, 4);
  SlicePlan plan{{2}};
  plan.surface_count = 2;
  std::vector<Bytes> frames = frames_of(encode_slices(volume, plan));
  REQUIRE(frames.size() > 5);
  frames.erase(frames.end() - 2);
  const Bytes stream = joined(frames);
  const ReceivedRows expected = decode_slices(stream, {40, 9, 8}, 0, false, 2);
  REQUIRE(expected.report.lost_rows > 0);

  struct Taker {
    SinkResult accept(const RowEvent&) {
      return left-- > 0 ? SinkResult::accepted : SinkResult::busy;
    }
    int left;
  };
  Bytes memory(SliceDecoder::minimum_bytes({40, 9}, 2));
  const Memory all{memory.data(), memory.size()};
  SliceDecoder decoder;
  for (size_t count = 0; count < stream.size(); count += 23)
    for (const int most : {1000, 0, 1, 24}) {
      Taker taker{most};
      reference::require_ok(decoder.start(all, make_row_sink(taker)));
      (void)decoder.push(stream.data(), count);
      RowLog log(false);
      log.set_width(40);
      reference::require_ok(decoder.start(all, make_row_sink(log)));
      reference::require_ok(push_stream(decoder, stream, 0));
      CHECK(log.starts.size() == 1);
      REQUIRE(log.rows.size() == expected.rows.size());
      for (size_t i = 0; i < log.rows.size(); ++i) CHECK(log.rows[i].bits == expected.rows[i].bits);
      CHECK(decoder.report().lost_rows == expected.report.lost_rows);
    }
}

TEST_CASE("a restarted slice decoder forgets the refused event and the last slice") {
  const Bytes stream = Stream().slices(of_key, {key(0), Code().rows_off(3).end()}).bytes();
  const Bytes unheard = Stream().slices(whole_code, {Code().rows_off(3).end()}).bytes();
  Bytes memory(SliceDecoder::minimum_bytes(limits));
  const Memory all{memory.data(), memory.size()};
  SliceDecoder decoder;
  RowLog log(false);
  reference::require_ok(decoder.start({}, make_row_sink(log)));
  CHECK(decoder.push(stream.data(), stream.size()).status == Status::too_little_memory);
  for (const uint64_t rows : {3U, 0U}) {
    const Bytes& bytes = rows > 0 ? stream : unheard;
    reference::require_ok(decoder.start(all, make_row_sink(log)));
    reference::require_ok(decoder.push(bytes.data(), bytes.size()).status);
    CHECK(decoder.report().rows == rows);
    CHECK(decoder.report().damaged_packets == 0);
  }
}

TEST_CASE("a packet may end after four bytes of a code, which the next packet continues") {
  const Bytes code = Code().row(Bytes(5, 0x55)).rows_off(2).end();
  const auto fifth = code.begin() + 4;
  const StreamReport report =
      Stream()
          .slices(SliceBits::key | SliceBits::first, {key(0), Bytes(code.begin(), fifth)})
          .slices(SliceBits::last, {Bytes(fifth, code.end())})
          .received()
          .report;
  CHECK(report.rows == 3);
  CHECK(report.damaged_packets == 0);
}

TEST_CASE("packets between a loss and the next key slice are ignored") {
  const StreamReport report = Stream()
                                  .slices(of_key, {key(0), Code().rows_off(3).end()})
                                  .lose_packets(1)
                                  .slices(whole_code, {Code().rows_off(3).end()})
                                  .slices(of_key, {key(3), Code().rows_off(3).end()})
                                  .received()
                                  .report;
  CHECK(report.rows == 6);
  CHECK(report.lost_rows == 6);
  CHECK(report.damaged_packets == 0);
}

TEST_CASE("packets after the trailer are ignored") {
  const ReceivedRows received = Stream()
                                    .slices(of_key, {key(0), Code().rows_off(3).end()})
                                    .trailer(3)
                                    .slices(of_key, {key(1), Code().rows_off(3).end()})
                                    .trailer(3)
                                    .received();
  CHECK(received.report.rows == 3);
  CHECK(received.report.repeated_packets == 2);
  CHECK(received.rows.back().is(Kind::finish));
}

TEST_CASE(
    "a sink may refuse starts, rows, losses and the end, and the decoder repeats each event") {
  const Bytes stream =
      Stream(2)
          .slices(of_key, {key(1), Code(2).rows_off(2).repeated_row().rows_off(2).end()})
          .add(detail::wire::PacketKind::slices_application, 0, Bytes(12, 7))
          .lose_packets(1)
          .slices(of_key, {key(4), Code(2).rows_off(6).end()})
          .trailer(15)
          .bytes();
  using Fields = std::array<uint64_t, 5>;
  struct Sullen {
    SinkResult accept(const RowEvent& event) {
      refused = refuses && !refused;
      if (refused) return SinkResult::busy;
      const bool is_lost = event.kind == Kind::lost;
      events.push_back({static_cast<uint64_t>(event.kind), event.slice, event.row,
                        is_lost ? event.count : 0, is_lost ? 0U : event.channel});
      return SinkResult::accepted;
    }
    bool refuses;
    bool refused = false;
    std::vector<Fields> events{};
  } willing{false}, sullen{true};
  Bytes memory(SliceDecoder::minimum_bytes(limits, 2));
  for (Sullen* sink : {&willing, &sullen}) {
    SliceDecoder decoder;
    reference::require_ok(decoder.start({memory.data(), memory.size()}, make_row_sink(*sink)));
    reference::require_ok(push_stream(decoder, stream, 0));
    CHECK(decoder.report().rows == 6);
    CHECK(decoder.report().lost_rows == 9);
  }
  Sullen wall{true};
  SliceDecoder waiting;
  reference::require_ok(waiting.start({memory.data(), memory.size()}, make_row_sink(wall)));
  const Decoded refused = waiting.push(stream.data(), stream.size());
  CHECK(refused.status == Status::suspended);
  CHECK(refused.bytes == frames_of(stream).front().size());
  CHECK(willing.events.size() == 1 + 1 + 6 + 1 + 1 + 6 + 1);
  CHECK(willing.events == sullen.events);
}

TEST_CASE("a truncated frame at the end of a stream of slices counts as damaged") {
  Bytes stream = Stream().trailer(0).bytes();
  stream.push_back(1);
  CHECK(decode_slices(stream, size).report.damaged_packets == 1);
}

TEST_CASE("slice_decoder_bytes() is exactly sufficient for any width") {
  for (const uint32_t width : {1U, 8U, 9U, 64U, 65U, 1000U, 32766U}) {
    CAPTURE(width);
    const Bytes stream = encode_slices(reference::random({width, 2, 2}, 60, 3));
    CHECK(decode_slices(stream, {width, 2, 2}).report.is_complete());
    Bytes memory(SliceDecoder::minimum_bytes({width, 2}) - 1);
    SliceDecoder decoder;
    RowLog log(false);
    CHECK(decoder.push(stream.data(), 1).bytes == 0);
    reference::require_ok(decoder.start({memory.data(), memory.size()}, make_row_sink(log)));
    CHECK(decoder.push(stream.data(), stream.size()).status == Status::too_little_memory);
  }
}

TEST_CASE("set_memory() succeeds only for a started slice decoder without enough memory") {
  const Bytes stream = encode_slices(reference::random(size, 60, 3));
  Bytes memory(SliceDecoder::minimum_bytes(limits));
  const Memory all{memory.data(), memory.size()};
  SliceDecoder decoder;
  RowLog log(false);
  CHECK(decoder.set_memory(all) == Status::not_started);
  reference::require_ok(decoder.start({}, make_row_sink(log)));
  CHECK(decoder.set_memory(all) == Status::ok);
  CHECK(decoder.push(stream.data(), stream.size()).status == Status::too_little_memory);
  CHECK(decoder.finish() == Status::too_little_memory);
  CHECK(decoder.set_memory({memory.data(), memory.size() - 1}) == Status::too_little_memory);
  CHECK(log.starts.empty());
  CHECK(decoder.set_memory(all) == Status::ok);
  const size_t first_frame = frames_of(stream).front().size();
  CHECK(decoder.push(stream.data() + first_frame, stream.size() - first_frame).status ==
        Status::ok);
  CHECK(decoder.report().is_complete());
  CHECK(decoder.finish() == Status::ok);
}

TEST_CASE("a slice decoder ignores a stream of regions and needs no memory for that stream") {
  const BitVolume volume = reference::random(size, 60, 3);
  SliceDecoder decoder;
  RowLog log(false);
  reference::require_ok(decoder.start({}, make_row_sink(log)));
  CHECK(push_stream(decoder, encode(events_of(volume), header_of(volume)), 0) == Status::ok);
  CHECK(log.starts.empty());
  CHECK(log.rows.empty());
  CHECK(decoder.report().has_trailer);
  CHECK_FALSE(decoder.report().holds_slices);
}

TEST_CASE("packet numbers of slices wrap, and numbers half their range ahead count as repeated") {
  constexpr uint32_t half = 1U << 23;
  const Bytes code = Code().rows_off(1).end();
  for (const uint32_t lost : {0U, 1U, 255U, 256U, 65535U, 65536U, half - 1, half, 2 * half - 2}) {
    CAPTURE(lost);
    const StreamReport report =
        Stream().lose_packets(lost).slices(of_key, {key(0), code}).received().report;
    CHECK(report.lost_packets == (lost < half ? lost : 0));
    CHECK(report.repeated_packets == (lost < half ? 0 : 1));
    CHECK(report.rows == (lost < half ? 1 : 0));
  }
  const auto record = detail::wire::PacketKind::slices_application;
  CHECK(Stream().lose_packets(300).add(record, 0, Bytes(9)).received().report.lost_packets == 300);
  Stream stream;
  for (uint32_t slice = 0; slice < 5; ++slice)
    stream.lose_packets(half - 1).slices(of_key, {key(slice), code});
  CHECK(stream.received().report.rows == 5);
  CHECK(stream.received().report.lost_packets == 5 * (half - 1));
}

TEST_CASE("a trailer of slices below the minimal length is ignored") {
  const ReceivedRows received =
      Stream().add(detail::wire::PacketKind::slices_trailer, 0, Bytes(24)).received();
  CHECK_FALSE(received.report.has_trailer);
  CHECK(received.report.damaged_packets == 1);
  CHECK(received.rows.empty());
}

TEST_CASE("lost packets disable the check of the trailer's digest") {
  for (const uint32_t lost : {0U, 1U, 300U}) {
    const StreamReport report = Stream().lose_packets(lost).trailer(0).received().report;
    CHECK(report.has_trailer);
    CHECK(report.lost_packets == lost);
    CHECK(report.is_mixed == (lost == 0));
  }
}

TEST_CASE("a refused finish event is offered again") {
  const Bytes stream =
      Stream().slices(of_key, {key(0), Code().rows_off(3).end()}).trailer(3).bytes();
  Bytes memory(SliceDecoder::minimum_bytes(limits));
  RowLog log(true);
  log.set_width(limits.width);
  SliceDecoder decoder;
  reference::require_ok(decoder.start({memory.data(), memory.size()}, make_row_sink(log)));
  CHECK(push_until_done(decoder, stream) == stream.size());
  CHECK(log.rows.back().is(RowEvent::Kind::finish));
}
