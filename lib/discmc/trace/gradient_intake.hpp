// The intake of extractors with normals. It keeps the samples, and delays rows until all neighbours
// of a vertex are present.
#ifndef DISCMC_TRACE_GRADIENT_INTAKE_HPP
#define DISCMC_TRACE_GRADIENT_INTAKE_HPP

#include <discmc/row_input.hpp>
#include <discmc/trace/intake.hpp>
#include <discmc/trace/sample_rows.hpp>
#include <discmc/trace/threshold.hpp>

namespace discmc::detail::trace {

/// Sample is uint8_t, uint16_t or int16_t.
template <class Sample>
class GradientIntake {
  static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");

 public:
  static constexpr bool holds_samples = true;
  static constexpr uint32_t type = sample_type<Sample>;
  using Normal = OctahedralNormal;

  // The sweep may meet a corner at the centroid of a cell one slice later than the cell. Its normal
  // needs one more slice and row on all sides.
  static constexpr uint32_t ring_rows(const Limits& limits) { return 4 * limits.height + 6; }
  static constexpr uint64_t bytes_for(const Limits& limits) {
    return SampleRows<Sample>::bytes_for(limits, ring_rows(limits)) +
           Arena::bytes_of(ring_rows(limits), sizeof(uint16_t));
  }
  /// Allocates bytes_for(limits) in the arena, and writes nothing.
  void start(Arena& arena, const Limits& limits) {
    samples_.start(arena, limits, ring_rows(limits));
    row_counts_ = arena.allocate<uint16_t>(ring_rows(limits));
    width_ = limits.width;
    height_ = limits.height;
    first_z_ =
        2 * (static_cast<int32_t>(limits.slab.first) - (limits.slab.continues_below ? 1 : 0));
  }
  void clear() {
    samples_.clear();
    waiting_ = 0;
  }

  /// Sets the spacing for voxels that are not cubes. Units: nanometres.
  void set_spacing(const int32_t (&spacing_nm)[3]) {
    for (int axis = 0; axis < 3; ++axis) spacing_nm_[axis] = spacing_nm[axis];
    weights_ = axis_weights(spacing_nm);
  }
  void write_spacing(int32_t (&spacing_nm)[3]) const {
    for (int axis = 0; axis < 3; ++axis) spacing_nm[axis] = spacing_nm_[axis];
  }

  /// Returns the column of the next sample, like BitIntake.
  uint32_t column(const BitRows&) const { return samples_.column(); }
  uint32_t rows(const BitRows&) const { return samples_.rows(); }
  uint32_t slices(const BitRows&) const { return samples_.slices(); }

  /// Appends samples like BitIntake, but only of this type.
  RowOrigin append(BitRows& rows, const Sample* samples, uint32_t count, uint32_t stride,
                   int32_t threshold) {
    samples_.append(samples, count, stride);
    if (!samples_.is_row_complete()) return RowOrigin::samples;
    end_row(width_);
    return pass_on_due(rows, threshold);
  }
  RowOrigin skip(BitRows& rows, bool is_repeated, int32_t threshold) {
    if (is_repeated)
      samples_.repeat(off_below(threshold));
    else
      samples_.fill(off_below(threshold));
    end_row(is_repeated ? skipped_repeated : skipped_off);
    return pass_on_due(rows, threshold);
  }
  RowOrigin drain(BitRows& rows, int32_t threshold) {
    if (samples_.rows() == 0 && samples_.column() == 0) return pass_on(rows, threshold);
    const uint32_t arrived = samples_.column();
    samples_.fill(off_below(threshold));
    end_row(arrived);
    return pass_on_due(rows, threshold);
  }
  bool holds_rows(const BitRows& rows) const {
    return waiting_ > 0 || samples_.column() > 0 || rows.rows() > 0;
  }

  OctahedralNormal normal_at(const Vertex& vertex) const {
    const Vertex here{vertex.x, vertex.y, vertex.z - first_z_};
    return octahedral_normal(weighted(samples_.negative_gradient(here), weights_));
  }

 private:
  // Marks of skipped rows in row_counts_.
  static constexpr uint16_t skipped_off = 0xFFFE;
  static constexpr uint16_t skipped_repeated = 0xFFFF;
  static_assert(Limits::max_extent < skipped_off, "widths are none of these");
  static_assert(uint64_t{Limits::max_extent} *
                        ring_rows({Limits::max_extent, Limits::max_extent}) <=
                    UINT32_MAX,
                "32 bits count the samples of a ring");

  void end_row(uint32_t count) {
    row_counts_[samples_.index_before(0)] = static_cast<uint16_t>(count);
    samples_.next_row();
    ++waiting_;
  }
  // Passes on a row that is due, which is after a slice and a row.
  RowOrigin pass_on_due(BitRows& rows, int32_t threshold) {
    if (waiting_ <= height_ + 1) return RowOrigin::samples;
    return pass_on(rows, threshold);
  }
  // Thresholds the oldest row.
  RowOrigin pass_on(BitRows& rows, int32_t threshold) {
    const uint16_t count = row_counts_[samples_.index_before(waiting_)];
    const RowOrigin row = count == skipped_repeated ? RowOrigin::repeated
                          : count == skipped_off    ? RowOrigin::skipped
                                                    : RowOrigin::samples;
    if (row == RowOrigin::samples) rows.append(samples_.row_before(waiting_), count, 1, threshold);
    if (row == RowOrigin::repeated)
      rows.repeat();
    else
      rows.fill_off();
    rows.next_row();
    --waiting_;
    return row;
  }

  // Returns the value of missing samples for the gradient: just below the threshold, if the type
  // has such a value. If the threshold exceeds all values of the type, nothing is on and there are
  // no normals.
  static Sample off_below(int32_t threshold) {
    constexpr int32_t lowest = min_sample<Sample>;
    return static_cast<Sample>(threshold > lowest ? threshold - 1 : lowest);
  }

  int32_t spacing_nm_[3] = {0, 0, 0};  // 0: unknown
  AxisWeights weights_;
  SampleRows<Sample> samples_;
  // Per row of the ring: its number of samples, or a mark of a skipped row.
  uint16_t* row_counts_ = nullptr;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  int32_t first_z_ = 0;   // of the samples in the volume
  uint32_t waiting_ = 0;  // rows not yet thresholded
};

}  // namespace discmc::detail::trace

#endif
