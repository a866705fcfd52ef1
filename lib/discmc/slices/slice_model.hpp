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
//
// Where several surfaces are told the further ones also have the voxel of the first one, as 8:
// where thresholds are close they are nearly the same.
#ifndef DISCMC_SLICES_SLICE_MODEL_HPP
#define DISCMC_SLICES_SLICE_MODEL_HPP

#include <discmc/arena.hpp>
#include <discmc/stream/range_coder.hpp>

namespace discmc::slices {

/// Whether a slice is told by the slice before it.
enum class SliceKind : uint8_t { key, follows };

namespace context {

constexpr uint32_t note = 0;
constexpr uint32_t run = 1;  // by its length, and whether it is all that is left of the row
constexpr uint32_t run_lengths = 8;
// By the neighbours that are not as the voxel before, a bit each. Of a further surface the voxel of
// the first one at the same place is one more.
constexpr uint32_t voxel = run + 2 * run_lengths;
constexpr uint32_t voxels = 256;
constexpr uint32_t count = voxel + voxels;

}  // namespace context

/// How many contexts the model of a surface has.
constexpr uint32_t context_count(bool is_further) {
  return context::count + (is_further ? context::voxels : 0);
}

class SliceModel {
 public:
  static constexpr uint64_t bytes_for(bool is_further) {
    return Arena::bytes_of(context_count(is_further), sizeof(LearntProbability));
  }
  /// Takes bytes_for() from the arena, and writes nothing.
  void start(Arena& arena, bool is_further);

  /// Forgets what it has learnt: slices of this kind are as those it was trained on.
  void begin(SliceKind kind);

  LearntProbability& operator[](uint32_t context) { return of_[context]; }

 private:
  LearntProbability* of_ = nullptr;
  uint32_t count_ = 0;
};

}  // namespace discmc::slices

#endif
