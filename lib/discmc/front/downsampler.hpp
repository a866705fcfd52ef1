// Fewer and larger voxels: the mean of each block of N x N x N samples, voxel for voxel as `discmc
// extract --shrink N` computes it. Noise falls by the square root of the samples per block.
//
//   means.start(incoming, 2, memory);
//   extractor.start(means.limits(), ...);
//   for each arriving row:
//     if (const Sample* row = means.push(samples)) extractor.push(row, means.limits().width);
//
//   while (const Sample* row = means.drain()) extractor.push(row, means.limits().width);
//
// The last blocks along an axis contain the remaining voxels. Samples of 0 and 1 give a majority: 1
// if at least half of a block is 1.
#ifndef DISCMC_DOWNSAMPLER_HPP
#define DISCMC_DOWNSAMPLER_HPP

#include <discmc/base/arena.hpp>
#include <discmc/limits.hpp>
#include <discmc/row_input.hpp>
#include <discmc/trace/threshold.hpp>

namespace discmc {

/// Rows of samples in, rows of means out. Sample is uint8_t, uint16_t or int16_t. It is neither
/// copied nor moved: two copies would write to the same memory.
template <class Sample>
class Downsampler {
  static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");

 public:
  static constexpr uint32_t max_extent = 16;  ///< of a block

  Downsampler() = default;
  Downsampler(const Downsampler&) = delete;
  Downsampler& operator=(const Downsampler&) = delete;

  /// The memory for start(): the sums of one slice, and a row of means. Units: bytes.
  static constexpr uint64_t bytes_for(const Limits& incoming, uint32_t extent) {
    const uint32_t width = blocks(incoming.width, extent);
    return Arena::bytes_of(width * blocks(incoming.height, extent), sizeof(uint32_t)) +
           Arena::bytes_of(width, sizeof(Sample)) + Arena::alignment - 1;
  }

  /// Begins a volume. incoming: the size of the incoming slices; limits() has its border, and
  /// ignores its slab. extent: of a block, in voxels along each axis; Limit: 1 to max_extent.
  /// memory: at least bytes_for(incoming, extent); Owner: the caller, while this object is in use.
  /// Errors: bad_limits, too_little_memory; then it is not started. Cost: one write per block of a
  /// slice.
  [[nodiscard]] Status start(const Limits& incoming, uint32_t extent, Memory memory);

  /// The size of the outgoing slices, for the extractor.
  Limits limits() const { return limits_; }

  /// Accepts the next row, incoming.width samples. Returns the row of means that it completes, or
  /// null; Owner: this object, until the next call. Limit: started, before drain(). Cost: about 15
  /// instructions per sample on a Cortex-M4, including the division per block.
  const Sample* push(const Sample* samples);

  /// Returns the next of the rows left after the last slice, or null at the end; Owner: as of
  /// push(). Limit: started, and whole slices.
  const Sample* drain();

 private:
  static constexpr uint32_t blocks(uint32_t voxels, uint32_t extent) {
    return (voxels + extent - 1) / extent;
  }
  // Sums are relative to the least sample, so they are never negative.
  static constexpr int32_t min_sample = detail::trace::min_sample<Sample>;

  uint32_t size_of(uint32_t block, uint32_t voxels) const;
  const Sample* next_row(uint32_t slices);

  Limits limits_{};
  Limits incoming_{};
  uint32_t extent_ = 1;
  uint32_t* sums_ = nullptr;  // of a slice of blocks
  Sample* means_ = nullptr;   // of a row of blocks
  uint32_t row_ = 0;          // next row of the slice
  uint32_t slice_ = 0;        // slice within its layer of blocks
  uint32_t row_in_block_ = 0;
  uint32_t block_ = 0;  // next row of blocks, of sums or of means
};

extern template class Downsampler<uint8_t>;
extern template class Downsampler<uint16_t>;
extern template class Downsampler<int16_t>;

}  // namespace discmc

#endif
