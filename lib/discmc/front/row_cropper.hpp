// Selects a part of a sensor's picture: a range of each axis, with every voxel or every Nth.
//
//   cropper.start(incoming, {{100, 256}, {}, {0, 200, 2}});    x, y, z
//   extractor.start(cropper.limits(), ...);
//   for each row, which came or was lost:
//     if (cropper.next()) extractor.push(samples + cropper.first(), cropper.count(),
//     cropper.step());
//
// A step drops the voxels between, which suits a quick look or a sensor that oversamples. It keeps
// all noise; for means of blocks see downsampler.hpp. A range without a step equals `discmc extract
// --crop`.
#ifndef DISCMC_ROW_CROPPER_HPP
#define DISCMC_ROW_CROPPER_HPP

#include <discmc/limits.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// The selection on an axis: `count` voxels, each `step` after the previous one.
struct CropRange {
  static constexpr uint32_t rest = UINT32_MAX;  ///< to the end of the axis

  uint32_t first = 0;
  uint32_t count = rest;
  uint32_t step = 1;

  /// Returns the number of selected voxels of an axis; 0 if it has too few. Limit: step > 0.
  constexpr uint32_t count_of(uint32_t extent) const {
    const uint32_t available = first < extent ? (extent - first - 1) / step + 1 : 0;
    return count == rest ? available : count <= available ? count : 0;
  }
};

/// Decides for each row whether it is selected, and which of its samples. Multiply the stream's
/// spacing by the steps, and move the origin to the first selected voxel.
class RowCropper {
 public:
  /// Begins a volume. incoming: the size of the incoming slices; limits() has its border, and
  /// ignores its slab. Errors: bad_limits (invalid limits; or a range that is empty, exceeds an
  /// axis or has a step of 0); then nothing has changed.
  [[nodiscard]] Status start(const Limits& incoming, const CropRange& x, const CropRange& y,
                             const CropRange& z);

  /// The size of the selection, for the extractor.
  Limits limits() const { return {count_, y_.count, border_}; }

  /// Whether the next row is selected. Call it once per row, including lost rows. Limit: started.
  bool next();

  /// Whether no further row is selected: the scan may end.
  bool is_done() const { return z_left_ == 0 && row_ == 0; }

  /// For a selected row: its first sample, the number of samples, and the step. Units: samples.
  uint32_t first() const { return first_; }
  uint32_t count() const { return count_; }
  uint32_t step() const { return step_; }

  /// Crops a row of bits, eight voxels per byte, the first in bit 0. picked: room for count() / 8
  /// bytes, rounded up; it may be `bits`. Owner: the caller. Cost: about 14 instructions per
  /// selected voxel.
  void crop_bits(const uint8_t* bits, uint8_t* picked) const;

 private:
  uint32_t first_ = 0, count_ = 0, step_ = 1;  // along x
  CropRange y_{};
  uint32_t height_ = 0;
  uint32_t row_ = 0;     // next in its slice
  uint32_t y_next_ = 0;  // the next selected row
  uint32_t y_left_ = 0;  // selected rows left in the slice
  uint32_t z_step_ = 1;
  uint32_t z_wait_ = 0;  // slices to the next selected one
  uint32_t z_left_ = 0;  // selected slices left
  Border border_ = Border::closed;
};

}  // namespace discmc

#endif
