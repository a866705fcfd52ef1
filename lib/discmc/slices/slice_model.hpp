// What is learnt of the bits of slices: how likely a voxel differs from the one before it.
//
// The neighbours of a voxel that are known before it are compared with the voxel before it in its
// row; so on and off are alike. In a slice they are those of the row before and of the slice
// before, in a key slice, which stands alone, those of three rows before:
//
//     slice before   . 7 .        row before     0 1 2       key slice   . 6 .
//                    3 4 5        this row       = ?                     3 4 5
//                    . 6 .                                               0 1 2    and 7 is 1
//                                                                        = ?
#ifndef DISCMC_SLICES_SLICE_MODEL_HPP
#define DISCMC_SLICES_SLICE_MODEL_HPP

#include <discmc/stream/range_coder.hpp>

namespace discmc::slices {

/// Whether a slice is told by the slice before it.
enum class SliceKind : uint8_t { key, follows };

namespace context {

constexpr uint32_t voxel = 0;  // by the neighbours that are not as the voxel before, a bit each
constexpr uint32_t run = 256;  // by its length, and whether it is all that is left of the row
constexpr uint32_t run_lengths = 8;
constexpr uint32_t note = run + 2 * run_lengths;
constexpr uint32_t count = note + 1;

}  // namespace context

class SliceModel {
 public:
  /// Forgets what it has learnt: slices of this kind are as those it was trained on.
  void begin(SliceKind kind);

  LearntProbability& operator[](uint32_t context) { return of_[context]; }

 private:
  LearntProbability of_[context::count];
};

/// A slice that is told by the one before begins, behind its first note. Nothing is learnt for it
/// from a key slice.
inline void begin_following_slice(SliceKind& kind, SliceModel& model) {
  if (kind == SliceKind::key) model.begin(SliceKind::follows);
  kind = SliceKind::follows;
}

}  // namespace discmc::slices

#endif
