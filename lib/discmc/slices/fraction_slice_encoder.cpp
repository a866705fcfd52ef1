#include <discmc/fraction_slice_encoder.hpp>

namespace discmc {

using detail::slices::FractionCode;
using detail::slices::FractionRow;
using detail::slices::RowNote;

template <class Sample>
Status FractionSliceEncoder<Sample>::start(const SliceEncoderConfig& config, Memory memory,
                                           const ByteOutput& output) {
  if (config.levels != 2 && config.levels != 4) return Status::bad_label;
  fraction_flags_ = static_cast<uint8_t>(2 * config.levels);
  fraction_type_ = sample_type<Sample>;
  fraction_object_bytes_ = sizeof(FractionSliceEncoder) - sizeof(SliceEncoder);
  is_begun_ = false;
  const Status status = SliceEncoder::start(config, memory, output);
  if (status != Status::ok) return status;
  packets_.header().levels = config.levels;
  if (!lay_out_fractions(memory)) {
    state_ = State::idle;
    return Status::too_little_memory;
  }
  fractions_.clear();
  return status;
}

// Allocates memory behind that of the SliceEncoder. Returns false if the arrays do not fit.
template <class Sample>
bool FractionSliceEncoder<Sample>::lay_out_fractions(Memory memory) {
  const StreamHeader& header = packets_.header();
  Arena arena({static_cast<uint8_t*>(memory.data) + bytes_used_, memory.bytes - bytes_used_});
  fractions_.start(arena, header);
  samples_ = arena.allocate<Sample>(header.width);
  for (uint32_t surface = 0; surface < header.surface_count; ++surface)
    distances_[surface] =
        arena.allocate<uint8_t>(Intake::distance_bytes(header.width) * header.height);
  bytes_used_ = memory.bytes - arena.left();
  code_fractions_ = [](SliceEncoder& encoder) {
    return static_cast<FractionSliceEncoder&>(encoder).code_row();
  };
  if (arena.is_exhausted()) unpoison(memory.data, memory.bytes);
  return !arena.is_exhausted();
}

template <class Sample>
Status FractionSliceEncoder<Sample>::restore(Memory memory, const ByteOutput& output) {
  const Status status = restore_object(sizeof *this, sample_type<Sample>, memory, output);
  if (status == Status::ok) lay_out_fractions(memory);
  return status;
}

template <class Sample>
PushResult FractionSliceEncoder<Sample>::push(const Sample* samples, uint32_t count,
                                              uint32_t stride) {
  return push_parts(samples, count, stride,
                    [this, stride](const Sample* part, uint32_t part_count) {
                      const uint32_t first = column();
                      append(part, part_count, stride);
                      process(part, first, part_count, stride);
                    });
}

// Finds the fractions of the samples appended from this column on.
template <class Sample>
void FractionSliceEncoder<Sample>::process(const Sample* samples, uint32_t first, uint32_t count,
                                           uint32_t stride) {
  for (uint32_t surface = 0; surface < surfaces_.count(); ++surface) {
    if (first == 0) fractions_.begin_row(surfaces_[surface].rows, surface);
    intake(surface).find(around(surface), samples, first, count, stride);
  }
  // By now all surfaces have read the samples of the previous row.
  Intake::keep(samples, count, stride, samples_ + first);
  for (uint32_t surface = 0; surface < surfaces_.count(); ++surface)
    intake(surface).keep_distances(first, count);
}

// Codes the fractions of a row of one surface. Returns false if the output is busy.
template <class Sample>
bool FractionSliceEncoder<Sample>::code_row() {
  if (!is_begun_) begin_code();
  while (!code_.is_done()) {
    if (!has_room() && !make_room_for_fraction()) return false;
    code_.step(coder_);
  }
  is_begun_ = false;
  if (surface_ + 1U == surfaces_.count()) fractions_.next_row(rows(), note_ == RowNote::none);
  return true;
}

// A cut at this time is at this position of the row.
template <class Sample>
bool FractionSliceEncoder<Sample>::make_room_for_fraction() {
  const uint32_t part = code_.part();
  encoded_rows_ += part;
  row_.set_left(code_.left());
  const bool has_room = make_room();
  row_.set_left(0);
  encoded_rows_ -= part;
  return has_room;
}

template <class Sample>
void FractionSliceEncoder<Sample>::begin_code() {
  is_begun_ = true;
  const bool is_key = surfaces_.is_in_key_slice();
  if (is_key && rows() == 0 && surface_ == 0) fractions_.begin_models();
  if (note_ != RowNote::none) {
    fractions_.begin_row(surfaces_[surface_].rows, surface_);
    code_.end();
    return;
  }
  using KeyEdges = FractionCode::KeyEdges;
  const KeyEdges key_edges = is_key && slices() > 0 ? KeyEdges::known : KeyEdges::none;
  if (key_edges == KeyEdges::none && !fractions_.has_fractions(surface_)) return code_.end();
  code_.begin(around(surface_), fractions_.model(surface_), key_edges,
              surfaces_[surface_].rows.off());
}

template class FractionSliceEncoder<uint8_t>;
template class FractionSliceEncoder<uint16_t>;
template class FractionSliceEncoder<int16_t>;

}  // namespace discmc
