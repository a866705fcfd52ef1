// Finds the fractions of a row while its samples arrive.
//
// The fraction of an edge follows from the distances of its two samples to the threshold. Samples
// of the previous row are kept. For the previous slice, only the bit width of each distance is
// kept, in half a byte. The middle of the width's range replaces the distance.
#ifndef DISCMC_SLICES_FRACTION_INTAKE_HPP
#define DISCMC_SLICES_FRACTION_INTAKE_HPP

#include <discmc/slices/fractions.hpp>
#include <discmc/trace/threshold.hpp>

namespace discmc::detail::slices {

/// The arriving row of one surface, and the kept samples before it.
template <class Sample>
class FractionIntake {
 public:
  /// Returns the bytes of a row of distances.
  static constexpr uint32_t distance_bytes(uint32_t width) { return (width + 1) / 2; }

  /// samples: row y - 1 from the column of the arriving samples on, and this row before it.
  /// distances: distance_bytes() of this row in the previous slice.
  FractionIntake(int32_t threshold, uint32_t levels, const Sample* samples, uint8_t* distances)
      : threshold_(threshold < min_sample            ? min_sample
                   : threshold > min_sample + extent ? min_sample + extent
                                                     : threshold),
        doubled_(2 * static_cast<uint32_t>(threshold_) - 1),
        levels_(levels),
        samples_(samples),
        distances_(distances) {}

  /// Finds the fractions of edges whose upper end is among these samples. Limit: the row has the
  /// bits of the samples.
  void find(const FractionRow& row, const Sample* samples, uint32_t column, uint32_t count,
            uint32_t stride) {
    if (row.is_off()) return;
    const uint32_t end = column + count;
    for (uint32_t word = trace::word_of(column + 1); word <= trace::word_of(end); ++word) {
      if (row.is_level(word)) continue;
      const uint32_t along[3] = {row.along_x(word), row.along_y(word), row.along_z(word)};
      // Column x + 1 is bit x + 2 of word 0.
      const uint32_t first = word * trace::columns_per_word;
      uint32_t columns = trace::own_columns;
      if (column + 1 > first) columns &= 0U - (uint32_t{2} << (column + 1 - first));
      if (end - first < trace::columns_per_word) columns &= (uint32_t{4} << (end - first)) - 1;
      for (uint32_t axis = 0; axis < 3; ++axis) {
        for (uint32_t edges = along[axis] & columns; edges != 0; edges &= edges - 1) {
          const uint32_t bit = trailing_zeros(edges);
          const uint32_t voxel = first + bit - 2;
          const Sample* const sample = samples + size_t{voxel - column} * stride;
          uint32_t lower;
          if (axis == 2)
            lower = kept_distance(voxel);
          else if (axis == 1)
            lower = distance_of(samples_[voxel], doubled_);
          else
            lower =
                distance_of(voxel > column ? *(sample - stride) : samples_[voxel - 1], doubled_);
          const bool is_on = (row.here[word] >> bit & 1) != 0;
          const uint32_t part_of_edge = fraction(lower, distance_of(*sample, doubled_), is_on);
          row.entries[voxel] = static_cast<uint16_t>(row.entries[voxel] | part_of_edge << 3 * axis);
          *row.has_fractions = true;
        }
      }
    }
  }

  /// Keeps the samples of this row.
  static void keep(const Sample* samples, uint32_t count, uint32_t stride, Sample* kept) {
    if (stride == 1 && are_words(samples) && are_words(kept)) {
      for (; count >= per_four_words; count -= per_four_words) {
        *reinterpret_cast<FourWords*>(kept) = *reinterpret_cast<const FourWords*>(samples);
        kept += per_four_words;
        samples += per_four_words;
      }
    }
    for (; count > 0; --count, samples += stride) *kept++ = *samples;
  }
  /// Keeps the bit widths of the distances of kept samples, at most 15.
  void keep_distances(uint32_t column, uint32_t count) {
    // Finds samples with the width of the type's lowest sample, which most samples of most scans
    // have.
    const uint32_t far_width = width_of(min_sample, doubled_);
    const trace::Threshold<Sample> far_threshold(threshold_ - (int32_t{1} << far_width >> 1));
    while (count > 0) {
      const uint32_t left_in_block = far_threshold.block - column % far_threshold.block;
      const uint32_t part_count = count < left_in_block ? count : left_in_block;
      const Sample* const part = samples_ + column;
      if (part_count == far_threshold.block && far_threshold.reads_words(part) &&
          far_threshold.is_block_off(part))
        fill_widths(column, far_width);
      else
        keep_widths(column, part_count);
      column += part_count;
      count -= part_count;
    }
  }

 private:
  static constexpr int32_t extent = int32_t{1} << 8 * sizeof(Sample);
  static constexpr int32_t min_sample = trace::min_sample<Sample>;
  static constexpr uint32_t per_four_words = 16 / sizeof(Sample);
  struct alignas(uint32_t) FourWords {
    Sample samples[per_four_words];
  };
  static bool are_words(const Sample* samples) {
    return reinterpret_cast<uintptr_t>(samples) % alignof(FourWords) == 0;
  }

  // Returns the distance to threshold - 1/2. Units: halves. doubled: twice the threshold, less one.
  DISCMC_ALWAYS_INLINE static uint32_t distance_of(Sample sample, uint32_t doubled) {
    const uint32_t difference = 2 * static_cast<uint32_t>(int32_t{sample}) - doubled;
    return (difference ^ (0U - (difference >> 31))) | 1;
  }
  // Returns the bit width of the distance without its half.
  DISCMC_ALWAYS_INLINE static uint32_t width_of(Sample sample, uint32_t doubled) {
    const uint32_t width = bit_width_of_nonzero(distance_of(sample, doubled)) - 1;
    return sizeof(Sample) == 1 ? width : limited(width);
  }
  // Limits a width to 15. Limit: at most 16.
  static uint32_t limited(uint32_t width) { return width - (width >> 4); }

  void keep_width(uint32_t column) {
    uint8_t& pair = distances_[column / 2];
    const uint32_t shift = 4 * (column % 2);
    pair = static_cast<uint8_t>((pair & 0xF0 >> shift) | width_of(samples_[column], doubled_)
                                                             << shift);
  }
  // Limit: count is not 0.
  DISCMC_ALWAYS_INLINE void keep_widths(uint32_t column, uint32_t count) {
    const uint32_t end = column + count;
    if (column % 2 != 0) keep_width(column++);
    if (end % 2 != 0) keep_width(end - 1);
    const Sample* sample = samples_ + column;
    uint8_t* pair = distances_ + column / 2;
    const uint32_t doubled = doubled_;
    const uint8_t* const last = distances_ + end / 2;
    if (pair >= last) return;
    do {
      const uint32_t even = width_of(sample[0], doubled), odd = width_of(sample[1], doubled);
      *pair++ = static_cast<uint8_t>(even | odd << 4);
      sample += 2;
    } while (pair != last);
  }
  // Stores one width for a whole block.
  void fill_widths(uint32_t column, uint32_t width) {
    uint8_t* const pair = distances_ + column / 2;
    DISCMC_UNROLL(8)
    for (uint32_t i = 0; i < trace::Threshold<Sample>::block / 2; ++i)
      pair[i] = static_cast<uint8_t>(0x11 * width);
  }
  uint32_t kept_distance(uint32_t voxel) const {
    const uint32_t width = distances_[voxel / 2] >> 4 * (voxel % 2) & 15;
    return width == 0 ? 1 : uint32_t{3} << (width - 1);
  }

  // Returns the part of the edge that contains the crossing. Units: eighths from the lower end.
  uint32_t fraction(uint32_t lower, uint32_t upper, bool is_upper_on) const {
    const uint32_t edge = lower + upper;
    // Twice the distance from the end that is off, or from the middle if it is beyond.
    uint32_t doubled = 2 * (is_upper_on ? lower : upper);
    uint32_t eighths = levels_ == 2 ? 2 : 1;
    if (doubled >= edge) {
      eighths += 4;
      doubled -= edge;
    }
    if (levels_ == 4 && 2 * doubled >= edge) eighths += 2;
    return is_upper_on ? eighths : 8 - eighths;
  }

  int32_t threshold_;
  uint32_t doubled_;
  uint32_t levels_;
  const Sample* samples_;
  uint8_t* distances_;
};

}  // namespace discmc::detail::slices

#endif
