// Which voxels of a volume are on, decided in the samples' own type.
#ifndef DISCMC_MESH_EXTRACTION_SELECTION_HPP
#define DISCMC_MESH_EXTRACTION_SELECTION_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// The values that are on: from low to high, both of them too; {300} is a threshold. A sample that
/// is not a number is off. Units: those that the file declares.
struct Selection {
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  /// For a volume of label_bits(): voxels with one of these bits are on. 0: the values count.
  std::uint64_t bits = 0;

  bool has_upper_end() const { return bits != 0 || high < std::numeric_limits<double>::infinity(); }
};

/// Samples from low to high, both of them too; none where low > high.
template <class Sample>
struct SampleRange {
  Sample low;
  Sample high;

  bool holds(Sample sample) const { return low <= sample && sample <= high; }
};

/// The stored samples whose values are selected: exactly those, whole numbers as with
/// stored_threshold(). For floating point the ends of the selection are rounded to the samples' own
/// type first. So 0.35 selects a sample stored as 0.35 of 32 bits. Sample: any of
/// with_sample_type().
template <class Sample>
SampleRange<Sample> selected_samples(const SampleGrid& info, const Selection& selection);

/// Units: bytes of a row with this many bits.
constexpr std::size_t bit_row_bytes(std::uint32_t width) {
  return (std::size_t{width} + 7) / 8;
}

/// Makes bits of slices.
class SliceSelector {
 public:
  SliceSelector(const SampleGrid& info, const Selection& selection);

  /// Writes the rows of a slice as Extractor::push_bits() takes them, unused bits off. samples: as
  /// SliceReader::read_slice() gives them. stride: from one row of bits to the next.
  /// Units: stride in bytes. Returns how many samples are not a number.
  std::uint64_t select(const void* samples, std::uint8_t* bits, std::size_t stride) const {
    return select_(samples, bits, stride);
  }

 private:
  std::function<std::uint64_t(const void*, std::uint8_t*, std::size_t)> select_;
};

}  // namespace discmc::meshing

#endif
