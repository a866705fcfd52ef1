// What the functions of extractor.hpp do: included where Extractor is instantiated.
#ifndef DISCMC_TRACE_EXTRACTOR_DEFINITIONS_HPP
#define DISCMC_TRACE_EXTRACTOR_DEFINITIONS_HPP

#include <discmc/compiler.hpp>
#include <discmc/extractor.hpp>
#include <discmc/trace/seams.hpp>

namespace discmc {

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::start(const Limits& limits, const Capacities& capacities,
                                               int32_t threshold, Memory memory, const Sink& sink,
                                               AtSeam at_seam) {
  static_assert(sizeof(trace::Record<Index, Normal>) == sizing::record_bytes<Index, Normals>,
                "what is said of the size of a record is true");
  if (!limits.is_valid()) return Status::bad_limits;
  if (!is_valid<Index>(capacities)) return Status::bad_capacities;
  if (sink.take == nullptr) return Status::bad_sink;
  state_ = State::idle;
  // Member by member: what lies between them in the caller's is not for a checkpoint.
  limits_.width = limits.width;
  limits_.height = limits.height;
  limits_.border = limits.border;
  limits_.slab.first = limits.slab.first;
  limits_.slab.continues_below = limits.slab.continues_below;
  limits_.slab.continues_above = limits.slab.continues_above;
  capacities_ = capacities;
  sink_ = sink;
  threshold_ = threshold;
  sweep_.fragments().set_at_seam(at_seam);
  if (!lay_out(memory)) return Status::too_little_memory;
  if (!tell_start()) return Status::bad_sink;
  clear();
  return Status::ok;
}

// Says what lies where in the memory, and writes nothing there. False when it has no room. The
// records come last, so that those never used are behind all that is in use.
template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::lay_out(Memory memory) {
  Arena arena(memory);
  intake_.start(arena, limits_);
  rows_.start(arena, limits_, trace::swept_rows(limits_.height));
  auto* const queues = arena.take<trace::Queue<Index>>(trace::queue_count);
  auto* const holes = arena.take<Index>(sizing::hole_lists);
  auto* const records = arena.take<trace::Record<Index, Normal>>(capacities_.records);
  sweep_.fragments().start(records, capacities_.records, queues);
  sweep_.delivery().start(holes, capacities_.holes);
  memory_ = memory;
  return !arena.is_exhausted();
}

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::reset() {
  if (state_ == State::idle) return Status::not_started;
  if (!tell_start()) return Status::bad_sink;
  clear();
  return Status::ok;
}

template <class Index, class Normals, class Sweep>
void Extractor<Index, Normals, Sweep>::clear() {
  intake_.clear();
  rows_.clear();
  sweep_.clear();
  statistics_ = Statistics{};
  state_ = State::scanning;
  abandoned_ = false;
  skip_untold_ = false;
  swept_rows_ = 0;
}

template <class Index, class Normals, class Sweep>
size_t Extractor<Index, Normals, Sweep>::bytes_used() const {
  if (state_ == State::idle) return 0;
  return static_cast<size_t>(bytes_for<Index, Normals>(limits_, {high_water().records, 0}));
}

// ---- what the caller gives ----

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::ready_for_samples() {
  if (state_ == State::idle) return Status::not_started;
  if (state_ != State::scanning) return Status::finished;
  if (!work()) return Status::more;
  if (slices() >= Limits::max_slices - limits_.slab.first) return Status::too_deep;
  return Status::ok;
}

template <class Index, class Normals, class Sweep>
template <class Sample>
PushResult Extractor<Index, Normals, Sweep>::push_samples(const Sample* samples, uint32_t count,
                                                          uint32_t stride) {
  PushResult result{ready_for_samples(), 0};
  while (result.status == Status::ok && result.samples < count) {
    const uint32_t taken =
        samples_of_row(count - result.samples, intake_.column(rows_), limits_.width);
    note(intake_.append(rows_, samples + size_t{result.samples} * stride, taken, stride,
                        threshold_));
    result.samples += taken;
    const bool is_last = result.samples == count;
    result.status = is_last ? resume() : ready_for_samples();
  }
  return result;
}

template <class Index, class Normals, class Sweep>
PushResult Extractor<Index, Normals, Sweep>::push_row_of_bits(const uint8_t* bits) {
  const Status status = ready_for_samples();
  if (status != Status::ok) return {status, 0};
  if (rows_.column() != 0) return {Status::row_in_progress, 0};
  rows_.append_bits(bits);
  rows_.next_row();
  return {resume(), limits_.width};
}

template <class Index, class Normals, class Sweep>
PushResult Extractor<Index, Normals, Sweep>::skip_row(Substitute substitute) {
  const Status status = ready_for_samples();
  if (status != Status::ok) return {status, 0};
  if (intake_.column(rows_) != 0) return {Status::row_in_progress, 0};
  note(intake_.skip(rows_, substitute == Substitute::previous_row, threshold_));
  return {resume(), limits_.width};
}

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::resume() {
  if (state_ == State::idle) return Status::not_started;
  return work() ? Status::ok : Status::more;
}

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::finish() {
  if (state_ == State::scanning) {
    const bool is_between_slices = rows() == 0 || rows() == limits_.height;
    if (!is_between_slices || intake_.column(rows_) != 0) return Status::slice_in_progress;
    state_ = State::finishing;
  }
  return resume();
}

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::abandon() {
  if (state_ == State::scanning) {
    state_ = State::finishing;
    abandoned_ = true;
  }
  return resume();
}

// A row of bits whose samples never came is told before it is swept.
template <class Index, class Normals, class Sweep>
void Extractor<Index, Normals, Sweep>::note(Arrival arrival) {
  if (arrival == Arrival::nothing) return;
  skip_repeated_ = arrival == Arrival::repeated;
  skip_untold_ = true;
  ++statistics_.skipped_rows;
}

// ---- checkpoints ----

// Whether the sink has refused something that is due.
template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::is_suspended() const {
  return skip_untold_ || swept_rows_ < ready_rows() || rows_.rows() == limits_.height ||
         state_ == State::finishing;
}

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::save(Checkpoint<Extractor>& checkpoint) const {
  if (state_ == State::idle) return Status::not_started;
  if (is_suspended()) return Status::more;
  Extractor& image = checkpoint.object;
  image = *this;
  // Addresses are of no use to whoever restores it.
  image.sink_ = {};
  image.lay_out({});
  image.sweep_.forget();
  checkpoint.seal({memory_.data, bytes_used()});
  return Status::ok;
}

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::restore(const Checkpoint<Extractor>& checkpoint,
                                                 Memory memory, const Sink& sink) {
  const Extractor& image = checkpoint.object;
  if (memory.data == nullptr) return Status::too_little_memory;
  if (!checkpoint.is_whole(memory)) return Status::bad_checkpoint;
  if (sink.take == nullptr) return Status::bad_sink;
  if (memory.bytes < bytes_for<Index, Normals>(image.limits_, image.capacities_))
    return Status::too_little_memory;
  *this = image;
  return continue_in(memory, sink);
}

template <class Index, class Normals, class Sweep>
Status Extractor<Index, Normals, Sweep>::continue_in(Memory memory, const Sink& sink) {
  if (sink.take == nullptr) return Status::bad_sink;
  sink_ = sink;
  sweep_.fragments().set_at_seam(at_seam_of(limits_.slab));
  return lay_out(memory) ? Status::ok : Status::too_little_memory;
}

// ---- the sweep ----

// Does all that the rows at hand allow. False when the sink said "not now".
template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::work() {
  while (state_ != State::finished) {
    if (skip_untold_) {
      if (!tell(Event::Kind::skipped)) return false;
      skip_untold_ = false;
    }
    for (; swept_rows_ < ready_rows(); ++swept_rows_)
      if (!sweep_row()) return false;
    if (rows_.rows() == limits_.height && !end_slice()) return false;
    if (state_ == State::scanning) break;
    if (intake_.holds_rows(rows_))
      note(intake_.drain(rows_, threshold_));
    else if (swept_rows_ == ready_rows() && !end_scan())
      return false;
  }
  return true;
}

// The slice that is swept: the one before the slice that arrives, counted as slices are pushed.
template <class Index, class Normals, class Sweep>
int32_t Extractor<Index, Normals, Sweep>::middle_slice() const {
  return static_cast<int32_t>(rows_.slices()) - 1;
}

// Whether no slice follows the one that is swept.
template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::is_last_slice() const {
  return state_ == State::finishing && !intake_.holds_rows(rows_);
}

// Rows of the slice that is swept whose neighbours are there. Those of a closed border begin with
// the row before the first.
template <class Index, class Normals, class Sweep>
uint32_t Extractor<Index, Normals, Sweep>::ready_rows() const {
  const bool is_closed = limits_.border == Border::closed;
  const int32_t first_own = limits_.slab.continues_below ? 1 : is_closed ? -1 : 0;
  const int32_t first = Sweep::opens_seams && limits_.slab.continues_below ? 0 : first_own;
  if (middle_slice() < first) return 0;
  if (is_last_slice()) {
    // Nothing has come up to the slice above a slab that has no slices.
    if (limits_.slab.continues_above && middle_slice() == first_own) return 0;
    return limits_.height + (is_closed ? 1 : 0);
  }
  const uint32_t arrived = rows_.rows();
  if (arrived == limits_.height) return limits_.height + (is_closed ? 1 : 0);
  return is_closed || arrived == 0 ? arrived : arrived - 1;
}

// The rows of cells around row y that lie outside the volume (CellRowBits).
template <class Index, class Normals, class Sweep>
uint32_t Extractor<Index, Normals, Sweep>::rows_outside(int32_t y) const {
  if (limits_.border == Border::closed) return 0;
  uint32_t outside = 0;
  if (y == 0) outside |= trace::CellRowBits::front;
  if (y + 1 == static_cast<int32_t>(limits_.height)) outside |= trace::CellRowBits::back;
  if (middle_slice() == 0) outside |= trace::CellRowBits::below;
  if (is_last_slice()) outside |= trace::CellRowBits::above;
  return outside;
}

template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::sweep_row() {
  const bool is_open = limits_.border == Border::open;
  const bool is_above_slab = is_last_slice() && limits_.slab.continues_above;
  const bool is_below_slab =
      Sweep::opens_seams && limits_.slab.continues_below && middle_slice() == 0;
  const int32_t y = static_cast<int32_t>(swept_rows_) - (is_open ? 0 : 1);
  const int32_t z = middle_slice() + static_cast<int32_t>(limits_.slab.first) -
                    (limits_.slab.continues_below ? 1 : 0);
  trace::SweptRow row;
  rows_.find_around(y, row.rows);
  row.words = rows_.words();
  row.width = limits_.width;
  row.y = y;
  row.z = z;
  row.absent_rows = rows_outside(y) | (is_above_slab ? trace::CellRowBits::above : 0) |
                    (is_below_slab ? trace::CellRowBits::below : 0);
  row.has_open_ends = is_open;
  row.work = is_below_slab       ? trace::RowWork::open_seam
             : !is_above_slab    ? trace::RowWork::take_passes
             : chains_are_ended_ ? trace::RowWork::begin_chains
                                 : trace::RowWork::end_chains;
  row.set_missing();
  sweep_.fragments().set_below_is_lost(!Sweep::opens_seams && limits_.slab.continues_below &&
                                       middle_slice() == 1);
  // Above a slab the row is swept twice: as an end does not know where it is, the chains that come
  // up to a vertex are ended there, and those that go down from it begin there.
  for (;;) {
    if (!sweep_.sweep(row, intake_, sink_, statistics_)) return false;
    chains_are_ended_ = row.work == trace::RowWork::end_chains;
    if (!chains_are_ended_) break;
    row.work = trace::RowWork::begin_chains;
  }
  return true;
}

// Without those of context.
template <class Index, class Normals, class Sweep>
uint32_t Extractor<Index, Normals, Sweep>::own_slices() const {
  const uint32_t context =
      (limits_.slab.continues_below ? 1U : 0U) + (limits_.slab.continues_above ? 1U : 0U);
  return rows_.slices() > context ? rows_.slices() - context : 0;
}

template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::tell_start() {
  StreamHeader header;
  header.width = limits_.width;
  header.height = limits_.height;
  header.threshold = threshold_;
  header.border = limits_.border;
  intake_.tell_spacing(header.spacing_nm);
  Event event{};
  event.kind = Event::Kind::start;
  event.header = &header;
  return sink_.take(sink_.context, event) == Answer::taken;
}

// Offers an event that tells of rows and slices.
template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::tell(Event::Kind kind) {
  const uint32_t below = limits_.slab.continues_below ? 1 : 0;
  Event event{};
  event.kind = kind;
  event.slice = rows_.slices() + limits_.slab.first - below;
  event.row = rows_.rows() - 1;
  event.repeated = skip_repeated_;
  event.abandoned = abandoned_;
  event.statistics = &statistics_;
  if (kind == Event::Kind::finish) event.slice = own_slices();
  return sink_.take(sink_.context, event) == Answer::taken;
}

template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::end_slice() {
  if (!tell(Event::Kind::layer)) return false;
  rows_.next_slice();
  swept_rows_ = 0;
  return true;
}

template <class Index, class Normals, class Sweep>
bool Extractor<Index, Normals, Sweep>::end_scan() {
  if (!sweep_.settle_holes(sink_, statistics_)) return false;
  if (!tell(Event::Kind::finish)) return false;
  state_ = State::finished;
  return true;
}

}  // namespace discmc

#endif
