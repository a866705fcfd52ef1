// Rows of samples to rows of bits, with a threshold that changes from row to row, or from column to
// column: for lamps that drift, shading, and columns of a sensor that differ.
//
//   threshold_row(samples, width, threshold_of_this_row, bits);
//   extractor.push_bits(bits);       or a filter first, see majority_filter.hpp
//
// An extractor with one threshold needs none of this: push() compares samples itself.
//
// What the extractor was started with is what the stream's header tells as the threshold: start it
// with the nominal one. Nothing that is decoded depends on it.
#ifndef DISCMC_THRESHOLD_ROW_HPP
#define DISCMC_THRESHOLD_ROW_HPP

#include <discmc/row_input.hpp>

namespace discmc {

/// Writes a bit a sample, on where sample >= threshold: eight a byte, the first in bit 0, as
/// push_bits() takes them. bits: room for count / 8 bytes, rounded up; unused bits are off; Owner:
/// the caller. stride: from one sample to the next, in samples. Sample is uint8_t, uint16_t or
/// int16_t. Cost: as push() where samples begin on a word boundary and are consecutive, else some
/// 15 instructions a sample.
template <class Sample>
void threshold_row(const Sample* samples, uint32_t count, int32_t threshold, uint8_t* bits,
                   uint32_t stride = 1);

/// The same less an offset for each column: on where sample - offsets[x] >= threshold. A column's
/// offset is what the sensor adds there, such as its reading in the dark. Cost: some
/// 13 instructions a sample on a Cortex-M4.
template <class Sample>
void threshold_row_less(const Sample* samples, const int16_t* offsets, uint32_t count,
                        int32_t threshold, uint8_t* bits);

extern template void threshold_row(const uint8_t*, uint32_t, int32_t, uint8_t*, uint32_t);
extern template void threshold_row(const uint16_t*, uint32_t, int32_t, uint8_t*, uint32_t);
extern template void threshold_row(const int16_t*, uint32_t, int32_t, uint8_t*, uint32_t);
extern template void threshold_row_less(const uint8_t*, const int16_t*, uint32_t, int32_t,
                                        uint8_t*);
extern template void threshold_row_less(const uint16_t*, const int16_t*, uint32_t, int32_t,
                                        uint8_t*);
extern template void threshold_row_less(const int16_t*, const int16_t*, uint32_t, int32_t,
                                        uint8_t*);

}  // namespace discmc

#endif
