// What the functions of extractor.hpp do: included where Extractor is instantiated.
#ifndef DISCMC_EXTRACTOR_DEFINITIONS_HPP
#define DISCMC_EXTRACTOR_DEFINITIONS_HPP

#include <discmc/extractor.hpp>

namespace discmc {

template <class Index, class Normals>
Status Extractor<Index, Normals>::start(const Limits& limits, int32_t threshold, Memory memory,
                                        const Sink& sink, const PatchTable& table) {
  return start(limits, default_capacities<Index, Normals>(limits, memory.bytes), threshold, memory,
               sink, table);
}

template <class Index, class Normals>
Status Extractor<Index, Normals>::start(const Limits& limits, const Capacities& capacities,
                                        int32_t threshold, Memory memory, const Sink& sink,
                                        const PatchTable& table) {
  if (!limits.are_valid()) return Status::bad_limits;
  if (!are_valid<Index>(capacities)) return Status::bad_capacities;
  if (sink.take == nullptr) return Status::bad_sink;
  state_ = State::idle;
  limits_ = limits;
  capacities_ = capacities;
  sink_ = sink;
  threshold_ = threshold;
  if (!lay_out(memory, &table)) return Status::too_little_memory;
  state_ = State::scanning;
  return reset();
}

// Says what lies where in the memory, and writes nothing there. False when it has no room.
template <class Index, class Normals>
bool Extractor<Index, Normals>::lay_out(Memory memory, const PatchTable* table) {
  Arena arena(memory);
  rows_.start(arena, limits_);
  merge_.normals().start(arena, limits_);
  merge_.start(arena, limits_, capacities_, table, sink_.takes_fragments);
  used_ = arena.is_exhausted() ? Memory{} : Memory{memory.data, arena.used()};
  return used_.data != nullptr;
}

template <class Index, class Normals>
Status Extractor<Index, Normals>::reset() {
  if (state_ == State::idle) return Status::not_started;
  rows_.clear();
  merge_.normals().clear();
  merge_.clear();
  statistics_ = Statistics{};
  state_ = State::scanning;
  abandoned_ = false;
  skip_untold_ = false;
  cell_row_ = 0;
  word_begun_ = false;
  return Status::ok;
}

// ---- what the caller gives ----

template <class Index, class Normals>
Status Extractor<Index, Normals>::ready_for_samples() {
  if (state_ == State::idle) return Status::not_started;
  if (state_ != State::scanning) return Status::finished;
  if (!work()) return Status::more;
  if (arriving().slices() == Limits::max_slices) return Status::too_deep;
  return Status::ok;
}

template <class Index, class Normals>
template <class Sample>
Pushed Extractor<Index, Normals>::push(const Sample* samples, uint32_t count, uint32_t stride) {
  Pushed pushed{ready_for_samples(), 0};
  while (pushed.status == Status::ok && pushed.samples < count) {
    const uint32_t room = limits_.width - arriving().column();
    const uint32_t left = count - pushed.samples;
    const uint32_t taken = left < room ? left : room;
    take(samples + size_t{pushed.samples} * stride, taken, stride);
    pushed.samples += taken;
    const bool is_last = pushed.samples == count;
    pushed.status = is_last ? resume() : ready_for_samples();
  }
  return pushed;
}

template <class Index, class Normals>
Pushed Extractor<Index, Normals>::push_row_of_bits(const uint8_t* bits) {
  const Status status = ready_for_samples();
  if (status != Status::ok) return {status, 0};
  if (rows_.column() != 0) return {Status::row_in_progress, 0};
  rows_.append_bits(bits);
  rows_.next_row();
  return {resume(), limits_.width};
}

template <class Index, class Normals>
Pushed Extractor<Index, Normals>::skip_row(Substitute substitute) {
  const Status status = ready_for_samples();
  if (status != Status::ok) return {status, 0};
  if (arriving().column() != 0) return {Status::row_in_progress, 0};
  const bool is_repeated = substitute == Substitute::previous_row;
  if constexpr (Normals::hold_samples) {
    merge_.normals().skip(is_repeated, threshold_);
    if (merge_.normals().has_due_row()) pass_on();
  } else {
    if (is_repeated)
      rows_.repeat();
    else
      rows_.fill_off();
    rows_.next_row();
    note_skipped(is_repeated);
  }
  return {resume(), limits_.width};
}

template <class Index, class Normals>
Status Extractor<Index, Normals>::resume() {
  if (state_ == State::idle) return Status::not_started;
  return work() ? Status::ok : Status::more;
}

template <class Index, class Normals>
Status Extractor<Index, Normals>::finish() {
  if (state_ == State::scanning) {
    const bool between_slices = arriving().rows() == 0 || arriving().rows() == limits_.height;
    if (!between_slices || arriving().column() != 0) return Status::slice_in_progress;
    state_ = State::finishing;
  }
  return resume();
}

template <class Index, class Normals>
Status Extractor<Index, Normals>::abandon() {
  if (state_ == State::scanning) {
    state_ = State::finishing;
    abandoned_ = true;
  }
  return resume();
}

template <class Index, class Normals>
template <class Sample>
void Extractor<Index, Normals>::take(const Sample* samples, uint32_t count, uint32_t stride) {
  if constexpr (Normals::hold_samples) {
    merge_.normals().append(samples, count, stride);
    if (merge_.normals().has_due_row()) pass_on();
  } else {
    rows_.append(samples, count, stride, threshold_);
    if (rows_.row_is_complete()) rows_.next_row();
  }
}

// The samples of the last row of bits never came.
template <class Index, class Normals>
void Extractor<Index, Normals>::note_skipped(bool is_repeated) {
  skip_repeated_ = is_repeated;
  skip_untold_ = true;
  ++statistics_.skipped_rows;
}

// The row of samples that has waited longest becomes a row of bits.
template <class Index, class Normals>
void Extractor<Index, Normals>::pass_on() {
  if constexpr (Normals::hold_samples) {
    const auto row = merge_.normals().pass_on(rows_, threshold_);
    rows_.next_row();
    if (row.is_skipped) note_skipped(row.is_repeated);
  }
}

// ---- checkpoints ----

// Whether the sink has refused something that is due.
template <class Index, class Normals>
bool Extractor<Index, Normals>::is_suspended() const {
  return skip_untold_ || word_begun_ || rows_.rows() == limits_.height ||
         state_ == State::finishing;
}

template <class Index, class Normals>
Status Extractor<Index, Normals>::save(Checkpoint<Extractor>& checkpoint) const {
  if (state_ == State::idle) return Status::not_started;
  if (is_suspended()) return Status::more;
  Extractor& image = checkpoint.object;
  image = *this;
  // Where things lie is not for another day.
  image.sink_ = {nullptr, nullptr, sink_.takes_fragments};
  image.lay_out({}, nullptr);
  checkpoint.seal(used_);
  return Status::ok;
}

template <class Index, class Normals>
Status Extractor<Index, Normals>::restore(const Checkpoint<Extractor>& checkpoint, Memory memory,
                                          const Sink& sink, const PatchTable& table) {
  const Extractor& image = checkpoint.object;
  if (memory.data == nullptr) return Status::too_little_memory;
  if (!checkpoint.is_whole(memory)) return Status::bad_checkpoint;
  if constexpr (Normals::hold_samples)
    if (!image.merge_.normals().is_of_this_type()) return Status::bad_checkpoint;
  if (sink.take == nullptr || sink.takes_fragments != image.sink_.takes_fragments)
    return Status::bad_sink;
  *this = image;
  sink_ = sink;
  lay_out(memory, &table);  // there is room, as there was then
  return Status::ok;
}

// ---- the sweep, which may be suspended between any two cells ----

// Does all that the rows at hand allow. False when the sink said "not now".
template <class Index, class Normals>
bool Extractor<Index, Normals>::work() {
  if (state_ == State::finished) return true;
  for (;;) {
    if (skip_untold_ && !tell_skipped()) return false;
    if (!sweep_ready_rows()) return false;
    if (rows_.rows() == limits_.height && !end_slice()) return false;
    if (state_ == State::scanning) return true;
    if (is_last_layer() && cell_row_ == ready_rows()) return end_scan();
    if (!is_last_layer()) add_last_row();
  }
}

// After the last sample: the rows that an abandoned slice lacks are off, and rows that wait come
// in.
template <class Index, class Normals>
void Extractor<Index, Normals>::add_last_row() {
  if constexpr (Normals::hold_samples) {
    const bool is_slice_begun = arriving().rows() > 0 || arriving().column() > 0;
    if (is_slice_begun) merge_.normals().fill_off(threshold_);
    // In the first slice a row that passed now would go before the row after it had come.
    if (!is_slice_begun || merge_.normals().has_due_row()) pass_on();
  } else {
    rows_.fill_off();
    rows_.next_row();
  }
}

// The layer above the last slice, which finish() and abandon() add.
template <class Index, class Normals>
bool Extractor<Index, Normals>::is_last_layer() const {
  if (state_ != State::finishing || rows_.rows() > 0 || rows_.column() > 0) return false;
  if constexpr (Normals::hold_samples)
    return !merge_.normals().has_rows();
  else
    return true;
}

// Rows of cells of the current layer whose four rows of voxels are there.
template <class Index, class Normals>
uint32_t Extractor<Index, Normals>::ready_rows() const {
  const bool closed = limits_.border == Border::closed;
  if (is_last_layer()) return limits_.cell_rows();
  if (!closed && rows_.slices() == 0) return 0;
  if (rows_.rows() == limits_.height) return limits_.cell_rows();
  if (closed) return rows_.rows();
  return rows_.rows() > 0 ? rows_.rows() - 1 : 0;
}

template <class Index, class Normals>
bool Extractor<Index, Normals>::sweep_ready_rows() {
  const uint32_t ready = ready_rows();
  while (cell_row_ < ready) {
    if (!sweep_row()) return false;
    ++cell_row_;
  }
  return true;
}

template <class Index, class Normals>
bool Extractor<Index, Normals>::sweep_row() {
  const uint32_t words = rows_.words();
  const RowQuad quad = rows_.around(static_cast<int32_t>(cell_row_ - limits_.halo()));
  if (!word_begun_) word_ = skip_off(quad, 0, words);
  if (word_ == words) return true;
  const uint32_t columns = limits_.columns();
  const int32_t z = 2 * (static_cast<int32_t>(rows_.slices()) - 1);
  const bool seals = is_last_layer() && limits_.border == Border::open;
  for (; word_ * 32 < columns; word_ = skip_off(quad, word_ + 1, words)) {
    if (!word_begun_) {
      const uint32_t cells = columns - word_ * 32;
      active_ = active_cells(quad, word_, words);
      if (cells < 32) active_ &= (uint32_t{1} << cells) - 1;
      word_begun_ = true;
    }
    for (;;) {
      if (!merge_.settled() && !merge_.settle(sink_, statistics_)) return false;
      if (active_ == 0) break;
      const uint32_t bit = static_cast<uint32_t>(__builtin_ctz(active_));
      active_ &= active_ - 1;
      visit({word_ * 32 + bit, cell_row_, z, seals, configuration_at(quad, word_, bit)});
    }
    word_begun_ = false;
  }
  return true;
}

template <class Index, class Normals>
void Extractor<Index, Normals>::visit(const Cell& cell) {
  const CellCounts counts = merge_.take_cell(cell);
  if (cell.seals) return;
  ++statistics_.cells;
  statistics_.facets += counts.facets;
  statistics_.classic_triangles += counts.classic_triangles;
}

// Offers an event that tells of rows and slices.
template <class Index, class Normals>
bool Extractor<Index, Normals>::tell(Event::Kind kind) {
  Event event{};
  event.kind = kind;
  event.slice = rows_.slices();
  event.row = rows_.rows() - 1;
  event.repeated = skip_repeated_;
  event.abandoned = abandoned_;
  event.statistics = &statistics_;
  return sink_.take(sink_.context, event) == Answer::taken;
}

template <class Index, class Normals>
bool Extractor<Index, Normals>::tell_skipped() {
  if (!tell(Event::Kind::skipped)) return false;
  skip_untold_ = false;
  return true;
}

template <class Index, class Normals>
bool Extractor<Index, Normals>::end_slice() {
  if (!tell(Event::Kind::layer)) return false;
  rows_.next_slice();
  cell_row_ = 0;
  return true;
}

template <class Index, class Normals>
bool Extractor<Index, Normals>::end_scan() {
  if (!tell(Event::Kind::finish)) return false;
  state_ = State::finished;
  return true;
}

}  // namespace discmc

#endif
