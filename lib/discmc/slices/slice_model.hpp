// The learnt model of slices: the probability that a voxel differs from the previous one. The
// neighbours coded before a voxel are compared with the previous voxel of its row, so on and off
// are alike. Neighbours are in the previous row and in the previous slice. In a key slice, which
// decodes alone, they are in the three previous rows:
//
//     slice before   . 7 .        row before     0 1 2       key slice   . 6 .
//                    3 4 5        this row       = ?                     3 4 5
//                    . 6 .                                               0 1 2    and 7 is 1
//                                                                        = ?
// A further surface of a stream also has the voxel of the first surface as neighbour 8. With close
// thresholds the two are nearly equal.
#ifndef DISCMC_SLICES_SLICE_MODEL_HPP
#define DISCMC_SLICES_SLICE_MODEL_HPP

#include <discmc/base/arena.hpp>
#include <discmc/stream/range_coder.hpp>

namespace discmc::detail::slices {

/// Whether the slice before contains neighbours.
enum class SliceKind : uint8_t { key, follows };

namespace context {

constexpr uint32_t note = 0;
constexpr uint32_t run = 1;  // by length, and by whether it reaches the end of the row
constexpr uint32_t run_lengths = 8;
// By the neighbours that differ from the voxel before, one bit each. A further surface has one more
// neighbour: the voxel of the first surface at the same place.
constexpr uint32_t voxel = run + 2 * run_lengths;
constexpr uint32_t voxels = 256;
constexpr uint32_t count = voxel + voxels;

}  // namespace context

/// The number of contexts in the model of a surface.
constexpr uint32_t context_count(bool is_further) {
  return context::count + (is_further ? context::voxels : 0);
}

class SliceModel {
 public:
  static constexpr uint64_t bytes_for(bool is_further) {
    return Arena::bytes_of(context_count(is_further), sizeof(LearntProbability));
  }
  /// Allocates bytes_for() in the arena, and writes nothing.
  void start(Arena& arena, bool is_further);

  /// Resets the probabilities to those trained for slices of this kind.
  void begin(SliceKind kind);

  LearntProbability& operator[](uint32_t context) { return probabilities_[context]; }

 private:
  LearntProbability* probabilities_ = nullptr;
  uint32_t count_ = 0;
};

}  // namespace discmc::detail::slices

#endif
