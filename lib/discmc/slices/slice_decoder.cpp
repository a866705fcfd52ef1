#include <discmc/slice_decoder.hpp>

namespace discmc {

using detail::slices::RowNote;

namespace {

// The most bytes that a step or a note reads.
constexpr size_t max_step_bytes = 4;
static_assert(max_step_bytes <= detail::wire::packet_head,
              "what is left has room before a payload");

}  // namespace

Status SliceDecoder::start(Memory memory, const RowSink& sink, uint8_t channel) {
  if (sink.accept == nullptr) return Status::bad_sink;
  if (!StreamLabel::is_receivable(channel)) return Status::bad_label;
  sink_ = sink;
  memory_ = memory;
  packets_.start(channel);
  clear();
  return Status::ok;
}

void SliceDecoder::start_next(const detail::stream::PacketReader& before) {
  memory_ = {};
  clear();
  open(packets_.start_next(before));
}

void SliceDecoder::clear() {
  stage_ = Stage::collect;
  is_started_ = true;
  refusal_ = Status::ok;
  is_laid_out_ = false;
  is_whole_ = false;
  slice_ = 0;
  passed_rows_ = 0;
}

Decoded SliceDecoder::push(const uint8_t* bytes, size_t count) {
  if (!is_started_) return {Status::not_started, 0};
  for (size_t consumed = 0;; ++consumed) {
    if (refusal_ != Status::ok) return {refusal_, consumed};
    if (!deliver()) return {status_of(answer_), consumed};
    if (consumed == count) return {Status::ok, count};
    open(packets_.add(bytes[consumed]));
  }
}

Status SliceDecoder::set_memory(Memory memory) {
  if (!is_started_) return Status::not_started;
  if (refusal_ != Status::too_little_memory) return refusal_;
  memory_ = memory;
  refusal_ = Status::ok;
  lay_out();
  return refusal_;
}

Status SliceDecoder::finish() {
  if (!is_started_) return Status::not_started;
  if (refusal_ != Status::ok) return refusal_;
  if (!deliver()) return status_of(answer_);
  packets_.finish();
  return Status::ok;
}

// ---- packets ----

void SliceDecoder::open(detail::stream::PacketReader::Completed arrival) {
  if (packets_.is_refused()) refusal_ = Status::wrong_version;
  if (packets_.remove_gap()) is_whole_ = false;
  if (report().holds_slices && !is_laid_out_) lay_out();
  if (!is_laid_out_) return;
  if (arrival == detail::stream::PacketReader::Completed::slices) open_slices();
  if (arrival == detail::stream::PacketReader::Completed::application) stage_ = Stage::application;
  if (arrival == detail::stream::PacketReader::Completed::trailer) {
    const uint64_t max_rows = uint64_t{Limits::max_slices} * header().height;
    const uint64_t total = report().total_rows < max_rows ? report().total_rows : max_rows;
    lost_rows_ = total > passed_rows_ ? total - passed_rows_ : 0;
    stage_ = Stage::lose;
  }
}

void SliceDecoder::lay_out() {
  Arena arena(memory_);
  surfaces_.start(arena, header(), detail::slices::rows_kept(header().height, false));
  bits_ = arena.allocate<uint8_t>((header().width + 7) / 8);
  if (header().levels != 0) {
    fractions_.start(arena, header());
    fractions_of_row_ = arena.allocate<uint16_t>(header().width);
  }
  if (arena.is_exhausted()) {
    refusal_ = Status::too_little_memory;
    return;
  }
  clear_rows();
  is_laid_out_ = true;
  stage_ = Stage::start;
}

void SliceDecoder::clear_rows() {
  surfaces_.clear();
  if (header().levels != 0) fractions_.clear();
}

// Nothing can be read until the next key slice.
void SliceDecoder::wait_for_key_slice() {
  packets_.note_unreadable();
  is_whole_ = false;
  stage_ = Stage::collect;
}

void SliceDecoder::open_slices() {
  using detail::wire::SliceBits;
  const uint8_t bits = packets_.slice_bits();
  uint8_t* code = packets_.payload();
  size_t bytes = packets_.payload_bytes();
  stage_ = Stage::lose;
  lost_rows_ = 0;
  if ((bits & SliceBits::key) != 0) {
    // A key slice begins a code; in the middle of a code it cannot be read.
    const bool begins_code = (bits & SliceBits::first) != 0;
    if (!begins_code || bytes < detail::wire::key_slice_head || !begin_key_slice())
      return wait_for_key_slice();
    code += detail::wire::key_slice_head;
    bytes -= detail::wire::key_slice_head;
  }
  if (!is_whole_) {
    stage_ = Stage::collect;
    return;
  }
  const bool continues_in_row = has_cut_;
  is_code_over_ = (bits & SliceBits::last) != 0;
  has_cut_ = (bits & SliceBits::cut) != 0;
  if (has_cut_) {
    if (bytes < detail::wire::cut_tail || !is_code_over_) return wait_for_key_slice();
    bytes -= detail::wire::cut_tail;
    detail::wire::ByteReader tail(code + bytes, detail::wire::cut_tail);
    cut_row_ = static_cast<uint32_t>(tail.get(4));
    cut_left_ = static_cast<uint32_t>(tail.get(2));
  }
  if ((bits & SliceBits::first) == 0) {
    for (uint32_t i = rest_bytes_; i > 0; --i) *--code = rest_[i - 1];
    coder_.range.continue_in(code, bytes + rest_bytes_);
    return;
  }
  // A code begins with a row, or at the cut of the previous code. Its first packet has the bytes
  // that a decoder reads first.
  if (is_row_begun_ != continues_in_row || (bytes < max_step_bytes && !is_code_over_))
    return wait_for_key_slice();
  coder_.range = RangeDecoder(code, bytes);
}

bool SliceDecoder::begin_key_slice() {
  const auto slice = static_cast<uint32_t>(detail::wire::ByteReader(packets_.payload(), 4).get(4));
  const bool is_ahead = slice > slice_ || (slice == slice_ && surfaces_.rows().rows() == 0);
  if (slice >= Limits::max_slices || !is_ahead) return false;
  lost_rows_ = uint64_t{slice - slice_} * header().height - surfaces_.rows().rows();
  next_slice_ = slice;
  is_whole_ = true;
  is_key_ahead_ = true;
  is_row_begun_ = false;
  surface_ = 0;
  surfaces_with_fractions_ = 0;
  has_cut_ = false;
  surfaces_.begin_key_slice();
  is_slice_before_known_ = slice > 0 && lost_rows_ == 0;
  if (header().levels != 0) fractions_.begin_models();
  return true;
}

// ---- rows ----

// Whether the present bytes suffice for any step.
bool SliceDecoder::can_read() const {
  return is_code_over_ || coder_.range.left() >= max_step_bytes;
}

bool SliceDecoder::is_at_cut() const {
  if (!has_cut_ || !is_row_begun_) return false;
  const uint32_t left = row_.is_done() ? fraction_code_.left() : row_.left();
  const uint32_t part = row_.is_done() ? fraction_code_.part() : 0;
  const uint64_t rows = (passed_rows_ + part) * surfaces_.count() + surface_;
  return left == cut_left_ && static_cast<uint32_t>(rows) == cut_row_;
}

// Reads up to the end of a row, or of the available bytes.
void SliceDecoder::read() {
  while (can_read()) {
    if (is_at_cut()) {
      stage_ = Stage::collect;
      return;
    }
    const bool is_good = is_row_begun_ ? read_step() : begin_row();
    if (!is_good || coder_.range.is_exhausted()) return wait_for_key_slice();
    if (note_ == RowNote::end) {
      stage_ = Stage::collect;
      return;
    }
    if (is_row_done()) {
      is_row_begun_ = false;
      if (header().levels != 0 && fractions_.has_fractions(surface_))
        surfaces_with_fractions_ |= static_cast<uint8_t>(1 << surface_);
      if (++surface_ < surfaces_.count()) continue;
      surface_ = 0;
      stage_ = Stage::deliver_rows;
      return;
    }
  }
  const size_t left = coder_.range.left();
  for (rest_bytes_ = 0; rest_bytes_ < left; ++rest_bytes_)
    rest_[rest_bytes_] = coder_.range.rest()[rest_bytes_];
  stage_ = Stage::collect;
}

// Returns false if no encoder wrote the row.
bool SliceDecoder::begin_row() {
  if (surface_ == 0) {
    if (!read_note()) return false;
    if (note_ == RowNote::end) return is_code_over_;
    if (surfaces_.rows().rows() == 0 && !is_key_ahead_) surfaces_.begin_following_slice();
    is_key_ahead_ = false;
  }
  detail::trace::BitRows& rows = surfaces_[surface_].rows;
  if (note_ == RowNote::repeated) rows.repeat();  // otherwise it stays off
  surfaces_.begin_row(row_, surface_, note_ == RowNote::none ? header().width : 0);
  is_row_begun_ = true;
  fraction_code_.end();
  if (header().levels != 0) fractions_.begin_row(rows, surface_);
  return true;
}

// Reads the next voxel, run or fraction. Returns false if no encoder wrote it.
bool SliceDecoder::read_step() {
  if (row_.is_done()) return fraction_code_.step(coder_);
  if (!row_.step(coder_, surfaces_[surface_].model)) return false;
  if (!row_.is_done()) return true;
  row_.complete(surfaces_.rows().words());
  if (header().levels != 0) begin_fractions();
  return true;
}

void SliceDecoder::begin_fractions() {
  using KeyEdges = detail::slices::FractionCode::KeyEdges;
  const bool is_key = surfaces_.is_in_key_slice();
  const bool is_slice_before_known = !is_key || is_slice_before_known_;
  const KeyEdges key_edges = !is_key || slice_ == 0  ? KeyEdges::none
                             : is_slice_before_known ? KeyEdges::known
                                                     : KeyEdges::unknown;
  const detail::trace::BitRows& rows = surfaces_[surface_].rows;
  fraction_code_.begin(fractions_.around(rows, surface_, is_slice_before_known),
                       fractions_.model(surface_), key_edges, rows.off());
}

bool SliceDecoder::read_note() {
  note_ = RowNote::none;
  if (!coder_.code_bit(surfaces_.note(), false)) return true;
  const uint32_t note = coder_.raw_bits(detail::slices::note_bits, 0);
  if (note >= static_cast<uint32_t>(RowNote::none)) return false;
  note_ = static_cast<RowNote>(note);
  return note_ != RowNote::repeated || !is_key_ahead_;
}

// ---- delivery ----

// Delivers all pending events. Returns false if the sink does not accept one.
bool SliceDecoder::deliver() {
  for (;;) {
    switch (stage_) {
      case Stage::collect:
        return true;
      case Stage::lose:
        if (!report_loss()) return false;
        stage_ = report().has_trailer ? Stage::finish : Stage::read;
        break;
      case Stage::read:
        read();
        break;
      case Stage::deliver_rows:
        if (!deliver_rows()) return false;
        stage_ = Stage::read;
        break;
      case Stage::start:
        if (!offer(RowEvent::Kind::start)) return false;
        stage_ = Stage::collect;
        break;
      case Stage::application:
        if (!offer(RowEvent::Kind::application)) return false;
        stage_ = Stage::collect;
        break;
      case Stage::finish:
        if (!offer(RowEvent::Kind::finish)) return false;
        stage_ = Stage::collect;
        break;
    }
  }
}

bool SliceDecoder::report_loss() {
  if (lost_rows_ == 0) return true;
  if (!offer(RowEvent::Kind::lost)) return false;
  packets_.report().lost_rows += lost_rows_;
  passed_rows_ += lost_rows_;
  slice_ = next_slice_;
  clear_rows();
  return true;
}

// Delivers the rows of all surfaces, or of none: a loss affects all of them.
bool SliceDecoder::deliver_rows() {
  const bool is_row = note_ == RowNote::none;
  for (; surface_ < surfaces_.count(); ++surface_) {
    if ((surfaces_with_fractions_ >> surface_ & 1) != 0) {
      if (!offer(RowEvent::Kind::fractions)) return false;
      surfaces_with_fractions_ ^= static_cast<uint8_t>(1 << surface_);
    }
    if (!offer(is_row ? RowEvent::Kind::row : RowEvent::Kind::skipped)) return false;
  }
  surface_ = 0;
  if (header().levels != 0) fractions_.next_row(surfaces_.rows().rows(), is_row);
  ++packets_.report().rows;
  ++passed_rows_;
  if (surfaces_.next_row()) ++slice_;
  return true;
}

bool SliceDecoder::offer(RowEvent::Kind kind) {
  RowEvent event{};
  event.kind = kind;
  event.is_repeated = note_ == RowNote::repeated;
  event.is_abandoned = report().is_abandoned;
  event.slice = kind == RowEvent::Kind::finish ? report().slices : slice_;
  event.row = surfaces_.rows().rows();
  event.channel = static_cast<uint8_t>(header().channel + surface_);
  event.count = lost_rows_;
  ApplicationRecord application;
  if (kind == RowEvent::Kind::start) {
    event.header = &header();
  } else if (kind == RowEvent::Kind::application) {
    application = packets_.application();
    event.application = &application;
  } else if (kind == RowEvent::Kind::fractions) {
    const uint16_t* const entries = fractions_.entries(surface_);
    for (uint32_t x = 0; x < header().width; ++x)
      fractions_of_row_[x] = entries[x] & detail::slices::FractionEntry::own;
    event.fractions = fractions_of_row_;
  } else if (kind == RowEvent::Kind::row || kind == RowEvent::Kind::skipped) {
    surfaces_[surface_].rows.write_bits(bits_);
    event.bits = bits_;
  }
  answer_ = sink_.accept(sink_.context, event);
  return answer_ == SinkResult::accepted;
}

}  // namespace discmc
