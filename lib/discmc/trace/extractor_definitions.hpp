// The functions of extractor.hpp. Include this file where an extractor is instantiated: in the
// library, or in a program with a LeanExtractor16.
#ifndef DISCMC_TRACE_EXTRACTOR_DEFINITIONS_HPP
#define DISCMC_TRACE_EXTRACTOR_DEFINITIONS_HPP

#include <discmc/extractor.hpp>

namespace discmc {

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::start(const Limits& limits,
                                                   const Capacities& capacities, int32_t threshold,
                                                   Memory memory, const Sink& sink) {
  static_assert(sizeof(detail::trace::Slot<Index, typename Intake::Normal>) ==
                    detail::sizing::slot_bytes<Index, Intake>,
                "slot_bytes is the size of a slot");
  if (!limits.is_valid() || !can_scan(limits)) return Status::bad_limits;
  if (!detail::sizing::is_valid<Index>(capacities)) return Status::bad_capacities;
  if (sink.accept == nullptr) return Status::bad_sink;
  state_ = State::idle;
  width_ = limits.width;
  height_ = limits.height;
  border_ = limits.border;
  if constexpr (!is_lean) {
    first_slice_ = limits.slab.first;
    continues_below_ = limits.slab.continues_below;
    continues_above_ = limits.slab.continues_above;
  }
  capacities_ = capacities;
  sink_ = sink;
  threshold_ = threshold;
  if (!lay_out(limits, memory)) return Status::too_little_memory;
  const Status status = begin();
  if (status == Status::bad_sink) unpoison(memory.data, memory.bytes);  // red zones
  return status;
}

// Offers the `start` event, and begins the scan unless the sink has not started.
template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::begin() {
  const SinkResult answer = send_start();
  if (answer == SinkResult::not_started) return Status::bad_sink;
  clear();
  if (answer == SinkResult::accepted) return Status::ok;
  due_ = Due::start;
  return Status::suspended;
}

template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::can_scan(const Limits& limits) {
  const Slab& slab = limits.slab;
  return !is_lean ||
         (limits.border == Border::closed && !slab.continues_below && !slab.continues_above);
}

// Assigns the arrays their places in the memory, and writes nothing there. Returns false if they do
// not fit.
template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::lay_out(const Limits& limits, Memory memory) {
  Arena arena(memory);
  intake_.start(arena, limits);
  bits_.start(arena, limits, detail::trace::swept_rows(limits.height));
  sweep_.start(arena, capacities_);
  memory_ = memory;
  if (arena.is_exhausted()) unpoison(memory.data, memory.bytes);
  return !arena.is_exhausted();
}

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::reset() {
  return state_ == State::idle ? Status::not_started : begin();
}

template <class Index, class Intake, class Sweep>
DISCMC_NOINLINE void BasicExtractor<Index, Intake, Sweep>::clear() {
  intake_.clear();
  bits_.clear();
  sweep_.clear();
  statistics_ = Statistics{};
  state_ = State::scanning;
  is_abandoned_ = false;
  due_ = Due::nothing;
  swept_rows_ = 0;
}

template <class Index, class Intake, class Sweep>
size_t BasicExtractor<Index, Intake, Sweep>::bytes_used() const {
  if (state_ == State::idle) return 0;
  unpoison(memory_.data, memory_.bytes);  // the caller saves all of it, with free slots
  return static_cast<size_t>(bytes_for(limits(), {peaks().slots, 0}));
}

// ---- input of the caller ----

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::ready_for_samples() {
  if (state_ == State::idle) return Status::not_started;
  if (state_ != State::scanning) return Status::finished;
  if (!work()) return Status::suspended;
  const uint32_t context = continues_below() ? 1 : 0;
  if (slices() >= Limits::max_slices - first_slice() + context) return Status::too_many_slices;
  if constexpr (Sweep::max_slices < Limits::max_slices)
    if (slices() >= Sweep::max_slices) return Status::too_many_slices;
  return Status::ok;
}

template <class Index, class Intake, class Sweep>
template <class Sample>
PushResult BasicExtractor<Index, Intake, Sweep>::push_samples(const Sample* samples, uint32_t count,
                                                              uint32_t stride) {
  PushResult result{ready_for_samples(), 0};
  while (result.status == Status::ok && result.samples < count) {
    const uint32_t row_samples =
        samples_of_row(count - result.samples, intake_.column(bits_), width_);
    note_origin(intake_.append(bits_, samples + size_t{result.samples} * stride, row_samples,
                               stride, threshold_));
    result.samples += row_samples;
    const bool is_last = result.samples == count;
    result.status = is_last ? resume() : ready_for_samples();
  }
  return result;
}

template <class Index, class Intake, class Sweep>
PushResult BasicExtractor<Index, Intake, Sweep>::push_bits(const uint8_t* bits) {
  const Status status = ready_for_samples();
  if (status != Status::ok) return {status, 0};
  if (bits_.column() != 0) return {Status::row_in_progress, 0};
  bits_.append_bits(bits);
  bits_.next_row();
  return {resume(), width_};
}

template <class Index, class Intake, class Sweep>
PushResult BasicExtractor<Index, Intake, Sweep>::skip_row(Substitute substitute) {
  const Status status = ready_for_samples();
  if (status != Status::ok) return {status, 0};
  if (intake_.column(bits_) != 0) return {Status::row_in_progress, 0};
  note_origin(intake_.skip(bits_, substitute == Substitute::previous_row, threshold_));
  return {resume(), width_};
}

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::resume() {
  if (state_ == State::idle) return Status::not_started;
  return work() ? Status::ok : Status::suspended;
}

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::finish() {
  if (state_ == State::scanning) {
    const bool is_between_slices = rows() == 0 || rows() == height_;
    if (!is_between_slices || intake_.column(bits_) != 0) return Status::slice_in_progress;
    state_ = State::finishing;
  }
  return resume();
}

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::abandon() {
  if (state_ == State::scanning) {
    state_ = State::finishing;
    is_abandoned_ = true;
  }
  return resume();
}

// The event of a row without samples precedes its sweep.
template <class Index, class Intake, class Sweep>
void BasicExtractor<Index, Intake, Sweep>::note_origin(detail::trace::RowOrigin origin) {
  if (origin == detail::trace::RowOrigin::samples) return;
  due_ = origin == detail::trace::RowOrigin::repeated ? Due::repeated_row : Due::off_row;
  ++statistics_.skipped_rows;
}

// ---- checkpoints ----

// Whether the sink has refused a pending event.
template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::is_suspended() const {
  return due_ != Due::nothing || swept_rows_ < ready_rows() || bits_.rows() == height_ ||
         state_ == State::finishing;
}

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::save(Memory* parts) {
  if (state_ == State::idle) return Status::not_started;
  if (is_suspended()) return Status::suspended;
  parts[0] = {this, sizeof *this};
  parts[1] = {memory_.data, bytes_used()};
  seal_.close(this, sizeof *this, layout, parts[1]);
  return Status::ok;
}

template <class Index, class Intake, class Sweep>
Status BasicExtractor<Index, Intake, Sweep>::restore(Memory memory, const Sink& sink) {
  if (sink.accept == nullptr) return Status::bad_sink;
  if (memory.data == nullptr) return Status::too_little_memory;
  if (!seal_.is_intact(this, sizeof *this, layout, memory)) {
    state_ = State::idle;
    return Status::bad_checkpoint;
  }
  sink_ = sink;
  if (lay_out(limits(), memory)) return Status::ok;
  state_ = State::idle;
  return Status::too_little_memory;
}

// ---- the sweep ----

// Does all work that the available rows allow. Returns false if the sink is busy.
template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::work() {
  while (state_ != State::finished) {
    if (due_ != Due::nothing && !send_due()) return false;
    for (; swept_rows_ < ready_rows(); ++swept_rows_)
      if (!sweep_row()) return false;
    if (bits_.rows() == height_ && !end_slice()) return false;
    if (state_ == State::scanning) break;
    if (intake_.holds_rows(bits_))
      note_origin(intake_.drain(bits_, threshold_));
    else if (swept_rows_ == ready_rows() && !end_scan())
      return false;
  }
  return true;
}

// The slice that is being swept: the one before the arriving slice. Pushed slices count.
template <class Index, class Intake, class Sweep>
int32_t BasicExtractor<Index, Intake, Sweep>::middle_slice() const {
  return static_cast<int32_t>(bits_.slices()) - 1;
}

// Whether no slice follows the swept one.
template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::is_last_slice() const {
  return state_ == State::finishing && !intake_.holds_rows(bits_);
}

// Returns the rows of the swept slice whose neighbours are available. With a closed border they
// begin with the row before the first, in the slice before the first. A slab begins in the slice
// below it.
template <class Index, class Intake, class Sweep>
uint32_t BasicExtractor<Index, Intake, Sweep>::ready_rows() const {
  const bool is_closed = !is_open();
  const int32_t first_own = continues_below() ? 1 : is_closed ? -1 : 0;
  if (middle_slice() < (continues_below() ? 0 : first_own)) return 0;
  const bool is_last = is_last_slice();
  // The slice above a slab is absent if the slab has no slices.
  if (is_last && continues_above() && middle_slice() == first_own) return 0;
  const uint32_t arrived = is_last ? height_ : bits_.rows();
  if (arrived == height_) return height_ + (is_closed ? 1 : 0);
  return is_closed || arrived == 0 ? arrived : arrived - 1;
}

// Returns the rows of cells around row y that lie outside the volume (CellRowBits).
template <class Index, class Intake, class Sweep>
uint32_t BasicExtractor<Index, Intake, Sweep>::rows_outside(int32_t y) const {
  if (!is_open()) return 0;
  uint32_t outside = 0;
  if (y == 0) outside |= detail::trace::CellRowBits::front;
  if (y + 1 == static_cast<int32_t>(height_)) outside |= detail::trace::CellRowBits::back;
  if (middle_slice() == 0) outside |= detail::trace::CellRowBits::below;
  if (is_last_slice()) outside |= detail::trace::CellRowBits::above;
  return outside;
}

// Returns the role of the swept slice in its slab.
template <class Index, class Intake, class Sweep>
DISCMC_NOINLINE detail::trace::SlabRole BasicExtractor<Index, Intake, Sweep>::slab_role() const {
  using detail::trace::SlabRole;
  if (continues_below() && middle_slice() == 0) return SlabRole::below_slab;
  if (continues_below() && middle_slice() == 1) return SlabRole::first_of_slab;
  return continues_above() && is_last_slice() ? SlabRole::above_slab : SlabRole::inside;
}

template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::sweep_row() {
  const int32_t y = static_cast<int32_t>(swept_rows_) - (is_open() ? 0 : 1);
  if (bits_.is_off_around(y)) return true;
  detail::trace::SweptRow row;
  row.y = y;
  row.z = middle_slice() + static_cast<int32_t>(first_slice()) - (continues_below() ? 1 : 0);
  bits_.find_around(row.y, row.around);
  row.words = bits_.words();
  row.width = width_;
  row.role = is_lean ? detail::trace::SlabRole::inside : slab_role();
  row.absent_rows = rows_outside(row.y);
  if (row.role == detail::trace::SlabRole::below_slab)
    row.absent_rows |= detail::trace::CellRowBits::below;
  if (row.role == detail::trace::SlabRole::above_slab)
    row.absent_rows |= detail::trace::CellRowBits::above;
  row.has_open_ends = is_open();
  row.set_absent_quadrants();
  return sweep_.sweep(row, intake_, sink_, statistics_);
}

// Counts the slices of the slab itself, without context slices.
template <class Index, class Intake, class Sweep>
uint32_t BasicExtractor<Index, Intake, Sweep>::own_slices() const {
  const uint32_t context = (continues_below() ? 1U : 0U) + (continues_above() ? 1U : 0U);
  return bits_.slices() > context ? bits_.slices() - context : 0;
}

template <class Index, class Intake, class Sweep>
SinkResult BasicExtractor<Index, Intake, Sweep>::send_start() {
  StreamHeader header;
  header.width = width_;
  header.height = height_;
  header.thresholds[0] = threshold_;
  header.border = border_;
  intake_.write_spacing(header.spacing_nm);
  Event event{};
  event.kind = Event::Kind::start;
  event.header = &header;
  return sink_.accept(sink_.context, event);
}

// Offers the event that precedes the sweep. Returns false if the sink is busy.
template <class Index, class Intake, class Sweep>
DISCMC_ALWAYS_INLINE bool BasicExtractor<Index, Intake, Sweep>::send_due() {
  const bool is_sent = due_ == Due::start
                           ? send_start() == SinkResult::accepted
                           : sweep_.flush(sink_, statistics_) && send(Event::Kind::skipped);
  if (is_sent) due_ = Due::nothing;
  return is_sent;
}

// Offers an event about rows and slices.
template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::send(Event::Kind kind) {
  const uint32_t below = continues_below() ? 1 : 0;
  Event event{};
  event.kind = kind;
  event.slice = bits_.slices() + first_slice() - below;
  event.row = bits_.rows() - 1;
  event.is_repeated = due_ == Due::repeated_row;
  event.is_abandoned = is_abandoned_;
  event.statistics = &statistics_;
  if (kind == Event::Kind::finish) event.slice = own_slices();
  return sink_.accept(sink_.context, event) == SinkResult::accepted;
}

template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::end_slice() {
  if (!sweep_.flush(sink_, statistics_) || !send(Event::Kind::layer)) return false;
  bits_.next_slice();
  swept_rows_ = 0;
  return true;
}

template <class Index, class Intake, class Sweep>
bool BasicExtractor<Index, Intake, Sweep>::end_scan() {
  if (!sweep_.deliver_remaining_holes(sink_, statistics_)) return false;
  if (!send(Event::Kind::finish)) return false;
  state_ = State::finished;
  unpoison(memory_.data, memory_.bytes);
  return true;
}

}  // namespace discmc

#endif
