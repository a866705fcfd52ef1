// Rows of samples to rows of bits, with a threshold per row or per column: for lamps that drift,
// shading, and sensor columns that differ.
//
//   threshold_row(samples, width, threshold_of_this_row, bits);
//   extractor.push_bits(bits);       or a filter first, see majority_filter.hpp
//
// With one threshold for all rows, call push() of the extractor instead.
//
// The stream's header contains the threshold given to the extractor: start it with the nominal one.
// It is informational; decoding ignores it.
#ifndef DISCMC_THRESHOLD_ROW_HPP
#define DISCMC_THRESHOLD_ROW_HPP

#include <discmc/row_input.hpp>

namespace discmc {

/// Writes one bit per sample, on if sample >= threshold: eight per byte, the first in bit 0, as
/// push_bits() expects. bits: room for count / 8 bytes, rounded up; unused bits are off; Owner: the
/// caller. stride: from one sample to the next, in samples. Sample is uint8_t, uint16_t or int16_t.
/// Cost: as push() for consecutive samples from a word boundary on, otherwise about 15 instructions
/// per sample.
template <class Sample>
void threshold_row(const Sample* samples, uint32_t count, int32_t threshold, uint8_t* bits,
                   uint32_t stride = 1);

/// As threshold_row(), with an offset per column: on if sample - offsets[x] >= threshold. Measure a
/// column's offset as its dark reading. Cost: about 13 instructions per sample on a Cortex-M4.
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
