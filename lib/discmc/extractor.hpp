// The extractor: samples in, regions out. The one class that firmware meets.
//
//   start(limits, threshold, memory, sink)
//   push(samples, count)      as often as samples arrive, any number at a time
//   resume()                  after Status::suspended, when the sink may take again
//   finish()                  after the last slice
//
//            start()            finish(), abandon()                 the sink has taken
//   idle ------------> scanning --------------------> finishing ---------------------> finished
//                         ^  | push(), skip_row(), resume()                               |
//                         |__|___________________________ reset() ________________________|
//
// Each call does only the work that its rows require. Nothing is allocated, nothing is kept but the
// caller's memory and the object itself.
#ifndef DISCMC_EXTRACTOR_HPP
#define DISCMC_EXTRACTOR_HPP

#include <discmc/capacities.hpp>
#include <discmc/checkpoint.hpp>
#include <discmc/row_input.hpp>
#include <discmc/trace/sweep.hpp>

namespace discmc {

/// High-water marks. Units: as Capacities.
struct HighWater {
  uint32_t slots;
  uint32_t holes;
};

/// What every extractor does: takes the samples of a scan, and hands its regions to a Sink. Use
/// Extractor, NormalExtractor (gradient_normals.hpp) or HostExtractor (host/host_extractor.hpp).
/// Index is uint16_t (up to 32,759 slots; firmware) or uint32_t (hosts). The events do not depend
/// on it, given the same capacities. An extractor is neither copied nor moved, but by save() and
/// restore(): two would write to the same memory.
template <class Index, class Intake, class Sweep>
class BasicExtractor {
  static_assert(is_index<Index>, "an index must be uint16_t or uint32_t");

 public:
  BasicExtractor() = default;

  /// Begins a scan with as many slots as the memory has room for (default_capacities()).
  /// threshold: a voxel is on where its sample is >= threshold.
  /// memory: at least minimum_bytes<Index>(limits); Owner: the caller, for as long as the
  /// scan lasts. Errors: bad_limits (also those that need a feature that was left out), bad_sink
  /// (also a sink that does not take the start of the scan, such as an encoder that was not
  /// started), too_little_memory; then memory is untouched. Cost: a write for each queue, and for
  /// each word of a row.
  [[nodiscard]] Status start(const Limits& limits, int32_t threshold, Memory memory,
                             const Sink& sink) {
    return start(limits, default_capacities<Index, Intake>(limits, memory.bytes), threshold, memory,
                 sink);
  }

  /// The same with explicit capacities: memory of at least bytes_for<Index>(limits, capacities).
  /// Errors: also bad_capacities.
  [[nodiscard]] Status start(const Limits& limits, const Capacities& capacities, int32_t threshold,
                             Memory memory, const Sink& sink);

  /// Begins the next scan with the limits, threshold, memory and sink of the last start(). Errors:
  /// not_started, bad_sink (it does not take the start of the scan).
  [[nodiscard]] Status reset();

  /// Takes samples of consecutive voxels, rows and slices in x, y, z order. Calls may end anywhere.
  /// samples: Owner: the caller; free again when the call returns. stride: from one sample to the
  /// next, in samples. Errors: not_started, finished, too_deep.
  /// With Status::suspended all samples up to the end of the row that caused it have been taken.
  /// Sample is uint8_t, uint16_t or int16_t. Cost: a comparison a sample; a completed row also
  /// sweeps a row of the slice below (DESIGN.md, "Work").
  template <class Sample>
  PushResult push(const Sample* samples, uint32_t count, uint32_t stride = 1) {
    static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");
    static_assert(!Intake::holds_samples || Intake::type == sample_type<Sample>,
                  "samples must be of the type that the normals are made of");
    return push_samples(samples, count, stride);
  }

  /// Takes a whole row that is thresholded already: eight voxels a byte, the first in bit 0.
  /// Errors: as push(), row_in_progress. PushResult::samples is the width when the row was taken,
  /// else 0.
  PushResult push_bits(const uint8_t* bits);

  /// Stands in for a row that never came; the sink is told. Result and errors: as push_bits().
  PushResult skip_row(Substitute substitute);

  /// Goes on after Status::suspended; the sink may say "not now" again, then it is
  /// Status::suspended again. Harmless at any other time. Errors: not_started.
  [[nodiscard]] Status resume();

  /// Ends the scan: delivers every region and the totals. Errors: not_started, slice_in_progress.
  /// After Status::suspended go on with resume(). Calling it again is harmless.
  [[nodiscard]] Status finish();

  /// Ends the scan wherever it is: the rest of the slice is taken as off, so the surface is closed
  /// all the same, and the sink is told. Errors: not_started. Status::suspended as finish().
  [[nodiscard]] Status abandon();

  /// Writes down where the scan is; with the first bytes_used() bytes of the memory that is all of
  /// it. Any: the type of this extractor. Errors: not_started. Status::suspended: resume() first.
  /// Cost: a checksum of those bytes.
  template <class Any>
  [[nodiscard]] Status save(Checkpoint<Any>& checkpoint) const;

  /// Goes on where a checkpoint was saved. memory: as many bytes as start() was given, the first
  /// ones as they were then; it may lie elsewhere, with the same alignment modulo 4; Owner: as of
  /// start(). Errors: too_little_memory, bad_checkpoint, bad_sink. Cost: as save().
  template <class Any>
  [[nodiscard]] Status restore(const Checkpoint<Any>& checkpoint, Memory memory, const Sink& sink);

  /// Goes on as restore() does, where the bytes of this object itself have been read back, with
  /// those of the memory: for objects that are saved where they lie, as those of C. Limit: they are
  /// as they were. Errors: bad_sink, too_little_memory.
  [[nodiscard]] Status continue_in(Memory memory, const Sink& sink);

  /// Whether the sink has refused something that is due: then resume() before save().
  bool is_suspended() const;

  /// Totals so far, and all of them once the scan is finished.
  const Statistics& statistics() const { return statistics_; }
  Limits limits() const {
    return {width_, height_, border_, {first_slice_, continues_below_, continues_above_}};
  }
  const Capacities& capacities() const { return capacities_; }
  HighWater high_water() const {
    return {sweep_.fragments().slots().high_water(), sweep_.delivery().holes().high_water()};
  }
  /// So many bytes at the beginning of the caller's memory the scan has used so far: nothing behind
  /// them has been written.
  size_t bytes_used() const;
  /// Complete slices so far, and complete rows of the current one.
  uint32_t slices() const { return intake_.slices(bits_); }
  uint32_t rows() const { return intake_.rows(bits_); }

  /// Of what a checkpoint holds: see CheckpointHead.
  static constexpr uint32_t layout = sizeof(Index) | sizeof(void*) << 4 | Intake::type << 8;

 protected:
  BasicExtractor(const BasicExtractor&) = default;
  BasicExtractor& operator=(const BasicExtractor&) = default;

  Intake& intake() { return intake_; }
  Sweep& sweep() { return sweep_; }

 private:
  using Features = typename Sweep::Features;

  enum class State : uint8_t { idle, scanning, finishing, finished };

  template <class Sample>
  PushResult push_samples(const Sample* samples, uint32_t count, uint32_t stride);
  static bool can_scan(const Limits& limits);
  bool is_open() const { return Features::open_border && border_ == Border::open; }
  bool continues_below() const { return Features::slabs && continues_below_; }
  bool continues_above() const { return Features::slabs && continues_above_; }
  uint32_t first_slice() const { return Features::slabs ? first_slice_ : 0; }
  bool lay_out(const Limits& limits, Memory memory);
  void forget_addresses();
  void clear();
  Status ready_for_samples();
  void note_origin(RowOrigin origin);

  bool work();
  uint32_t rows_outside(int32_t y) const;
  trace::SlabRole slab_role() const;
  bool sweep_row();
  int32_t middle_slice() const;
  uint32_t ready_rows() const;
  bool is_last_slice() const;
  bool end_slice();
  bool end_scan();
  uint32_t own_slices() const;
  bool send_start();
  bool send(Event::Kind kind);

  // What the sweep works with stands first, where it is reached by short instructions.
  State state_ = State::idle;
  bool abandoned_ = false;
  bool skip_is_due_ = false;
  bool skip_repeated_ = false;
  Border border_ = Border::closed;
  bool continues_below_ = false;  // of the slab
  bool continues_above_ = false;
  uint32_t swept_rows_ = 0;  // of the middle slice
  int32_t threshold_ = 0;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t first_slice_ = 0;  // of the slab
  Sink sink_;
  Intake intake_;
  trace::BitRows bits_;
  Sweep sweep_;
  Statistics statistics_{};
  Capacities capacities_{};
  Memory memory_;
};

/// The extractor of firmware, and of hosts that want no more. The library has those with all
/// features; a program that chooses its own includes discmc/trace/extractor_definitions.hpp. The
/// compiler then inlines more, because it sees which functions are called.
template <class Index, class Features = AllFeatures>
class Extractor : public BasicExtractor<Index, BitIntake, trace::Sweep<Index, NoNormal, Features>> {
 public:
  Extractor() = default;

 private:
  friend struct Checkpoint<Extractor>;
  Extractor(const Extractor&) = default;
  Extractor& operator=(const Extractor&) = default;
};

using Extractor16 = Extractor<uint16_t>;
using Extractor32 = Extractor<uint32_t>;

}  // namespace discmc

#endif
