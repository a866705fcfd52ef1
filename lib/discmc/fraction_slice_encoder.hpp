// A slice encoder that also sends where the surface lies between the voxels.
//
// Polygons are up to half a voxel from the interpolated surface: their vertices are at the middle
// of the edges between voxels. This encoder also sends the fraction of each edge (fraction.hpp). It
// is the half or quarter in which the surface crosses the edge. The receiver has the same polygons,
// and moves their vertices to the fractions.
//
//   CT head (Stanford) at 500      bytes   mean distance along the edges
//   slices                         21,717  0.24 of an edge
//   slices, 2 levels               45,577  0.13
//   slices, 4 levels               74,885  0.06
#ifndef DISCMC_FRACTION_SLICE_ENCODER_HPP
#define DISCMC_FRACTION_SLICE_ENCODER_HPP

#include <discmc/slice_encoder.hpp>
#include <discmc/slices/fraction_code.hpp>
#include <discmc/slices/fraction_intake.hpp>

namespace discmc {

/// A SliceEncoder with fractions. All functions that are not here are those of SliceEncoder. It
/// needs samples of one type, and has no push_bits(): bits have no fractions. For a threshold per
/// row or column, subtract its deviation from the samples. Rows that are skipped have no fractions.
template <class Sample>
class FractionSliceEncoder : public SliceEncoder {
  static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");

 public:
  /// The memory of start(), which needs no more. A SliceEncoder with slices between its key slices
  /// needs a part of it. In addition there is a row of samples. Each surface needs half a byte per
  /// voxel of a slice, and 4 bytes per voxel of a row. The fractions of the slice before need 2
  /// bytes per voxel of a row and of a column. Fractions without room only make the stream longer.
  /// The probabilities need 940 bytes for 2 levels, or 2,752 for 4. Limit: valid limits, and
  /// levels of 2 or 4.
  static constexpr uint64_t minimum_bytes(const SliceEncoderConfig& config) {
    return bytes_for(config, true) +
           fraction_bytes(config.limits, config.surface_count, config.levels);
  }

  FractionSliceEncoder() = default;

  /// As SliceEncoder::start(). config.levels: 2 or 4, the parts of an edge. Errors:
  /// bad_label for other levels, too.
  [[nodiscard]] Status start(const SliceEncoderConfig& config, Memory memory,
                             const ByteOutput& output);

  /// As SliceEncoder::push(). Cost, on a Cortex-M4 with -Os: about 13 instructions
  /// more per voxel, and 590 per edge that crosses.
  PushResult push(const Sample* samples, uint32_t count, uint32_t stride = 1);

  PushResult push_bits(const uint8_t* bits) = delete;

  /// As SliceEncoder::restore().
  [[nodiscard]] Status restore(Memory memory, const ByteOutput& output);

 private:
  using Intake = detail::slices::FractionIntake<Sample>;

  static constexpr uint64_t fraction_bytes(const Limits& limits, uint32_t surfaces,
                                           uint32_t levels) {
    const uint32_t of_slice = Intake::distance_bytes(limits.width) * limits.height;
    return detail::slices::Fractions::bytes_for(limits, surfaces, levels) +
           surfaces * Arena::bytes_of(of_slice, sizeof(uint8_t)) +
           Arena::bytes_of(limits.width, sizeof(Sample)) + Arena::alignment - 1;
  }

  bool lay_out_fractions(Memory memory);
  detail::slices::FractionRow around(uint32_t surface) {
    return fractions_.around(surfaces_[surface].rows, surface, slices() > 0);
  }
  Intake intake(uint32_t surface) {
    const StreamHeader& header = packets_.header();
    return Intake(header.thresholds[surface], header.levels, samples_,
                  distances_[surface] + Intake::distance_bytes(header.width) * rows());
  }
  void process(const Sample* samples, uint32_t first, uint32_t count, uint32_t stride);
  bool code_row();
  bool make_room_for_fraction();
  void begin_code();

  detail::slices::Fractions fractions_;
  detail::slices::FractionCode code_;
  bool is_begun_ = false;
  Sample* samples_ = nullptr;  // of the row before; up to the column that arrives, of this row
  uint8_t* distances_[StreamHeader::max_surfaces] = {};
};

extern template class FractionSliceEncoder<uint8_t>;
extern template class FractionSliceEncoder<uint16_t>;
extern template class FractionSliceEncoder<int16_t>;

}  // namespace discmc

#endif
