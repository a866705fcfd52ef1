#include <discmc/slice_encoder.hpp>

namespace discmc {

using detail::slices::RowNote;

static StreamHeader header_of(const SliceEncoderConfig& config) {
  StreamHeader header;
  header.width = config.limits.width;
  header.height = config.limits.height;
  header.depth = config.label.depth;
  for (int axis = 0; axis < 3; ++axis) header.spacing_nm[axis] = config.label.spacing_nm[axis];
  for (int surface = 0; surface < StreamHeader::max_surfaces; ++surface)
    header.thresholds[surface] = config.thresholds[surface];
  header.border = config.limits.border;
  header.channel = config.label.channel;
  header.scan = config.label.scan;
  header.surface_count = config.surface_count;
  return header;
}

Status SliceEncoder::start(const SliceEncoderConfig& config, Memory memory,
                           const ByteOutput& output) {
  const StreamHeader header = header_of(config);
  const Slab& slab = config.limits.slab;
  if (!config.limits.is_valid() || slab.first > 0 || slab.continues_above)
    return Status::bad_limits;
  if (!header.is_valid()) return Status::bad_label;
  if (!output.is_valid()) return Status::bad_sink;
  state_ = State::idle;
  packets_.attach(output);
  packets_.header() = header;
  packets_.begin_stream(detail::wire::HeaderFlags::slices | fraction_flags_);
  key_slice_interval_ = config.key_slice_interval;
  if (!lay_out(memory)) return Status::too_little_memory;
  surfaces_.clear();
  state_ = State::scanning;
  is_row_due_ = false;
  is_row_begun_ = false;
  surface_ = 0;
  is_code_open_ = false;
  is_key_due_ = false;
  is_abandoned_ = false;
  encoded_rows_ = 0;
  skipped_rows_ = 0;
  return Status::ok;
}

// Returns false if the arrays do not fit.
bool SliceEncoder::lay_out(Memory memory) {
  Arena arena(memory);
  const StreamHeader& header = packets_.header();
  surfaces_.start(arena, header, detail::slices::rows_kept(header.height, !keeps_slice()));
  memory_ = memory.data;
  bytes_used_ = memory.bytes - arena.left();
  if (arena.is_exhausted()) unpoison(memory.data, memory.bytes);
  return !arena.is_exhausted();
}

// ---- input ----

Status SliceEncoder::ready_for_row() {
  if (state_ == State::idle) return Status::not_started;
  if (state_ != State::scanning) return Status::finished;
  (void)work();
  if (is_row_due_) return Status::suspended;  // the waiting row occupies the next row's place
  if (slices() >= Limits::max_slices) return Status::too_many_slices;
  return Status::ok;
}

template <class Sample>
PushResult SliceEncoder::push_samples(const Sample* samples, uint32_t count, uint32_t stride) {
  return push_parts(samples, count, stride,
                    [this, stride](const Sample* part, uint32_t part_count) {
                      append(part, part_count, stride);
                    });
}

template PushResult SliceEncoder::push_samples(const uint8_t*, uint32_t, uint32_t);
template PushResult SliceEncoder::push_samples(const uint16_t*, uint32_t, uint32_t);
template PushResult SliceEncoder::push_samples(const int16_t*, uint32_t, uint32_t);

PushResult SliceEncoder::push_bits(const uint8_t* bits) {
  const Status status = ready_for_row();
  if (status != Status::ok) return {status, 0};
  if (column() != 0) return {Status::row_in_progress, 0};
  for (detail::slices::CodedSurface& surface : surfaces_) {
    surface.rows.append_bits(bits);
    bits += (packets_.header().width + 7) / 8;
  }
  return process_row(RowNote::none);
}

PushResult SliceEncoder::skip_row(Substitute substitute) {
  const Status status = ready_for_row();
  if (status != Status::ok) return {status, 0};
  if (column() != 0) return {Status::row_in_progress, 0};
  const bool is_repeated = substitute == Substitute::previous_row;
  for (detail::slices::CodedSurface& surface : surfaces_) {
    if (is_repeated)
      surface.rows.repeat();
    else
      surface.rows.fill_off();
  }
  ++skipped_rows_;
  return process_row(is_repeated ? RowNote::repeated : RowNote::off);
}

PushResult SliceEncoder::process_row(RowNote note) {
  note_ = note;
  is_row_due_ = true;
  return {resume(), packets_.header().width};
}

Status SliceEncoder::resume() {
  if (state_ == State::idle) return Status::not_started;
  return work() ? Status::ok : Status::suspended;
}

Status SliceEncoder::flush() {
  if (state_ == State::idle) return Status::not_started;
  if (!work()) return Status::suspended;
  if (is_code_open_ && !end_code()) return Status::suspended;
  return Status::ok;
}

Status SliceEncoder::write_record(const ApplicationRecord& record) {
  if (state_ == State::finishing || state_ == State::finished) return Status::finished;
  if (record.count > ApplicationRecord::max_bytes) return Status::bad_record;
  const Status status = flush();
  if (status != Status::ok) return status;
  ApplicationRecord placed = record;
  placed.slice = slices();
  placed.row = rows();
  packets_.seal_application(detail::wire::PacketKind::slices_application, placed);
  (void)packets_.drain();  // the packet is accepted even if the output is busy
  return Status::ok;
}

// A receiver on the new output can read from there on.
void SliceEncoder::set_output(const ByteOutput& output) {
  packets_.set_output(output);
  if (output.write != nullptr) packets_.repeat_header(!is_code_open_);
  is_key_due_ = true;
}

Status SliceEncoder::finish() {
  if (state_ == State::scanning) {
    const bool is_last_due = is_row_due_ && rows() + 1 == packets_.header().height;
    const bool is_between = rows() == 0 && column() == 0;
    if (!is_last_due && !is_between) return Status::slice_in_progress;
    state_ = State::finishing;
  }
  return resume();
}

Status SliceEncoder::abandon() {
  if (state_ == State::scanning) {
    is_abandoned_ = true;
    state_ = State::finishing;
  }
  return resume();
}

// ---- checkpoints ----

Status SliceEncoder::save(Memory* parts) {
  if (state_ == State::idle) return Status::not_started;
  if (is_suspended()) return Status::suspended;
  const Status status = packets_.ready_for_checkpoint();
  if (status != Status::ok) return status;
  const uint32_t object_bytes = uint32_t{sizeof *this} + fraction_object_bytes_;
  parts[0] = {this, object_bytes};
  parts[1] = {memory_, bytes_used()};
  seal_.close(this, object_bytes, layout | uint32_t{fraction_type_} << 8, parts[1]);
  return Status::ok;
}

Status SliceEncoder::restore_object(uint32_t object_bytes, uint32_t type, Memory memory,
                                    const ByteOutput& output) {
  if (!output.is_valid()) return Status::bad_sink;
  if (memory.data == nullptr) return Status::too_little_memory;
  if (!seal_.is_intact(this, object_bytes, layout | type << 8, memory)) {
    state_ = State::idle;
    return Status::bad_checkpoint;
  }
  lay_out(memory);
  packets_.resume(output);
  coder_.range.move_to(code_end(0));
  return Status::ok;
}

// ---- rows ----

// Does all pending work. Returns false if the output is busy.
bool SliceEncoder::work() {
  if (!packets_.drain()) return false;
  if (is_row_due_ && !encode_row()) return false;
  if (state_ == State::finishing) {
    if (is_code_open_ && !end_code()) return false;
    const uint32_t slices_seen = slices() + (rows() > 0 ? 1 : 0);
    packets_.seal_slices_trailer(slices_seen, is_abandoned_, encoded_rows_, skipped_rows_);
    state_ = State::finished;
  }
  return packets_.drain();
}

bool SliceEncoder::encode_row() {
  for (; surface_ < surfaces_.count(); ++surface_) {
    if (!is_row_begun_ && !begin_row()) return false;
    while (!row_.is_done()) {
      if (!has_room() && !make_room()) return false;
      row_.step(coder_, surfaces_[surface_].model);
    }
    if (code_fractions_ != nullptr && !code_fractions_(*this)) return false;
    is_row_begun_ = false;
  }
  surface_ = 0;
  is_row_due_ = false;
  ++encoded_rows_;
  surfaces_.next_row();
  return true;
}

DISCMC_ALWAYS_INLINE bool SliceEncoder::begin_row() {
  if (surface_ == 0 && !encode_row_start()) return false;
  surfaces_.begin_row(row_, surface_, note_ == RowNote::none ? packets_.header().width : 0);
  is_row_begun_ = true;
  return true;
}

// Writes what precedes the voxels of a row.
DISCMC_ALWAYS_INLINE bool SliceEncoder::encode_row_start() {
  const bool begins_key_slice = is_at_key_slice();
  if (begins_key_slice) {
    if (is_code_open_ && !end_code()) return false;
    surfaces_.begin_key_slice();
    if (note_ == RowNote::repeated) {
      note_ = RowNote::off;  // a key slice must not depend on earlier rows
      surfaces_.clear_row();
    }
  }
  if (!has_room() && !make_room()) return false;
  encode_note(note_);
  if (rows() == 0 && !begins_key_slice) surfaces_.begin_following_slice();
  if (begins_key_slice) is_key_due_ = false;
  return true;
}

// Limit: between two rows.
bool SliceEncoder::is_at_key_slice() const {
  DISCMC_LIMIT(!is_row_begun_);
  return rows() == 0 &&
         (is_key_due_ || detail::slices::is_key_slice(slices(), key_slice_interval_));
}

void SliceEncoder::encode_note(RowNote note) {
  coder_.code_bit(surfaces_.note(), note != RowNote::none);
  if (note != RowNote::none)
    coder_.raw_bits(detail::slices::note_bits, static_cast<uint32_t>(note));
}

// ---- packets ----

using detail::slices::code_reserve;
static_assert(Limits::max_extent < 1 << 15, "a step has a decision and 15 bits at most");
static_assert(detail::wire::key_slice_head + 2 * code_reserve +
                      (detail::wire::max_frame - detail::wire::max_payload) <
                  ByteOutput::min_frame_limit,
              "a code that is not final has room to end");

// Makes room in the packet for a step or a note. Returns false if the output is busy. Limit: there
// is no room.
bool SliceEncoder::make_room() {
  if (is_code_open_) {
    // The code ends if hardly a byte is final, because a carry may change all others.
    if (coder_.range.final_bytes() < code_reserve) {
      if (!cut_code()) return false;
    } else {
      seal(code_end(coder_.range.final_bytes()));
      coder_.range.continue_in(packets_.payload(), packets_.max_payload());
      if (!packets_.drain()) return false;
    }
  }
  if (!is_code_open_) begin_code();
  return true;
}

DISCMC_ALWAYS_INLINE void SliceEncoder::begin_code() {
  const bool is_key = !is_row_begun_ && is_at_key_slice();
  packet_bits_ = detail::wire::SliceBits::first;
  uint8_t* code = packets_.payload();
  if (is_key) {
    packet_bits_ |= detail::wire::SliceBits::key;
    code = detail::wire::put(code, slices(), detail::wire::key_slice_head);
  }
  const auto head = static_cast<size_t>(code - packets_.payload());
  coder_.range = RangeEncoder(code, packets_.max_payload() - head);
  is_code_open_ = true;
}

// Ends the code between two rows.
bool SliceEncoder::end_code() {
  encode_note(RowNote::end);
  return close_code(0);
}

// Ends the code at any position.
DISCMC_ALWAYS_INLINE bool SliceEncoder::cut_code() {
  return is_row_begun_ ? close_code(detail::wire::SliceBits::cut) : end_code();
}

bool SliceEncoder::close_code(uint8_t bits) {
  packet_bits_ = static_cast<uint8_t>(packet_bits_ | detail::wire::SliceBits::last | bits);
  uint8_t* end = code_end(coder_.range.finish());
  if (bits == detail::wire::SliceBits::cut) {
    const uint64_t surface_rows = encoded_rows_ * surfaces_.count() + surface_;
    end = detail::wire::put(end, static_cast<uint32_t>(surface_rows), 4);
    end = detail::wire::put(end, row_.left(), 2);
  }
  seal(end);
  is_code_open_ = false;
  return packets_.drain();
}

// Returns the end of this many bytes of code in the packet.
uint8_t* SliceEncoder::code_end(size_t code_bytes) {
  const size_t head =
      (packet_bits_ & detail::wire::SliceBits::key) != 0 ? detail::wire::key_slice_head : 0;
  return packets_.payload() + head + code_bytes;
}

void SliceEncoder::seal(uint8_t* end) {
  const auto kind = static_cast<uint8_t>(detail::wire::PacketKind::slices) | packet_bits_;
  packets_.seal(static_cast<detail::wire::PacketKind>(kind), end);
  packet_bits_ = 0;
}

}  // namespace discmc
