// What the functions of encoder.hpp do: included where BasicEncoder is instantiated.
#ifndef DISCMC_STREAM_ENCODER_DEFINITIONS_HPP
#define DISCMC_STREAM_ENCODER_DEFINITIONS_HPP

#include <discmc/encoder.hpp>
#include <discmc/stream/crc32.hpp>
#include <discmc/stream/record_encoding.hpp>

namespace discmc {

namespace packet_end {

// What the end of a packet, and the end of a part in it, may take. Units: bytes.
constexpr size_t reserve = 4;
constexpr size_t part_reserve = reserve + 4;

}  // namespace packet_end

constexpr bool is_end(Event::Kind kind) {
  return kind == Event::Kind::region_end || kind == Event::Kind::fragment_end;
}

template <class Normals>
Status BasicEncoder<Normals>::start(const StreamHeader& header, const ByteOutput& output) {
  if (!Limits{header.width, header.height, header.border}.is_valid()) return Status::bad_limits;
  if (output.write == nullptr) return Status::bad_sink;
  header_ = header;
  output_ = output;
  bytes_ = 0;
  pieces_ = 0;
  packets_ = 0;
  pieces_before_ = 0;
  trailer_is_sealed_ = false;
  is_emptying_ = false;
  seal_header();
  return Status::ok;
}

template <class Normals>
Answer BasicEncoder<Normals>::take_any(const Event& event) {
  if (output_.write == nullptr || !drain()) return Answer::not_now;
  const bool is_run = event.kind == Event::Kind::run;
  bool done = true;
  switch (event.kind) {
    case Event::Kind::region:
    case Event::Kind::fragment:
      record_.begin(event.incidence);
      if (event.kind == Event::Kind::fragment) record_.begin_fragment(event.came, event.start);
      break;
    case Event::Kind::ring:
    case Event::Kind::run:
      // A record that has no room is emptied in parts before the event goes into it.
      if (!record_.has_room(is_run ? 1 : Record::ring_words)) is_emptying_ = true;
      if (is_emptying_) done = put(event);
      if (!done) break;
      if (is_run)
        add_run(event);
      else
        record_.add_ring(event.start);
      break;
    case Event::Kind::region_end:
    case Event::Kind::fragment_end:
    case Event::Kind::layer:
    case Event::Kind::skipped:
      done = put(event);
      break;
    case Event::Kind::finish:
      done = put_trailer(event);
      break;
    case Event::Kind::lost:
      break;
  }
  return done ? Answer::taken : Answer::not_now;
}

template <class Normals>
bool BasicEncoder<Normals>::flush() {
  if (output_.write == nullptr) return true;
  if (!drain()) return false;
  if (!packet_is_empty_) seal_records();
  return drain();
}

// ---- checkpoints ----

template <class Normals>
Status BasicEncoder<Normals>::save(Checkpoint<BasicEncoder>& checkpoint) const {
  if (output_.write == nullptr) return Status::not_started;
  BasicEncoder& image = checkpoint.object;
  image = *this;
  image.output_ = {};
  image.model_.coder().range.move_to(nullptr);
  if (frame_bytes_ > 0) image.bytes_ -= drained_;
  image.drained_ = 0;
  checkpoint.seal({});
  return Status::ok;
}

template <class Normals>
Status BasicEncoder<Normals>::restore(const Checkpoint<BasicEncoder>& checkpoint,
                                      const ByteOutput& output) {
  if (!checkpoint.is_whole({})) return Status::bad_checkpoint;
  if (output.write == nullptr) return Status::bad_sink;
  *this = checkpoint.object;
  output_ = output;
  model_.coder().range.move_to(payload());
  return Status::ok;
}

// ---- records ----

template <class Normals>
void BasicEncoder<Normals>::Coder::tell(uint32_t context, bool bit) {
  range.encode(bit, region_model[context]);
}

template <class Normals>
void BasicEncoder<Normals>::drop(uint32_t words) {
  record_.drop(words);
  if constexpr (Normals::are_told) Normals::drop(words, record_.count);
}

template <class Normals>
void BasicEncoder<Normals>::encode_normals(uint32_t words) {
  if constexpr (Normals::are_told) Normals::encode(model_, record_, words);
}

// Puts a mark, or what is in the record, into this packet or the next. What cannot be told whole,
// or is longer than a packet, goes in parts, into as many packets as it takes; no mark does.
template <class Normals>
bool BasicEncoder<Normals>::put(const Event& event) {
  for (uint32_t words = record_.count;;) {
    const Model before = model_;
    const bool is_told = is_emptying_ ? encode_part(words, event.kind) : encode_whole(event);
    if (is_told && fits(packet_end::reserve)) {
      packet_is_empty_ = false;
      drop(words);
      if (record_.count == 0) break;
    } else {
      model_ = before;
      if (packet_is_empty_ || !(is_told || is_emptying_)) {
        is_emptying_ = true;
        continue;
      }
    }
    seal_records();
    if (!drain()) return false;
    words = record_.count;
  }
  is_emptying_ = false;
  if (is_end(event.kind)) ++pieces_;
  return true;
}

template <class Normals>
bool BasicEncoder<Normals>::encode_whole(const Event& event) {
  switch (event.kind) {
    case Event::Kind::layer:
      model_.record_kind(RecordKind::layer);
      model_.layer(event.slice);
      return true;
    case Event::Kind::skipped:
      model_.record_kind(RecordKind::skipped);
      model_.plain_number(event.slice);
      model_.plain_number(event.row);
      model_.plain_bit(event.repeated);
      return true;
    default:
      encode_normals(record_.count);
      if constexpr (is_host)
        return encode_record_in_place(model_, record_);
      else
        return encode_record(model_, record_);
  }
}

// Encodes the first words of the record as a part. False when fewer fit: `words` says how many.
template <class Normals>
bool BasicEncoder<Normals>::encode_part(uint32_t& words, Event::Kind cause) {
  encode_normals(words);
  model_.record_kind(RecordKind::part);
  model_.part(record_);
  for (uint32_t i = 0; i < words;) {
    const uint32_t end = i + encode_item(model_, record_, i);
    if (!fits(packet_end::part_reserve)) {
      words = i > 0 ? i : end;  // a far start and all normals may be too much: then the start alone
      return false;
    }
    i = end;
  }
  model_.item_kind(Item::end);
  model_.end_part(is_end(cause) && words == record_.count);
  return true;
}

template <class Normals>
bool BasicEncoder<Normals>::put_trailer(const Event& event) {
  if (!trailer_is_sealed_) {
    if (!flush()) return false;
    uint8_t* place = wire::put(payload(), event.slice, 4);
    place = wire::put(place, event.abandoned ? 1 : 0, 1);
    for (const auto total : wire::trailer_totals)
      place = wire::put_long(place, event.statistics->*total);
    seal(wire::PacketKind::trailer, place);
    trailer_is_sealed_ = true;
  }
  return drain();
}

// ---- packets ----

template <class Normals>
bool BasicEncoder<Normals>::fits(size_t reserve) const {
  return model_.coder().range.size() + reserve <= wire::max_payload;
}

template <class Normals>
void BasicEncoder<Normals>::open_packet() {
  model_ = Model(Coder{RangeEncoder(payload(), wire::max_payload)});
  packet_is_empty_ = true;
  frame_bytes_ = 0;
}

template <class Normals>
void BasicEncoder<Normals>::seal_records() {
  model_.record_kind(RecordKind::end);
  ++packets_since_header_;
  seal(wire::PacketKind::records, payload() + model_.coder().range.finish());
}

template <class Normals>
void BasicEncoder<Normals>::seal_header() {
  uint8_t* place = wire::put(payload(), wire::magic | uint32_t{wire::version} << 24, 4);
  place = wire::put(place, header_.width, 2);
  place = wire::put(place, header_.height, 2);
  place = wire::put(place, header_.depth, 4);
  for (const int32_t spacing : header_.spacing_nm)
    place = wire::put(place, static_cast<uint32_t>(spacing), 4);
  place = wire::put(place, static_cast<uint32_t>(header_.threshold), 4);
  place = wire::put(place, header_.border == Border::open ? 1 : 0, 1);
  place = wire::put(place, packets_, 4);
  place = wire::put_long(place, pieces_);
  packets_since_header_ = 0;
  seal(wire::PacketKind::header, place);
}

// Makes a frame of the payload that ends at `end`.
template <class Normals>
void BasicEncoder<Normals>::seal(wire::PacketKind kind, uint8_t* end) {
  uint8_t* const packet = frame_ + 1;
  wire::put(packet,
            uint32_t{static_cast<uint8_t>(kind)} | (packets_ & 0xFF) << 8 | pieces_before_ << 16,
            wire::packet_head);
  wire::put(end, crc32(packet, static_cast<size_t>(end - packet)), wire::packet_crc);
  frame_bytes_ = static_cast<uint16_t>(
      cobs::stuff(frame_, static_cast<size_t>(end - packet) + wire::packet_crc));
  drained_ = 0;
  ++packets_;
  pieces_before_ = static_cast<uint32_t>(pieces_);
}

// Hands the sealed frame over. When all of it is gone the next packet is open.
template <class Normals>
bool BasicEncoder<Normals>::drain() {
  while (frame_bytes_ > 0) {
    const size_t left = static_cast<size_t>(frame_bytes_ - drained_);
    const size_t taken = output_.write(output_.context, frame_ + drained_, left);
    bytes_ += taken;
    if (taken == 0) return false;
    drained_ = static_cast<uint16_t>(drained_ + taken);
    if (taken < left) continue;
    if (packets_since_header_ == wire::header_interval)
      seal_header();
    else
      open_packet();
  }
  return true;
}

}  // namespace discmc

#endif
