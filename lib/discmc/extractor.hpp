// The extractor: samples in, regions out. The central class of the firmware.
//
//   start(limits, threshold, memory, sink)
//   push(samples, count)      as often as samples arrive, any number at a time
//   resume()                  after Status::suspended, when the sink is ready again
//   finish()                  after the last slice
//
//            start()            finish(), abandon()                the sink accepted all
//   idle ------------> scanning --------------------> finishing ---------------------> finished
//                         ^  | push(), skip_row(), resume()                               |
//                         |__|___________________________ reset() ________________________|
//
// start() works in every state, reset() in every state except idle. Each call does only the work
// that its rows require. The extractor allocates nothing, and stores its state only in the object
// and in the caller's memory.
#ifndef DISCMC_EXTRACTOR_HPP
#define DISCMC_EXTRACTOR_HPP

#include <discmc/capacities.hpp>
#include <discmc/checkpoint.hpp>
#include <discmc/row_input.hpp>
#include <discmc/trace/sweep.hpp>

namespace discmc {

/// An extractor, by the type that numbers its slots. Declare one of these; BasicExtractor below has
/// the functions.
template <class Index, bool is_lean = false>
class Extractor;

/// For firmware: up to 32,759 slots.
using Extractor16 = Extractor<uint16_t>;
/// For hosts. The events are those of an Extractor16 if the capacities are equal.
using Extractor32 = Extractor<uint32_t>;
/// Needs less flash (FOOTPRINT.md): no open border, no slabs, no counts of cells, facets and
/// classic triangles. Each hole is a loose fragment, so use a Joiner. Include
/// discmc/trace/extractor_definitions.hpp where you use it: the library does not contain its code.
using LeanExtractor16 = Extractor<uint16_t, true>;

/// The peak use of a scan: the most slots and holes in use at once. With 1,168 slots more than
/// that, the same scan sends no loose fragments (docs/memory.md).
struct Peaks {
  uint32_t slots;
  uint32_t holes;
};

/// The functions that all extractors have, also a NormalExtractor (normal_extractor.hpp): an
/// extractor accepts the samples of a scan, and sends its regions to a Sink. Intake and Sweep are
/// internal. An extractor is not copied, as two copies would write to the same memory.
template <class Index, class Intake, class Sweep>
class BasicExtractor {
  static_assert(is_index<Index>, "an index must be uint16_t or uint32_t");

 public:
  /// The least memory of start(): the surface is complete, but sent in loose fragments of a few
  /// links. Limit: valid limits, as for the next two.
  static constexpr uint64_t minimum_bytes(const Limits& limits) {
    return detail::sizing::minimum_bytes<Index, Intake>(limits);
  }
  /// The memory for these capacities.
  static constexpr uint64_t bytes_for(const Limits& limits, const Capacities& capacities) {
    return detail::sizing::bytes_for<Index, Intake>(limits, capacities);
  }
  /// The capacities that start() chooses for this many bytes: as many slots as fit, of which
  /// waiting holes may use an eighth. Below minimum_bytes() they are the minimum. More bytes never
  /// reduce a capacity.
  static constexpr Capacities default_capacities(const Limits& limits, uint64_t bytes) {
    return detail::sizing::default_capacities<Index, Intake>(limits, bytes);
  }

  BasicExtractor() = default;

  /// Begins a scan. All memory beyond the least becomes slots: see default_capacities().
  ///
  /// threshold: a voxel is on if its sample is >= threshold. memory: at least
  /// minimum_bytes(limits), at any alignment; Owner: the caller, for as long as the scan lasts.
  /// Status::suspended: the scan has begun, but the sink is busy. Errors: bad_limits (also for
  /// an open border or a slab in a lean extractor), too_little_memory, bad_sink (no function, or a
  /// sink that has not started). After an error the memory is untouched; after too_little_memory,
  /// or if the sink has not started, the previous scan has ended. Cost: clears about 150 words and
  /// one row of bits.
  [[nodiscard]] Status start(const Limits& limits, int32_t threshold, Memory memory,
                             const Sink& sink) {
    return start(limits, default_capacities(limits, memory.bytes), threshold, memory, sink);
  }

  /// With explicit capacities. memory: at least bytes_for(limits, capacities). Errors: also
  /// bad_capacities.
  [[nodiscard]] Status start(const Limits& limits, const Capacities& capacities, int32_t threshold,
                             Memory memory, const Sink& sink);

  /// Begins the next scan with the limits, threshold, memory and sink of the last start(). An
  /// unfinished scan is dropped without a `finish` event. Status::suspended: as start(). Errors:
  /// not_started; bad_sink (the sink has not started), after which nothing has changed.
  [[nodiscard]] Status reset();

  /// Accepts samples of consecutive voxels: x first, then y, then z. A call may begin and end
  /// anywhere in a row. samples: `count` samples that are `stride` samples apart; Owner: the
  /// caller; free again when the call returns. Sample is uint8_t, uint16_t or int16_t.
  ///
  /// Status::suspended: the sink is busy, and PushResult::samples samples are accepted, up to the
  /// end of a row. Call resume() until it returns another status, then push the remaining samples.
  /// Errors: not_started, finished, too_many_slices. Cost: one comparison per sample. A completed
  /// row also extracts the surface of a row of the slice below (DESIGN.md, "Work").
  template <class Sample>
  PushResult push(const Sample* samples, uint32_t count, uint32_t stride = 1) {
    static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");
    static_assert(!Intake::holds_samples || Intake::type == sample_type<Sample>,
                  "samples must be of the type that the normals are made of");
    return push_samples(samples, count, stride);
  }

  /// Accepts a whole row that you thresholded. bits: (width + 7) / 8 bytes, eight voxels per byte,
  /// the first in bit 0; bits beyond the width are ignored; Owner: as of push(). The row is
  /// accepted if PushResult::samples is the width, even with Status::suspended; otherwise samples
  /// is 0. Errors: as push(), row_in_progress.
  PushResult push_bits(const uint8_t* bits);

  /// Replaces a missing row; the sink receives a `skipped` event. Result and errors: as
  /// push_bits().
  PushResult skip_row(Substitute substitute);

  /// Continues after Status::suspended, and returns it again if the sink is still busy. Does
  /// nothing at any other time. Errors: not_started.
  [[nodiscard]] Status resume();

  /// Ends the scan: delivers every region and the totals. Errors: not_started, slice_in_progress.
  /// After Status::suspended call resume(). A second call is harmless.
  [[nodiscard]] Status finish();

  /// Ends the scan anywhere: the rest of the slice counts as off, so with Border::closed the
  /// surface is closed. The `finish` event has `is_abandoned` set. Errors: not_started.
  /// Status::suspended: as finish().
  [[nodiscard]] Status abandon();

  /// Seals the extractor's state, and sets parts[0] and parts[1] to its bytes: the object, and the
  /// first bytes_used() bytes of the memory. Copy them before the next call (checkpoint.hpp).
  /// Status::suspended: call resume() first. Errors: not_started. Cost: a checksum of both, about
  /// 50 instructions per byte.
  [[nodiscard]] Status save(Memory* parts);

  /// Continues from the parts of save(), which were read back into this object and into the
  /// beginning of the memory. memory: of the size given to start(); it may lie at another address
  /// that is the same modulo 4; Owner: as of start(). Errors: bad_checkpoint (also if the memory is
  /// smaller than it was used), too_little_memory, bad_sink. After an error read the parts back
  /// again, or call start(). Cost: as save().
  [[nodiscard]] Status restore(Memory memory, const Sink& sink);

  /// Whether the sink has refused an event that is due. If so, call resume() before save().
  bool is_suspended() const;

  /// The totals so far; final when the scan is finished.
  const Statistics& statistics() const { return statistics_; }
  Limits limits() const {
    return {width_, height_, border_, {first_slice_, continues_below_, continues_above_}};
  }
  const Capacities& capacities() const { return capacities_; }
  /// The peak use so far.
  Peaks peaks() const {
    return {sweep_.fragments().slots().peak(), sweep_.delivery().holes().peak()};
  }
  /// The number of bytes at the beginning of the caller's memory that the scan has used so far. No
  /// later byte was written.
  size_t bytes_used() const;
  /// The number of complete slices that were pushed, with the context slice of a slab.
  uint32_t slices() const { return intake_.slices(bits_); }
  /// The number of complete rows of the current slice, 0 to height - 1.
  uint32_t rows() const { return intake_.rows(bits_); }

  /// Differs between the types of extractors and between builds; for discmc.h.
  static constexpr uint32_t layout = sizeof(Index) | sizeof(void*) << 4 | Intake::type << 8;

 protected:
  BasicExtractor(const BasicExtractor&) = default;
  BasicExtractor& operator=(const BasicExtractor&) = default;

  Intake& intake() { return intake_; }
  Sweep& sweep() { return sweep_; }

 private:
  static constexpr bool is_lean = Sweep::is_lean;

  enum class State : uint8_t { idle, scanning, finishing, finished };
  /// The event that precedes the sweep: of the scan, or of a row without samples.
  enum class Due : uint8_t { nothing, start, off_row, repeated_row };

  template <class Sample>
  PushResult push_samples(const Sample* samples, uint32_t count, uint32_t stride);
  static bool can_scan(const Limits& limits);
  bool is_open() const { return !is_lean && border_ == Border::open; }
  bool continues_below() const { return !is_lean && continues_below_; }
  bool continues_above() const { return !is_lean && continues_above_; }
  uint32_t first_slice() const { return is_lean ? 0 : first_slice_; }
  bool lay_out(const Limits& limits, Memory memory);
  Status begin();
  void clear();
  Status ready_for_samples();
  void note_origin(detail::trace::RowOrigin origin);

  bool work();
  uint32_t rows_outside(int32_t y) const;
  detail::trace::SlabRole slab_role() const;
  bool sweep_row();
  int32_t middle_slice() const;
  uint32_t ready_rows() const;
  bool is_last_slice() const;
  bool end_slice();
  bool end_scan();
  uint32_t own_slices() const;
  SinkResult send_start();
  bool send_due();
  bool send(Event::Kind kind);

  // The members that the sweep uses come first, within reach of short instructions.
  State state_ = State::idle;
  bool is_abandoned_ = false;
  Due due_ = Due::nothing;
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
  detail::trace::BitRows bits_;
  Sweep sweep_;
  Statistics statistics_{};
  Capacities capacities_{};
  Memory memory_;
  detail::Seal seal_;
};

/// The extractor without normals. Include discmc/trace/extractor_definitions.hpp to let the
/// compiler inline more.
template <class Index, bool is_lean>
class Extractor
    : public BasicExtractor<Index, detail::trace::BitIntake,
                            detail::trace::Sweep<Index, detail::trace::NoNormal, is_lean>> {
 public:
  Extractor() = default;

 private:
  Extractor(const Extractor&) = default;
  Extractor& operator=(const Extractor&) = default;
};

}  // namespace discmc

#endif
