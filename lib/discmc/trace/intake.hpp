// Where samples come in: they become rows of bits, and may be kept for normals.
//
// An extractor without normals has nothing to keep: this intake thresholds samples as they come.
// GradientIntake keeps samples and lets rows wait (gradient_intake.hpp).
#ifndef DISCMC_TRACE_INTAKE_HPP
#define DISCMC_TRACE_INTAKE_HPP

#include <discmc/normal.hpp>
#include <discmc/trace/bit_rows.hpp>

namespace discmc {

/// Where a row of bits comes from. The sink gets an event for each row without samples.
enum class RowOrigin : uint8_t {
  samples,   ///< samples of its own; also a row that is not complete
  skipped,   ///< no samples arrived: the row is off
  repeated,  ///< no samples arrived: the row before replaces it
};

/// The normal of a run in an extractor without normals.
struct NoNormal {};

/// For an extractor that makes no normals.
class BitIntake {
 public:
  static constexpr bool holds_samples = false;
  static constexpr uint32_t type = 0;  ///< of extractor: see BasicExtractor::layout
  using Normal = NoNormal;

  static constexpr uint64_t bytes_for(const Limits&) { return 0; }
  void start(Arena&, const Limits&) {}
  void clear() {}
  void write_spacing(int32_t (&)[3]) const {}

  /// Where the samples that arrive are.
  uint32_t column(const detail::trace::BitRows& rows) const { return rows.column(); }
  uint32_t rows(const detail::trace::BitRows& rows) const { return rows.rows(); }
  uint32_t slices(const detail::trace::BitRows& rows) const { return rows.slices(); }

  /// Appends samples to the row that arrives. Limit: count <= width - column().
  template <class Sample>
  RowOrigin append(detail::trace::BitRows& rows, const Sample* samples, uint32_t count,
                   uint32_t stride, int32_t threshold) {
    rows.append(samples, count, stride, threshold);
    if (rows.row_is_complete()) rows.next_row();
    return RowOrigin::samples;
  }
  /// A row never came. Limit: column() == 0.
  RowOrigin skip(detail::trace::BitRows& rows, bool is_repeated, int32_t) {
    if (is_repeated)
      rows.repeat();
    else
      rows.fill_off();
    rows.next_row();
    return is_repeated ? RowOrigin::repeated : RowOrigin::skipped;
  }
  /// No more samples come: what the slice lacks is off. Limit: holds_rows().
  RowOrigin drain(detail::trace::BitRows& rows, int32_t) {
    rows.fill_off();
    rows.next_row();
    return RowOrigin::samples;
  }
  /// Whether a slice is under way.
  bool holds_rows(const detail::trace::BitRows& rows) const {
    return rows.rows() > 0 || rows.column() > 0;
  }

  NoNormal normal_at(const Vertex&) const { return {}; }
};

}  // namespace discmc

#endif
