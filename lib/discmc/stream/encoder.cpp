#include <discmc/encoder.hpp>
#include <discmc/stream/normal_encoding.hpp>
#include <discmc/stream/record_writing.hpp>

namespace discmc {

namespace {

constexpr bool is_end(Event::Kind kind) {
  return kind == Event::Kind::region_end || kind == Event::Kind::fragment_end;
}

}  // namespace

// Only this function refers to the code for normals: if it is not called, the linker drops both.
void Encoder::encode_normals() {
  write_normals_ = [](Encoder& encoder, Model& model, uint32_t words) {
    detail::stream::encode_normals(model, encoder.record_, encoder.normals_, words);
  };
}

Status Encoder::start(const StreamLabel& label, const ByteOutput& output) {
  if (label.channel > StreamLabel::max_channel) return Status::bad_label;
  if (!output.is_valid()) return Status::bad_sink;
  packets_.attach(output);
  state_ = State::idle;
  StreamHeader& header = packets_.header();
  header.depth = label.depth;
  for (int axis = 0; axis < 3; ++axis) header.spacing_nm[axis] = label.spacing_nm[axis];
  header.scan = label.scan;
  header.channel = label.channel;
  return Status::ok;
}

// The header combines the label with the extractor's own data. Members that only streams of slices
// have are ignored.
DISCMC_ALWAYS_INLINE SinkResult Encoder::begin_stream(const StreamHeader& scan) {
  const Limits limits{scan.width, scan.height, scan.border};
  if (!packets_.has_output() || !limits.is_valid()) return SinkResult::not_started;
  StreamHeader& header = packets_.header();
  if (state_ != State::idle) {
    if (!drain()) return SinkResult::busy;
    ++header.scan;
  }
  header.width = scan.width;
  header.height = scan.height;
  header.thresholds[0] = scan.thresholds[0];
  header.border = scan.border;
  header.surface_count = 1;
  if (scan.has_spacing())
    for (int axis = 0; axis < 3; ++axis) header.spacing_nm[axis] = scan.spacing_nm[axis];
  packets_.begin_stream(0);
  state_ = State::between;
  (void)drain();  // if the output is busy, a later call sends it
  return SinkResult::accepted;
}

// Most events are runs.
SinkResult Encoder::accept(const Event& event) {
  if (event.kind == Event::Kind::run && state_ == State::in_piece && record_.has_room(1)) {
    add_run(event);
    return SinkResult::accepted;
  }
  return accept_other(event);
}

DISCMC_NOINLINE SinkResult Encoder::accept_other(const Event& event) {
  if (event.kind == Event::Kind::start) return begin_stream(*event.header);
  if (state_ == State::idle) return SinkResult::not_started;
  if (!drain()) return SinkResult::busy;
  bool is_done = true;
  if (event.kind == Event::Kind::run || event.kind == Event::Kind::ring) {
    const uint32_t words = event.kind == Event::Kind::run ? 1 : Record::ring_words + 1;
    is_done = has_room_for(words) || put_parts(event);
    if (!is_done) return SinkResult::busy;
    if (event.kind == Event::Kind::run)
      add_run(event);
    else
      record_.add_ring(event.start);
  } else if (event.kind == Event::Kind::region || event.kind == Event::Kind::fragment) {
    state_ = State::in_piece;
    record_.begin(event.incidence);
    if (event.kind == Event::Kind::fragment)
      record_.begin_fragment(event.incoming_direction, event.start);
  } else if (event.kind == Event::Kind::application) {
    is_done = put_application(*event.application) != Status::suspended;
  } else if (event.kind == Event::Kind::finish) {
    if (state_ != State::ended) {
      if (flush() != Status::ok) return SinkResult::busy;
      packets_.seal_trailer(event);
      state_ = State::ended;
    }
    is_done = drain();
  } else if (is_end(event.kind) || event.kind == Event::Kind::layer ||
             event.kind == Event::Kind::skipped) {
    is_done = put(event);
  } else if (event.kind == Event::Kind::lost) {
    state_ = State::between;
  }
  return is_done ? SinkResult::accepted : SinkResult::busy;
}

// Whether a packet without records of the encoder can be sent now.
DISCMC_ALWAYS_INLINE Status Encoder::ready_for_packet(bool is_good) {
  if (state_ == State::idle) return Status::not_started;
  if (state_ == State::ended) return Status::finished;
  if (!is_good) return Status::bad_record;
  return state_ == State::between ? flush() : Status::suspended;
}

DISCMC_ALWAYS_INLINE Status Encoder::put_application(const ApplicationRecord& record) {
  const Status status = ready_for_packet(record.count <= ApplicationRecord::max_bytes);
  if (status != Status::ok) return status;
  packets_.seal_application(detail::wire::PacketKind::application, record);
  (void)drain();  // the packet is accepted even if the output is busy
  return Status::ok;
}

Status Encoder::write_record(const ApplicationRecord& record) {
  return put_application(record);
}

Status Encoder::append(const RecordsPacket& packet) {
  const size_t max_bytes =
      packet.is_whole ? detail::wire::max_whole_regions : detail::wire::max_payload;
  const Status status = ready_for_packet(packet.bytes <= max_bytes && packet.pieces <= 0xFFFF);
  if (status != Status::ok) return status;
  packets_.seal_appended(packet);
  (void)drain();  // the packet is accepted even if the output is busy
  return Status::ok;
}

void Encoder::set_output(const ByteOutput& output) {
  packets_.set_output(output);
  if (output.write != nullptr) packets_.repeat_header(is_packet_empty());
}

Status Encoder::flush() {
  if (state_ == State::idle) return Status::ok;
  if (!drain()) return Status::suspended;
  if (!is_packet_empty()) seal_records();
  return drain() ? Status::ok : Status::suspended;
}

// ---- checkpoints ----

Status Encoder::save(Memory* parts) {
  if (state_ == State::idle) return Status::not_started;
  const Status status = packets_.ready_for_checkpoint();
  if (status != Status::ok) return status;
  parts[0] = {this, sizeof *this};
  seal_.close(this, sizeof *this, layout, {});
  return Status::ok;
}

Status Encoder::restore(const ByteOutput& output) {
  if (!output.is_valid()) return Status::bad_sink;
  if (!seal_.is_intact(this, sizeof *this, layout, {})) {
    state_ = State::idle;
    return Status::bad_checkpoint;
  }
  packets_.resume(output);
  model_.coder().range.move_to(packets_.payload());
  write_normals_ = nullptr;  // the code may be at another address now
  return Status::ok;
}

// ---- records ----

// Sends the record in parts to make room for the event. Returns false if the output is busy.
inline bool Encoder::put_parts(const Event& event) {
  state_ = State::in_parts;
  if (!put(event)) return false;
  state_ = State::in_piece;
  return true;
}

// Writes a mark, or the record, into this packet and into more packets if needed. Returns false
// if the output is busy.
bool Encoder::put(const Event& event) {
  while (!fill_packet(event)) {
    seal_records();
    if (!drain()) return false;
  }
  if (is_end(event.kind)) {
    state_ = State::between;
    packets_.count_piece();
  }
  return true;
}

// Writes a mark, or the record, into the packet. A record that cannot be encoded whole, or is
// longer than a packet, is sent in parts. Returns false if something is left for the next packet.
// Inlined, because the two functions need less stack together.
DISCMC_ALWAYS_INLINE bool Encoder::fill_packet(const Event& event) {
  uint32_t words = record_.count;
  for (;;) {
    Model model = model_;
    const bool is_part = state_ == State::in_parts;
    if (is_part) words = record_.words_of_part(words);
    if (write_normals_ != nullptr) write_normals_(*this, model, words);
    bool is_encoded = true;
    if (is_part) {
      record_.is_last = is_end(event.kind) && words == record_.count;
      detail::stream::encode_part(model, record_, words);
    } else {
      is_encoded = encode_whole(model, event);
    }
    if (is_encoded && fits(model)) {
      model_ = model;
      break;
    }
    // A record that does not fit into the rest of this packet goes into the next one.
    if (is_encoded && !is_packet_empty()) return false;
    // A distant start with all normals may not fit into one packet.
    if (is_part) words -= words / 4;
    state_ = State::in_parts;
  }
  // The rest of the record continues after these words.
  record_.count -= words;
  for (uint32_t i = 0; i < record_.count; ++i) {
    record_.word[i] = record_.word[i + words];
    normals_[i] = normals_[i + words];
  }
  record_.continues = true;
  return record_.count == 0;
}

DISCMC_ALWAYS_INLINE bool Encoder::encode_whole(Model& model, const Event& event) {
  switch (event.kind) {
    case Event::Kind::layer:
      model.record_kind(detail::stream::RecordKind::layer);
      model.layer(event.slice);
      return true;
    case Event::Kind::skipped:
      model.record_kind(detail::stream::RecordKind::skipped);
      model.plain_number(event.slice);
      model.plain_number(event.row);
      model.raw_bits(1, event.is_repeated ? 1 : 0);
      return true;
    default:
      if constexpr (is_host)
        return detail::stream::encode_record_in_place(model, record_);
      else
        return detail::stream::encode_record(model, record_);
  }
}

// ---- packets ----

// Whether the end of the packet fits, too: the byte of its symbol, and the byte that closes the
// code.
DISCMC_ALWAYS_INLINE bool Encoder::fits(const Model& model) const {
  return model.coder().range.size() + 2 <= packets_.max_payload();
}

DISCMC_ALWAYS_INLINE void Encoder::open_packet() {
  model_ = Model({RangeEncoder(packets_.payload(), detail::wire::max_payload)});
}

void Encoder::seal_records() {
  model_.record_kind(detail::stream::RecordKind::end);
  packets_.seal(detail::wire::PacketKind::records,
                packets_.payload() + model_.coder().range.finish());
}

// Sends the sealed frame. When all of it is sent, the next packet is open.
bool Encoder::drain() {
  if (packets_.is_open()) return true;
  if (!packets_.drain()) return false;
  open_packet();
  return true;
}

}  // namespace discmc
