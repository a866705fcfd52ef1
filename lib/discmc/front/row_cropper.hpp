// A part of what a sensor delivers: of each axis a range, and of that every voxel or every Nth.
//
//   cropper.start(incoming, {{100, 256}, {}, {0, 200, 2}});    x, y, z
//   extractor.start(cropper.limits(), ...);
//   for each row, which came or was lost:
//     if (cropper.next()) extractor.push(samples + cropper.first(), cropper.count(),
//     cropper.step());
//
// The voxels between those that are picked are dropped. That is right for a quick look, and where
// the sensor sees more than the surface needs; but a pick keeps all noise. Means of blocks do not:
// see downsampler.hpp. The range alone is what `discmc extract --crop` takes.
#ifndef DISCMC_ROW_CROPPER_HPP
#define DISCMC_ROW_CROPPER_HPP

#include <discmc/limits.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// What is picked of an axis: `count` voxels, each `step` behind the one before.
struct CropRange {
  static constexpr uint32_t rest = UINT32_MAX;  ///< as many as there are

  uint32_t first = 0;
  uint32_t count = rest;
  uint32_t step = 1;

  /// How many are picked of so many; of less than was asked for, 0. Limit: step > 0.
  constexpr uint32_t count_of(uint32_t extent) const {
    const uint32_t most = first < extent ? (extent - first - 1) / step + 1 : 0;
    return count == rest ? most : count <= most ? count : 0;
  }
};

/// Tells of each row that comes whether it is picked, and what of it. Spacings grow by the steps,
/// and the origin moves to the first voxel that is picked.
class RowCropper {
 public:
  /// Begins a volume. incoming: the size of the slices that come; the border is that of limits(),
  /// and the slab is left out. Errors: bad_limits (of them; nothing is picked of an axis, or more
  /// than there is, or by a step of 0); then nothing has changed.
  [[nodiscard]] Status start(const Limits& incoming, const CropRange& x, const CropRange& y,
                             const CropRange& z);

  /// The size of what is picked: for the extractor.
  Limits limits() const { return {count_, y_.count, border_}; }

  /// Whether the next row that comes is picked. Call it once for each, lost ones too. Limit: a
  /// started cropper.
  bool next();

  /// Whether no row that still comes is picked: the scan may end.
  bool is_done() const { return z_left_ == 0 && row_ == 0; }

  /// Of a row that is picked: its first sample, how many, and from one to the next. Units: samples.
  uint32_t first() const { return first_; }
  uint32_t count() const { return count_; }
  uint32_t step() const { return step_; }

  /// The same of a row of bits, eight voxels a byte, the first in bit 0. picked: room for
  /// count() / 8 bytes, rounded up; it may be `bits`. Owner: the caller. Cost: some 14
  /// instructions a voxel that is picked.
  void crop_bits(const uint8_t* bits, uint8_t* picked) const;

 private:
  uint32_t first_ = 0, count_ = 0, step_ = 1;  // of x
  CropRange y_{};
  uint32_t height_ = 0;
  uint32_t row_ = 0;     // that comes next, in its slice
  uint32_t y_next_ = 0;  // the row that is picked next
  uint32_t y_left_ = 0;  // rows of the slice that are still picked
  uint32_t z_step_ = 1;
  uint32_t z_wait_ = 0;  // slices to the next one that is picked
  uint32_t z_left_ = 0;  // slices that are still picked
  Border border_ = Border::closed;
};

}  // namespace discmc

#endif
