// Gradient normals in the first pass: an extractor that tells with every run the normal where it
// starts.
//
//   using Normals = GradientNormals<uint8_t>;           // of the samples' type
//   static uint8_t memory[minimum_bytes<uint16_t, Normals>(limits) + 24 * 1024];
//   static Extractor<uint16_t, Normals> extractor;      // used like any other
//   static NormalEncoder encoder;                       // and an Encoder leaves them out
//   extractor.set_spacing(header.spacing_nm);           // before start(), unless voxels are cubes
//
// It keeps the samples of three slices and two rows, and lets every row wait for a slice: row y of
// slice k becomes bits when row y of slice k + 1 is there, so that samples on all sides are at hand
// where the sweep is. A normal is made when the second of the two links of a corner is known, and
// kept with the run that starts there; what becomes the middle of a side never has one.
#ifndef DISCMC_GRADIENT_NORMALS_HPP
#define DISCMC_GRADIENT_NORMALS_HPP

#include <discmc/sample_rows.hpp>
#include <discmc/slice.hpp>

namespace discmc {

/// The samples and where in them the sweep is: its functions are for the extractor to call. Sample
/// is uint8_t, uint16_t or int16_t.
template <class Sample>
class GradientNormals {
 public:
  static constexpr bool hold_samples = true;
  using Normal = OctahedralNormal;

  static constexpr uint32_t ring_rows(const Limits& limits) { return 3 * limits.height + 2; }
  static constexpr uint64_t bytes_for(const Limits& limits) {
    return SampleRows<Sample>::bytes_for(limits, ring_rows(limits)) +
           Arena::bytes_of(ring_rows(limits), sizeof(uint16_t));
  }
  /// Takes bytes_for(limits) from the arena, and writes nothing.
  void start(Arena& arena, const Limits& limits) {
    samples_.start(arena, limits, ring_rows(limits));
    given_ = arena.take<uint16_t>(ring_rows(limits));
    width_ = limits.width;
    height_ = limits.height;
  }
  void clear() {
    samples_.clear();
    waiting_ = 0;
  }

  /// Whether the bytes of this object were one of this class, as those of a checkpoint should be.
  bool is_of_this_type() const { return type_ == type; }

  /// How the normals are bent where voxels are not cubes.
  void set_weights(const AxisWeights& weights) { weights_ = weights; }

  /// Where the samples that arrive are: as SampleRows.
  uint32_t column() const { return samples_.column(); }
  uint32_t rows() const { return samples_.rows(); }
  uint32_t slices() const { return samples_.slices(); }

  /// Appends samples to the row that arrives. Limit: count <= width - column().
  void append(const Sample* samples, uint32_t count, uint32_t stride) {
    samples_.append(samples, count, stride);
    if (samples_.row_is_complete()) end_row(width_);
  }
  /// The row that arrives, or what is left of it, is off.
  void fill_off(int32_t threshold) {
    const uint32_t given = samples_.column();
    samples_.fill(off_below(threshold));
    end_row(given);
  }
  /// A row never came. Limit: column() == 0.
  void skip(bool is_repeated, int32_t threshold) {
    if (is_repeated)
      samples_.repeat(off_below(threshold));
    else
      samples_.fill(off_below(threshold));
    end_row(is_repeated ? skipped_repeated : skipped_off);
  }

  /// Whether any row, or part of one, has arrived and is not bits yet.
  bool has_rows() const { return waiting_ > 0 || samples_.column() > 0; }
  /// Whether the row that has waited longest has waited for a whole slice.
  bool has_due_row() const { return waiting_ > height_; }

  struct PassedRow {
    bool is_skipped;   ///< it never came
    bool is_repeated;  ///< the row before stands in for it
  };
  /// Makes bits of the row that has waited longest. Limit: has_rows().
  PassedRow pass_on(BitRows& bits, int32_t threshold) {
    const uint16_t given = given_[samples_.place_before(waiting_)];
    const PassedRow row{given >= skipped_off, given == skipped_repeated};
    if (!row.is_skipped) bits.append(samples_.row_before(waiting_), given, 1, threshold);
    if (row.is_repeated)
      bits.repeat();
    else
      bits.fill_off();
    --waiting_;
    return row;
  }

  /// Says where two links meet, and what the normal is there.
  void meet_at(const Vertex& vertex) { here_ = vertex; }
  OctahedralNormal normal_here() const {
    return octahedral_normal(weighted(samples_.downhill(here_), weights_));
  }

 private:
  // Objects for other samples are as large.
  static constexpr uint32_t type = 2 * sizeof(Sample) + (static_cast<Sample>(-1) < 0 ? 1 : 0);

  // In the place of how many samples of a row were given.
  static constexpr uint16_t skipped_off = 0xFFFE;
  static constexpr uint16_t skipped_repeated = 0xFFFF;
  static_assert(Limits::max_extent < skipped_off, "widths are none of these");

  void end_row(uint32_t given) {
    given_[samples_.place_before(0)] = static_cast<uint16_t>(given);
    samples_.next_row();
    ++waiting_;
  }

  // What samples that never came are for the gradient: just off, where the type has such a value.
  // Above all its values nothing is on, and no one asks for a normal.
  static Sample off_below(int32_t threshold) {
    constexpr bool is_signed = static_cast<Sample>(-1) < 0;
    constexpr int32_t least = is_signed ? -(1 << (8 * sizeof(Sample) - 1)) : 0;
    return static_cast<Sample>(threshold > least ? threshold - 1 : least);
  }

  AxisWeights weights_;
  Vertex here_{0, 0, 0};
  SampleRows<Sample> samples_;
  uint16_t* given_ = nullptr;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint32_t waiting_ = 0;
  uint32_t type_ = type;
};

}  // namespace discmc

#endif
