// How often a stream of bits can be begun, and what memory its two ends need.
#ifndef DISCMC_KEY_SLICES_HPP
#define DISCMC_KEY_SLICES_HPP

#include <discmc/arena.hpp>
#include <discmc/slices/row_code.hpp>

namespace discmc {

/// How often a slice is told without the ones before, so that a receiver who has lost some, or who
/// comes late, may begin.
struct KeySlices {
  /// The slices from one key slice to the next; 0 where only the first is one. A packet that is
  /// lost takes the slices up to the next key slice with it, so about half of the interval.
  ///
  /// For an interval take the loss that you can bear, no less than what fills a packet: a slice of
  /// a CT head takes about 200 bytes, so 16 slices are 13 packets, and the stream is 4 % longer
  /// than with one key slice; 8 slices: 8 %, 4 slices: 16 %. 1 takes least memory, but longer
  /// streams: the CT head 62 %, an engine 83 %, a ball, of which a slice says nearly all of the
  /// next, 253 %.
  uint32_t interval = 0;

  constexpr bool is_every() const { return interval == 1; }
  constexpr bool is_key(uint32_t slice) const {
    return slice == 0 || (interval > 0 && slice % interval == 0);
  }
};

namespace slices {

/// The bytes of the rows and probabilities of some surfaces.
constexpr uint64_t surface_bytes(const Limits& limits, uint32_t rows, uint32_t surfaces) {
  uint64_t bytes = 0;
  for (uint32_t surface = 0; surface < surfaces; ++surface)
    bytes += trace::bit_row_bytes(limits.width, rows) + SliceModel::bytes_for(surface > 0);
  return bytes;
}

}  // namespace slices

/// The bytes of memory that a SliceEncoder needs (FOOTPRINT.md has a table). For every surface four
/// rows of bits and one more where every slice is a key slice, else those of a slice and three; and
/// 548 bytes for the first surface, 1,060 for each further one. Limit: valid limits.
constexpr uint64_t slice_encoder_bytes(const Limits& limits, KeySlices key_slices,
                                       uint32_t surfaces = 1) {
  const uint32_t rows = slices::rows_kept(limits.height, key_slices.is_every());
  return slices::surface_bytes(limits, rows, surfaces) + Arena::alignment - 1;
}

/// The bytes of memory that a SliceDecoder needs for slices of this size. Limit: valid limits.
constexpr uint64_t slice_decoder_bytes(const Limits& limits, uint32_t surfaces = 1) {
  return slice_encoder_bytes(limits, KeySlices{}, surfaces) +
         Arena::bytes_of((limits.width + 7) / 8, sizeof(uint8_t));
}

}  // namespace discmc

#endif
