// How often a stream of bits can be begun, and what memory its two ends need.
#ifndef DISCMC_KEY_SLICES_HPP
#define DISCMC_KEY_SLICES_HPP

#include <discmc/arena.hpp>
#include <discmc/slices/row_code.hpp>

namespace discmc {

/// How often a slice is told without the ones before, so that a receiver who has lost some, or who
/// comes late, may begin.
struct KeySlices {
  /// The slices from one key slice to the next; 0 where only the first is one. 1 makes the stream
  /// half as long again, and takes least memory.
  uint32_t interval = 0;

  constexpr bool is_every() const { return interval == 1; }
  constexpr bool is_key(uint32_t slice) const {
    return slice == 0 || (interval > 0 && slice % interval == 0);
  }
};

/// The bytes of memory that a SliceEncoder needs: four rows of bits and one more where every slice
/// is a key slice, else those of a slice and three. Limit: valid limits.
constexpr uint64_t slice_encoder_bytes(const Limits& limits, KeySlices key_slices) {
  return trace::bit_row_bytes(limits.width,
                              slices::rows_kept(limits.height, key_slices.is_every())) +
         Arena::alignment - 1;
}

/// The bytes of memory that a SliceDecoder needs for slices of this size. Limit: valid limits.
constexpr uint64_t slice_decoder_bytes(const Limits& limits) {
  return slice_encoder_bytes(limits, KeySlices{}) +
         Arena::bytes_of((limits.width + 7) / 8, sizeof(uint8_t));
}

}  // namespace discmc

#endif
