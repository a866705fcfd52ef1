// Intakes of samples: they make rows of bits, and may keep samples for normals.
//
// An extractor without normals keeps no samples: this intake thresholds samples as they arrive.
// GradientIntake keeps samples and delays rows (gradient_intake.hpp).
#ifndef DISCMC_TRACE_INTAKE_HPP
#define DISCMC_TRACE_INTAKE_HPP

#include <discmc/normal.hpp>
#include <discmc/trace/bit_rows.hpp>

namespace discmc::detail::trace {

/// The origin of a row of bits. The sink gets an event for each row without samples.
enum class RowOrigin : uint8_t {
  samples,   ///< own samples; also an incomplete row
  skipped,   ///< no samples arrived: the row is off
  repeated,  ///< no samples arrived: the previous row replaces it
};

/// The normal of a run in an extractor without normals.
struct NoNormal {};

/// The intake of an extractor without normals.
class BitIntake {
 public:
  static constexpr bool holds_samples = false;
  static constexpr uint32_t type = 0;  ///< of extractor: see BasicExtractor::layout
  using Normal = NoNormal;

  static constexpr uint64_t bytes_for(const Limits&) { return 0; }
  void start(Arena&, const Limits&) {}
  void clear() {}
  void write_spacing(int32_t (&)[3]) const {}

  /// Returns the column of the next sample.
  uint32_t column(const BitRows& rows) const { return rows.column(); }
  uint32_t rows(const BitRows& rows) const { return rows.rows(); }
  uint32_t slices(const BitRows& rows) const { return rows.slices(); }

  /// Appends samples to the arriving row. Limit: count <= width - column().
  template <class Sample>
  RowOrigin append(BitRows& rows, const Sample* samples, uint32_t count, uint32_t stride,
                   int32_t threshold) {
    rows.append(samples, count, stride, threshold);
    if (rows.is_row_complete()) rows.next_row();
    return RowOrigin::samples;
  }
  /// Processes a row that never arrived. Limit: column() == 0.
  RowOrigin skip(BitRows& rows, bool is_repeated, int32_t) {
    if (is_repeated)
      rows.repeat();
    else
      rows.fill_off();
    rows.next_row();
    return is_repeated ? RowOrigin::repeated : RowOrigin::skipped;
  }
  /// Processes the end of the samples: missing ones of the slice are off. Limit: holds_rows().
  RowOrigin drain(BitRows& rows, int32_t) {
    rows.fill_off();
    rows.next_row();
    return RowOrigin::samples;
  }
  /// Whether a slice has begun and is incomplete.
  bool holds_rows(const BitRows& rows) const { return rows.rows() > 0 || rows.column() > 0; }

  NoNormal normal_at(const Vertex&) const { return {}; }
};

}  // namespace discmc::detail::trace

#endif
