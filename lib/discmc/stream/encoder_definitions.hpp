// What the functions of encoder.hpp do: included where BasicEncoder is instantiated.
#ifndef DISCMC_STREAM_ENCODER_DEFINITIONS_HPP
#define DISCMC_STREAM_ENCODER_DEFINITIONS_HPP

#include <discmc/encoder.hpp>
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

template <class Normals, size_t max_payload>
Status BasicEncoder<Normals, max_payload>::start(const StreamLabel& label,
                                                 const ByteOutput& output) {
  if (label.channel > StreamLabel::max_channel) return Status::bad_label;
  if (output.write == nullptr) return Status::bad_sink;
  packets_.open(output);
  StreamHeader& header = packets_.header();
  header.depth = label.depth;
  for (int axis = 0; axis < 3; ++axis) header.spacing_nm[axis] = label.spacing_nm[axis];
  header.scan = label.scan;
  header.channel = label.channel;
  return Status::ok;
}

// The header is what the label says and what the extractor knows.
template <class Normals, size_t max_payload>
Answer BasicEncoder<Normals, max_payload>::begin_stream(const StreamHeader& scan) {
  if (!packets_.has_output() || !scan.is_valid()) return Answer::never;
  StreamHeader header = packets_.header();
  if (packets_.is_started()) {
    if (!drain()) return Answer::not_now;
    ++header.scan;
  }
  header.width = scan.width;
  header.height = scan.height;
  header.threshold = scan.threshold;
  header.border = scan.border;
  if (scan.has_spacing())
    for (int axis = 0; axis < 3; ++axis) header.spacing_nm[axis] = scan.spacing_nm[axis];
  packets_.start(header, 0);
  is_emptying_ = false;
  piece_is_open_ = false;
  (void)drain();  // whoever listens knows at once; or later
  return Answer::taken;
}

template <class Normals, size_t max_payload>
Answer BasicEncoder<Normals, max_payload>::take_any(const Event& event) {
  if (event.kind == Event::Kind::start) return begin_stream(*event.header);
  if (!packets_.is_started()) return Answer::never;
  if (!drain()) return Answer::not_now;
  const bool is_run = event.kind == Event::Kind::run;
  bool done = true;
  switch (event.kind) {
    case Event::Kind::region:
    case Event::Kind::fragment:
      piece_is_open_ = true;
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
    case Event::Kind::application:
      done = tell(*event.application) != Status::more;
      break;
    case Event::Kind::finish:
      done = put_trailer(event);
      break;
    case Event::Kind::start:
    case Event::Kind::lost:
      piece_is_open_ = false;
      break;
  }
  return done ? Answer::taken : Answer::not_now;
}

template <class Normals, size_t max_payload>
Status BasicEncoder<Normals, max_payload>::tell(const ApplicationRecord& record) {
  if (!packets_.is_started()) return Status::not_started;
  if (packets_.is_ended()) return Status::finished;
  if (record.count > ApplicationRecord::max_bytes) return Status::bad_record;
  if (piece_is_open_ || !flush()) return Status::more;
  packets_.seal_application(wire::PacketKind::application, record);
  (void)drain();  // it is taken, whenever the output takes it
  return Status::ok;
}

template <class Normals, size_t max_payload>
Status BasicEncoder<Normals, max_payload>::append(const RecordsPacket& packet) {
  if (!packets_.is_started()) return Status::not_started;
  if (packets_.is_ended()) return Status::finished;
  if (packet.bytes > wire::max_appended || packet.pieces > 0xFFFF) return Status::bad_record;
  if (piece_is_open_ || !flush()) return Status::more;
  packets_.seal_appended(packet);
  (void)drain();  // it is taken, whenever the output takes it
  return Status::ok;
}

template <class Normals, size_t max_payload>
void BasicEncoder<Normals, max_payload>::set_output(const ByteOutput& output) {
  packets_.set_output(output);
  if (output.write != nullptr) packets_.repeat_header(packet_is_empty_);
}

template <class Normals, size_t max_payload>
bool BasicEncoder<Normals, max_payload>::flush() {
  if (!packets_.is_started()) return true;
  if (!drain()) return false;
  if (!packet_is_empty_) seal_records();
  return drain();
}

// ---- checkpoints ----

template <class Normals, size_t max_payload>
Status BasicEncoder<Normals, max_payload>::save(Checkpoint<BasicEncoder>& checkpoint) const {
  if (!packets_.is_started()) return Status::not_started;
  BasicEncoder& image = checkpoint.object;
  image = *this;
  image.model_.coder().range.move_to(nullptr);
  image.packets_.rewind();
  checkpoint.seal({});
  return Status::ok;
}

template <class Normals, size_t max_payload>
Status BasicEncoder<Normals, max_payload>::restore(const Checkpoint<BasicEncoder>& checkpoint,
                                                   const ByteOutput& output) {
  if (!checkpoint.is_whole({})) return Status::bad_checkpoint;
  if (output.write == nullptr) return Status::bad_sink;
  *this = checkpoint.object;
  return continue_to(output);
}

template <class Normals, size_t max_payload>
Status BasicEncoder<Normals, max_payload>::continue_to(const ByteOutput& output) {
  if (output.write == nullptr) return Status::bad_sink;
  packets_.rewind();
  packets_.set_output(output);
  model_.coder().range.move_to(packets_.payload());
  return Status::ok;
}

// ---- records ----

template <class Normals, size_t max_payload>
void BasicEncoder<Normals, max_payload>::Coder::tell(uint32_t context, bool bit) {
  range.encode(bit, region_model[context]);
}

template <class Normals, size_t max_payload>
void BasicEncoder<Normals, max_payload>::drop(uint32_t words) {
  record_.drop(words);
  if constexpr (Normals::are_told) Normals::drop(words, record_.count);
}

template <class Normals, size_t max_payload>
void BasicEncoder<Normals, max_payload>::encode_normals(uint32_t words) {
  if constexpr (Normals::are_told) Normals::encode(model_, record_, words);
}

// Puts a mark, or what is in the record, into this packet or the next. What cannot be told whole,
// or is longer than a packet, goes in parts, into as many packets as it takes; no mark does.
template <class Normals, size_t max_payload>
bool BasicEncoder<Normals, max_payload>::put(const Event& event) {
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
  if (is_end(event.kind)) {
    piece_is_open_ = false;
    packets_.count_piece();
  }
  return true;
}

template <class Normals, size_t max_payload>
bool BasicEncoder<Normals, max_payload>::encode_whole(const Event& event) {
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
template <class Normals, size_t max_payload>
bool BasicEncoder<Normals, max_payload>::encode_part(uint32_t& words, Event::Kind cause) {
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

template <class Normals, size_t max_payload>
bool BasicEncoder<Normals, max_payload>::put_trailer(const Event& event) {
  if (!packets_.is_ended()) {
    if (!flush()) return false;
    packets_.seal_trailer(event);
  }
  return drain();
}

// ---- packets ----

template <class Normals, size_t max_payload>
bool BasicEncoder<Normals, max_payload>::fits(size_t reserve) const {
  return model_.coder().range.size() + reserve <= max_payload;
}

template <class Normals, size_t max_payload>
void BasicEncoder<Normals, max_payload>::open_packet() {
  model_ = Model(Coder{RangeEncoder(packets_.payload(), max_payload)});
  packet_is_empty_ = true;
}

template <class Normals, size_t max_payload>
void BasicEncoder<Normals, max_payload>::seal_records() {
  model_.record_kind(RecordKind::end);
  packets_.seal(wire::PacketKind::records, packets_.payload() + model_.coder().range.finish());
}

// Hands the sealed frame over. When all of it is gone the next packet is open.
template <class Normals, size_t max_payload>
bool BasicEncoder<Normals, max_payload>::drain() {
  if (packets_.is_open()) return true;
  if (!packets_.drain()) return false;
  open_packet();
  return true;
}

}  // namespace discmc

#endif
