// Decides which voxels of a volume are on, in the samples' own type.
#ifndef DISCMC_MESH_EXTRACTION_SELECTION_HPP
#define DISCMC_MESH_EXTRACTION_SELECTION_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// The values that are on: from low to high inclusive; {300} is a threshold. NaN is off. Units: the
/// unit that the file declares.
struct Selection {
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  /// For a volume of label_bits(): voxels with one of these bits are on. 0: values decide.
  std::uint64_t bits = 0;

  bool has_upper_end() const { return bits != 0 || high < std::numeric_limits<double>::infinity(); }
};

/// Samples from low to high inclusive; none if low > high.
template <class Sample>
struct SampleRange {
  Sample low;
  Sample high;

  bool holds(Sample sample) const { return low <= sample && sample <= high; }
};

/// Returns the stored samples whose values are selected, exact for whole numbers like
/// stored_threshold(). For floating point, the ends of the selection are first rounded to the
/// samples' own type, so 0.35 selects a sample stored as 32-bit 0.35. Sample: any of
/// with_sample_type().
template <class Sample>
SampleRange<Sample> selected_samples(const SampleGrid& info, const Selection& selection);

/// Returns the bytes of a row with this many bits.
constexpr std::size_t bit_row_bytes(std::uint32_t width) {
  return (std::size_t{width} + 7) / 8;
}

/// Makes the bits of slices.
class SliceSelector {
 public:
  SliceSelector(const SampleGrid& info, const Selection& selection);

  /// Writes the rows of a slice in the form of Extractor::push_bits(), with unused bits off.
  /// samples: from SliceReader::read_slice(). stride: distance between rows of bits. Units: bytes.
  /// Returns the number of NaN samples.
  std::uint64_t select(const void* samples, std::uint8_t* bits, std::size_t stride) const {
    return select_(samples, bits, stride);
  }

 private:
  std::function<std::uint64_t(const void*, std::uint8_t*, std::size_t)> select_;
};

}  // namespace discmc::meshing

#endif
