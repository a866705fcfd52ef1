#include <discmc/crc32.hpp>
#include <discmc/encoder.hpp>
#include <discmc/record_encoding.hpp>

namespace discmc {

namespace {

// What the end of a packet, and the end of a part in it, may take. Units: bytes.
constexpr size_t end_reserve = 4;
constexpr size_t part_end_reserve = end_reserve + 4;

}  // namespace

Status Encoder::start(const StreamHeader& header, const ByteOutput& output) {
  if (!Limits{header.width, header.height, header.border}.are_valid()) return Status::bad_limits;
  if (output.write == nullptr) return Status::bad_sink;
  header_ = header;
  output_ = output;
  bytes_ = 0;
  regions_ = 0;
  packets_ = 0;
  trailer_is_sealed_ = false;
  is_emptying_ = false;
  seal_header();
  return Status::ok;
}

Answer Encoder::take(const Event& event) {
  if (output_.write == nullptr || !drain()) return Answer::not_now;
  bool done = true;
  switch (event.kind) {
    case Event::Kind::region:
    case Event::Kind::fragment:
      record_.begin(event.incidence);
      record_.is_fragment = event.kind == Event::Kind::fragment;
      record_.number = event.number;
      break;
    case Event::Kind::ring:
      done = has_room(Record::ring_words) || put_parts(false);
      if (done) record_.add_ring(event.start);
      break;
    case Event::Kind::run:
      done = has_room(1) || put_parts(false);
      if (done) record_.add_run(event.run);
      break;
    case Event::Kind::region_end:
    case Event::Kind::fragment_end:
      done = is_compact(record_) ? put_whole(event) : put_parts(true);
      break;
    case Event::Kind::layer:
    case Event::Kind::skipped:
      done = put_whole(event);
      break;
    case Event::Kind::finish:
      done = put_trailer(event);
      break;
    case Event::Kind::lost:
      is_emptying_ = false;
      record_.begin(no_incidence);
      break;
  }
  return done ? Answer::taken : Answer::not_now;
}

bool Encoder::flush() {
  if (!drain()) return false;
  if (!packet_is_empty_) seal_records();
  return drain();
}

// ---- records ----

// Puts a mark, or the record when it is compact, into this packet or else into the next.
bool Encoder::put_whole(const Event& event) {
  for (;;) {
    const Model before = model_;
    encode_whole(event);
    if (fits(end_reserve)) break;
    model_ = before;
    if (packet_is_empty_) return put_parts(true);  // no mark is as long as a packet
    seal_records();
    if (!drain()) return false;
  }
  packet_is_empty_ = false;
  if (event.kind == Event::Kind::region_end) ++regions_;
  return true;
}

void Encoder::encode_whole(const Event& event) {
  if (event.kind == Event::Kind::region_end) return encode_region(model_, record_);
  model_.region_follows(false);
  if (event.kind == Event::Kind::layer) {
    model_.other_kind(OtherKind::layer);
    model_.layer(event.slice);
  } else {
    model_.other_kind(OtherKind::skipped);
    model_.plain_number(event.slice);
    model_.plain_number(event.row);
    model_.plain_bits(1, event.repeated ? 1 : 0);
  }
}

// Empties the record into one part, or into as many as there must be packets for them.
bool Encoder::put_parts(bool is_last) {
  is_emptying_ = true;
  for (;;) {
    const Model before = model_;
    const uint32_t words = encode_part(is_last);
    const bool is_whole = words == record_.count && fits(end_reserve);
    if (!is_whole && !packet_is_empty_) {
      model_ = before;
    } else {
      for (uint32_t i = words; i < record_.count; ++i) record_.word[i - words] = record_.word[i];
      record_.count -= words;
      record_.continues = true;
      packet_is_empty_ = false;
    }
    if (is_whole) break;
    seal_records();
    if (!drain()) return false;
  }
  is_emptying_ = false;
  if (is_last && !record_.is_fragment) ++regions_;
  return true;
}

// Encodes a part with as many items as the packet takes. Returns their words.
uint32_t Encoder::encode_part(bool is_last) {
  model_.region_follows(false);
  model_.other_kind(OtherKind::part);
  model_.part(record_);
  uint32_t words = 0;
  while (words < record_.count) {
    const Model before = model_;
    const uint32_t taken = encode_item(model_, record_, words);
    if (!fits(part_end_reserve)) {
      model_ = before;
      break;
    }
    words += taken;
  }
  model_.item_kind(Item::end);
  model_.end_part(is_last && words == record_.count);
  return words;
}

bool Encoder::put_trailer(const Event& event) {
  if (!trailer_is_sealed_) {
    if (!packet_is_empty_) {
      seal_records();
      if (!drain()) return false;
    }
    wire::ByteWriter writer(payload());
    writer.put(event.slice, 4);
    writer.put(event.abandoned ? 1 : 0, 1);
    for (const auto total : wire::trailer_totals) writer.put_long(event.statistics->*total);
    seal(wire::PacketKind::trailer, wire::trailer_payload);
    trailer_is_sealed_ = true;
  }
  return drain();
}

// ---- packets ----

bool Encoder::fits(size_t reserve) const {
  return model_.coder().range.size() + reserve <= wire::max_payload;
}

void Encoder::open_packet() {
  model_ = Model(Coder{RangeEncoder(payload(), wire::max_payload)});
  packet_is_empty_ = true;
  frame_bytes_ = 0;
  regions_before_ = regions_;
}

void Encoder::seal_records() {
  model_.region_follows(false);
  model_.other_kind(OtherKind::end);
  ++packets_since_header_;
  seal(wire::PacketKind::records, model_.coder().range.finish());
}

void Encoder::seal_header() {
  wire::ByteWriter writer(payload());
  for (const uint8_t letter : wire::magic) writer.put(letter, 1);
  writer.put(wire::version, 1);
  writer.put(header_.width, 2);
  writer.put(header_.height, 2);
  writer.put(header_.depth, 4);
  for (const int32_t spacing : header_.spacing_nm) writer.put(static_cast<uint32_t>(spacing), 4);
  writer.put(static_cast<uint32_t>(header_.threshold), 4);
  writer.put(header_.border == Border::open ? 1 : 0, 1);
  writer.put(packets_, 4);
  writer.put_long(regions_);
  packets_since_header_ = 0;
  regions_before_ = regions_;
  seal(wire::PacketKind::header, wire::header_payload);
}

void Encoder::seal(wire::PacketKind kind, size_t payload_bytes) {
  uint8_t* const packet = frame_ + 1;
  wire::ByteWriter head(packet);
  head.put(static_cast<uint8_t>(kind), 1);
  head.put(packets_, 1);
  head.put(static_cast<uint32_t>(regions_before_), 2);
  const size_t checked = wire::packet_head + payload_bytes;
  wire::ByteWriter(packet + checked).put(crc32(packet, checked), wire::packet_crc);
  frame_bytes_ = cobs::stuff(frame_, checked + wire::packet_crc);
  drained_ = 0;
  ++packets_;
}

// Hands the sealed frame over. When all of it is gone the next packet is open.
bool Encoder::drain() {
  while (frame_bytes_ > 0) {
    const size_t taken = output_.write(output_.context, frame_ + drained_, frame_bytes_ - drained_);
    drained_ += taken;
    bytes_ += taken;
    if (drained_ < frame_bytes_) {
      if (taken == 0) return false;
      continue;
    }
    if (packets_since_header_ == wire::header_interval)
      seal_header();
    else
      open_packet();
  }
  return true;
}

}  // namespace discmc
