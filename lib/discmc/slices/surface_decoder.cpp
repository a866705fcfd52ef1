#include <discmc/slices/surface_decoder.hpp>

namespace discmc {

namespace {

// Whether the row must be offered again. A row beyond the last possible slice is never accepted.
bool is_refused(PushResult row) {
  return row.status == Status::suspended && row.samples == 0;
}

}  // namespace

Status SurfaceDecoder::start(Memory memory, const Sink& sink, uint8_t channel) {
  const Status status = regions_.start(sink, channel);
  if (status != Status::ok) return status;
  sink_ = sink;
  channel_ = channel;
  memory_ = memory;
  is_known_ = false;
  is_of_slices_ = false;
  skipped_rows_ = 0;
  refusal_ = Status::ok;
  const RowSink rows{this, [](void* context, const RowEvent& event) {
                       return static_cast<SurfaceDecoder*>(context)->accept(event);
                     }};
  return slices_.start({}, rows, channel);  // its memory follows after the header
}

Decoded SurfaceDecoder::push(const uint8_t* bytes, size_t count) {
  size_t consumed = 0;
  // The header determines the kind of stream. Until then both decoders read.
  while (!is_known_ && consumed < count) {
    const Decoded decoded = push_to_both(bytes + consumed);
    consumed += decoded.bytes;
    if (decoded.status != Status::ok) return {decoded.status, consumed};
  }
  if (refusal_ != Status::ok) return {refusal_, consumed};
  const Decoded decoded = is_of_slices_ ? slices_.push(bytes + consumed, count - consumed)
                                        : regions_.push(bytes + consumed, count - consumed);
  return {decoded.status, consumed + decoded.bytes};
}

// Pushes one byte.
Decoded SurfaceDecoder::push_to_both(const uint8_t* byte) {
  const Decoded decoded = regions_.push(byte, 1);
  if (decoded.bytes == 0) return decoded;
  (void)slices_.push(byte, 1);
  note_kind();
  return {refusal_, 1};
}

void SurfaceDecoder::note_kind() {
  is_known_ = regions_.report().has_header;
  is_of_slices_ = regions_.report().holds_slices;
  if (is_of_slices_) refusal_ = begin_sweep();
}

// Both decoders read the packet that the active one holds. The active one restarts last.
void SurfaceDecoder::start_next() {
  skipped_rows_ = 0;
  refusal_ = Status::ok;
  if (is_of_slices_) {
    regions_.start_next(packets());
    slices_.start_next(packets());
  } else {
    slices_.start_next(packets());
    regions_.start_next(packets());
  }
  note_kind();
}

// The memory contains the rows of the slice decoder, followed by the memory of the extractor.
Status SurfaceDecoder::begin_sweep() {
  const Limits limits{header().width, header().height, header().border};
  const uint64_t row_bytes =
      SliceDecoder::minimum_bytes(limits, header().surface_count, header().levels);
  if (memory_.data == nullptr || memory_.bytes < row_bytes) return Status::too_little_memory;
  const auto bytes = static_cast<size_t>(row_bytes);
  const Memory rest{static_cast<uint8_t*>(memory_.data) + bytes, memory_.bytes - bytes};
  constexpr int32_t any_threshold = 0;  // the extractor receives bits, not samples
  // The slice decoder sends the start, with more members.
  const auto pass_all_but_start = [](void* context, const Event& event) {
    return event.kind == Event::Kind::start ? SinkResult::accepted
                                            : static_cast<SurfaceDecoder*>(context)->pass(event);
  };
  const Status status = extractor_.start(limits, any_threshold, rest, {this, pass_all_but_start});
  return status == Status::ok ? slices_.set_memory(memory_) : status;
}

Status SurfaceDecoder::set_memory(Memory memory) {
  if (sink_.accept == nullptr) return Status::not_started;
  if (refusal_ != Status::too_little_memory) return refusal_;
  memory_ = memory;
  refusal_ = begin_sweep();
  return refusal_;
}

Status SurfaceDecoder::finish() {
  const Status slices_status = slices_.finish();  // before a header, both decoders read
  if (!is_of_slices_) return regions_.finish();
  return slices_status == Status::ok ? extractor_.resume()
                                     : slices_status;  // if the stream had no trailer
}

// ---- rows ----

SinkResult SurfaceDecoder::accept(const RowEvent& event) {
  switch (event.kind) {
    case RowEvent::Kind::start:
      return begin(*event.header);
    case RowEvent::Kind::row:
      if (event.channel != wanted_channel()) return SinkResult::accepted;
      return is_refused(extractor_.push_bits(event.bits)) ? SinkResult::busy : SinkResult::accepted;
    case RowEvent::Kind::skipped:
      if (event.channel != wanted_channel()) return SinkResult::accepted;
      return skip(1, event.is_repeated ? Substitute::previous_row : Substitute::off);
    case RowEvent::Kind::lost:
      return skip(event.count, Substitute::off);
    case RowEvent::Kind::fractions: {
      if (event.channel != wanted_channel()) return SinkResult::accepted;
      Event passed{};
      passed.kind = Event::Kind::fractions;
      passed.slice = event.slice;
      passed.row = event.row;
      passed.fractions = event.fractions;
      return pass_between(passed);
    }
    case RowEvent::Kind::application: {
      Event passed{};
      passed.kind = Event::Kind::application;
      passed.application = event.application;
      return pass_between(passed);
    }
    case RowEvent::Kind::finish:
      break;
  }
  return end(event.is_abandoned);
}

// Passes an event that the extractor does not send. Events of the rows before come first, and a
// region is not interrupted.
SinkResult SurfaceDecoder::pass_between(const Event& event) {
  return extractor_.resume() == Status::suspended ? SinkResult::busy : pass(event);
}

// Reduces the header of several surfaces to the wanted surface.
SinkResult SurfaceDecoder::begin(const StreamHeader& stream_header) {
  StreamHeader header = stream_header;
  header.channel = wanted_channel();
  header.thresholds[0] = stream_header.thresholds[header.channel - uint32_t{stream_header.channel}];
  for (uint32_t i = 1; i < StreamHeader::max_surfaces; ++i) header.thresholds[i] = 0;
  header.surface_count = 1;
  Event event{};
  event.kind = Event::Kind::start;
  event.header = &header;
  return pass(event);
}

SinkResult SurfaceDecoder::skip(uint64_t rows, Substitute substitute) {
  for (uint32_t count = 0; skipped_rows_ < rows; ++skipped_rows_, ++count) {
    if (count == max_skipped_rows) return SinkResult::busy;
    const PushResult row = extractor_.skip_row(substitute);
    if (is_refused(row)) return SinkResult::busy;
    if (row.samples == 0) break;
  }
  skipped_rows_ = 0;
  return SinkResult::accepted;
}

SinkResult SurfaceDecoder::end(bool is_abandoned) {
  Status status = is_abandoned ? extractor_.abandon() : extractor_.finish();
  if (status == Status::slice_in_progress) status = extractor_.abandon();
  return status == Status::suspended ? SinkResult::busy : SinkResult::accepted;
}

}  // namespace discmc
