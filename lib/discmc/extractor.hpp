// The extractor: samples in, regions out. The one class that firmware meets.
//
//   start(limits, threshold, memory, sink)
//   push(samples, count)      as often as samples arrive, any number at a time
//   resume()                  after Status::more, when the sink may take again
//   finish()                  after the last slice
//
// The work happens inside push(), resume() and finish(), never more than the rows given ask for.
// Nothing is allocated, nothing is kept but the caller's memory and the object itself.
#ifndef DISCMC_EXTRACTOR_HPP
#define DISCMC_EXTRACTOR_HPP

#include <discmc/checkpoint.hpp>
#include <discmc/merge.hpp>
#include <discmc/slice.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// What stands in for a row that never came.
enum class Substitute : uint8_t { off, previous_row };

/// What push() came to, and how many of the samples it took. The rest must be pushed again.
struct [[nodiscard]] Pushed {
  Status status;
  uint32_t samples;
};

/// Index is uint16_t (edges and regions together, runs, and rings: fewer than 65,535 each;
/// firmware) or uint32_t (hosts). The events do not depend on it, given the same capacities.
/// Normals is NoNormals, or GradientNormals<Sample>: then push() takes samples of this type alone,
/// keeps those of three slices and two rows in the memory, and sweeps a slice later; the events are
/// the same but for the normals in them.
template <class Index, class Normals = NoNormals>
class Extractor {
 public:
  /// Begins a scan with the default split of the memory (default_capacities()).
  /// threshold: a voxel is on where its sample is >= threshold.
  /// memory: at least minimum_bytes<Index, Normals>(limits); Owner: the caller, for as long as the
  /// scan lasts. Errors: bad_limits, bad_sink, too_little_memory; then memory is untouched. Cost:
  /// one write a word of the hash table and of one row.
  [[nodiscard]] Status start(const Limits& limits, int32_t threshold, Memory memory,
                             const Sink& sink, const PatchTable& table = patch_table);

  /// The same with explicit capacities: memory of at least
  /// bytes_for<Index, Normals>(limits, capacities).
  /// Errors: also bad_capacities.
  [[nodiscard]] Status start(const Limits& limits, const Capacities& capacities, int32_t threshold,
                             Memory memory, const Sink& sink,
                             const PatchTable& table = patch_table);

  /// Tells how far apart voxels are, for the normals of the scans to come, until told otherwise:
  /// without it voxels are cubes. It is not told to the stream: StreamHeader::spacing_nm has to say
  /// the same. spacing: negative where an axis is mirrored; Units: any. Limit: GradientNormals, and
  /// not during a scan, whose normals would differ from then on.
  template <class N = Normals>
  void set_spacing(const int32_t (&spacing)[3]) {
    static_assert(N::hold_samples, "an extractor without normals has no use for the spacing");
    merge_.normals().set_weights(axis_weights(spacing));
  }

  /// Begins the next scan with the limits, threshold, memory and sink of the last start().
  [[nodiscard]] Status reset();

  /// Takes samples of consecutive voxels, rows and slices in x, y, z order. Calls may end anywhere.
  /// samples: Owner: the caller; free again when the call returns. stride: from one sample to the
  /// next, in samples. Errors: not_started, finished, too_deep.
  /// With Status::more all samples up to the end of the row that caused it have been taken.
  /// Sample is uint8_t, uint16_t or int16_t. Cost: a comparison a sample; a completed row also
  /// sweeps its row of cells (DESIGN.md, "Work").
  template <class Sample>
  Pushed push(const Sample* samples, uint32_t count, uint32_t stride = 1);

  /// Takes a whole row that is thresholded already: eight voxels a byte, the first in bit 0.
  /// Errors: as push(), row_in_progress. Pushed::samples is the width when the row was taken, else
  /// 0. Limit: NoNormals.
  template <class N = Normals>
  Pushed push_bits(const uint8_t* bits) {
    static_assert(!N::hold_samples, "bits have no gradient: push samples");
    return push_row_of_bits(bits);
  }

  /// Stands in for a row that never came; the sink is told. Result and errors: as push_bits().
  Pushed skip_row(Substitute substitute);

  /// Goes on after Status::more. Also harmless at any other time.
  [[nodiscard]] Status resume();

  /// Ends the scan: delivers every region and the totals. Errors: not_started, slice_in_progress.
  /// After Status::more go on with resume(). Calling it again is harmless.
  [[nodiscard]] Status finish();

  /// Ends the scan wherever it is: the rest of the slice is taken as off, so the surface is closed
  /// all the same, and the sink is told. Errors: not_started. Status::more as finish().
  [[nodiscard]] Status abandon();

  /// Writes down where the scan is; with the first bytes_used() bytes of the memory that is all of
  /// it. Errors: not_started. Status::more: resume() first. Cost: a checksum of those bytes.
  [[nodiscard]] Status save(Checkpoint<Extractor>& checkpoint) const;

  /// Goes on where a checkpoint was saved. memory: as it was then, though it may lie elsewhere, as
  /// far from a multiple of four bytes; Owner: as of start(). sink: one that takes_fragments as the
  /// one of then did. Errors: too_little_memory (none), bad_checkpoint, bad_sink. Cost: as save().
  [[nodiscard]] Status restore(const Checkpoint<Extractor>& checkpoint, Memory memory,
                               const Sink& sink, const PatchTable& table = patch_table);

  /// Totals so far, and all of them once the scan is finished.
  Statistics statistics() const { return statistics_; }
  const Limits& limits() const { return limits_; }
  const Capacities& capacities() const { return capacities_; }
  HighWater high_water() const { return merge_.high_water(); }
  /// The bytes of the caller's memory that are laid out: bytes_for() these capacities.
  size_t bytes_used() const { return used_.bytes; }
  /// Complete slices so far.
  uint32_t slices() const { return arriving().slices(); }
  /// Complete rows of the current slice so far.
  uint32_t rows() const { return arriving().rows(); }

 private:
  enum class State : uint8_t { idle, scanning, finishing, finished };

  // What the samples go into first.
  const auto& arriving() const {
    if constexpr (Normals::hold_samples)
      return merge_.normals();
    else
      return rows_;
  }

  Pushed push_row_of_bits(const uint8_t* bits);
  bool lay_out(Memory memory, const PatchTable* table);
  bool is_suspended() const;
  Status ready_for_samples();
  template <class Sample>
  void take(const Sample* samples, uint32_t count, uint32_t stride);
  void pass_on();
  void note_skipped(bool is_repeated);
  bool work();
  bool sweep_ready_rows();
  bool sweep_row();
  void visit(const Cell& cell);
  uint32_t ready_rows() const;
  bool end_slice();
  bool end_scan();
  void add_last_row();
  bool is_last_layer() const;
  bool tell(Event::Kind kind);
  bool tell_skipped();

  // What the sweep works with stands first, where it is reached by short instructions.
  State state_ = State::idle;
  bool abandoned_ = false;
  bool skip_untold_ = false;
  bool skip_repeated_ = false;
  // Where the sweep of the current layer is: the next row of cells, the word of its bits, and the
  // active cells of that word still to visit.
  bool word_begun_ = false;
  uint32_t cell_row_ = 0;
  uint32_t word_ = 0;
  uint32_t active_ = 0;

  int32_t threshold_ = 0;
  Limits limits_{};
  Sink sink_{nullptr, nullptr, false};
  BitRows rows_;
  Statistics statistics_{};
  Merge<Index, Normals> merge_;
  Capacities capacities_{};
  Memory used_;  // of the caller's memory
};

#define DISCMC_DECLARE(Index)                                        \
  extern template class Extractor<Index>;                            \
  extern template class Extractor<Index, GradientNormals<uint8_t>>;  \
  extern template class Extractor<Index, GradientNormals<uint16_t>>; \
  extern template class Extractor<Index, GradientNormals<int16_t>>;

DISCMC_DECLARE(uint16_t)
DISCMC_DECLARE(uint32_t)
#undef DISCMC_DECLARE

using Extractor16 = Extractor<uint16_t>;
using Extractor32 = Extractor<uint32_t>;

}  // namespace discmc

#endif
