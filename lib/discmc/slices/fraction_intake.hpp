// Finds the fractions of a row while its samples arrive.
//
// The fraction of an edge follows from the distances of its two samples to the threshold. The
// sample of the row before is kept. A sample of the slice before takes half a byte: the bit width
// of its distance. The middle of that range replaces the distance.
#ifndef DISCMC_SLICES_FRACTION_INTAKE_HPP
#define DISCMC_SLICES_FRACTION_INTAKE_HPP

#include <discmc/slices/fractions.hpp>

namespace discmc::detail::slices {

/// The arriving row of one surface, and what is kept of the samples before it.
template <class Sample>
class FractionIntake {
 public:
  /// The bytes that a row of distances takes.
  static constexpr uint32_t distance_bytes(uint32_t width) { return (width + 1) / 2; }

  /// samples_before: row y - 1 from the column of the arriving samples on, before it this row.
  /// distances: distance_bytes() of this row in the slice before.
  FractionIntake(const FractionRow& row, int32_t threshold, uint32_t levels,
                 const Sample* samples_before, uint8_t* distances)
      : row_(row),
        threshold_(static_cast<uint32_t>(threshold < least            ? least
                                         : threshold > least + extent ? least + extent
                                                                      : threshold)),
        levels_(levels),
        before_(samples_before),
        distances_(distances) {}

  /// Finds the fractions whose upper end is among these samples, and keeps the distances. Limit:
  /// the bits of the samples are in the row.
  void take(const Sample* samples, uint32_t column, uint32_t count, uint32_t stride) {
    const uint32_t end = column + count;
    for (uint32_t word = trace::word_of(column + 1); word <= trace::word_of(end); ++word) {
      // Column x + 1 is bit x + 2 of word 0.
      const uint32_t first = word * trace::columns_per_word;
      uint32_t columns = trace::own_columns;
      if (column + 1 > first) columns &= 0U - (uint32_t{2} << (column + 1 - first));
      if (end - first < trace::columns_per_word) columns &= (uint32_t{4} << (end - first)) - 1;
      const uint32_t x = row_.crossing(word, 0) & columns;
      const uint32_t y = row_.crossing(word, 1) & columns;
      const uint32_t z = row_.crossing(word, 2) & columns;
      for (uint32_t any = x | y | z; any != 0; any &= any - 1) {
        const uint32_t bit = any & (0U - any);
        const uint32_t voxel = first + trailing_zeros(any) - 2;
        const Sample* const sample = samples + size_t{voxel - column} * stride;
        const uint32_t distance = distance_of(*sample);
        const bool is_on = (row_.here[word] & bit) != 0;
        uint32_t entry = 0;
        if ((x & bit) != 0) {
          const Sample left = voxel > column ? *(sample - stride) : before_[voxel - 1];
          entry = fraction(distance_of(left), distance, is_on);
        }
        if ((y & bit) != 0) entry |= fraction(distance_of(before_[voxel]), distance, is_on) << 3;
        if ((z & bit) != 0) entry |= fraction(kept_distance(voxel), distance, is_on) << 6;
        row_.now[voxel] = static_cast<uint16_t>(entry);
      }
    }
    keep(samples, column, count, stride);
  }

 private:
  static constexpr int32_t extent = int32_t{1} << 8 * sizeof(Sample);
  static constexpr int32_t least = Sample(-1) < 0 ? -(extent / 2) : 0;

  // The distance to threshold - 1/2. Units: halves.
  uint32_t distance_of(Sample sample) const { return 2 * below_zero_folded(sample) + 1; }
  // sample - threshold if that is at least 0, otherwise threshold - sample - 1.
  uint32_t below_zero_folded(Sample sample) const {
    const uint32_t difference = static_cast<uint32_t>(int32_t{sample}) - threshold_;
    return difference ^ (0U - (difference >> 31));
  }
  uint32_t kept_distance(uint32_t voxel) const {
    const uint32_t width = distances_[voxel / 2] >> 4 * (voxel % 2) & 15;
    return width == 0 ? 1 : uint32_t{3} << (width - 1);
  }

  // Which part of the edge contains the crossing. Units: eighths from the lower end.
  uint32_t fraction(uint32_t lower, uint32_t upper, bool upper_is_on) const {
    const uint32_t whole = lower + upper;
    uint32_t rest = 2 * (upper_is_on ? lower : upper);  // of the end that is off
    uint32_t eighths = levels_ == 2 ? 2 : 1;
    if (rest >= whole) {
      eighths += 4;
      rest -= whole;
    }
    if (levels_ == 4 && 2 * rest >= whole) eighths += 2;
    return upper_is_on ? eighths : 8 - eighths;
  }

  // Keeps the bit widths of the distances, at most 15.
  void keep(const Sample* samples, uint32_t column, uint32_t count, uint32_t stride) {
    uint8_t* to = distances_ + column / 2;
    if (column % 2 != 0) {
      *to = static_cast<uint8_t>((*to & 15) | kept_width(*samples) << 4);
      ++to;
      samples += stride;
      --count;
    }
    for (; count >= 2; count -= 2) {
      const uint32_t even = kept_width(*samples);
      samples += stride;
      *to++ = static_cast<uint8_t>(even | kept_width(*samples) << 4);
      samples += stride;
    }
    if (count > 0) *to = static_cast<uint8_t>((*to & 0xF0) | kept_width(*samples));
  }
  uint32_t kept_width(Sample sample) const {
    const uint32_t width = bit_width(below_zero_folded(sample));
    return sizeof(Sample) == 1 ? width : width - (width >> 4);
  }

  const FractionRow& row_;
  uint32_t threshold_;
  uint32_t levels_;
  const Sample* before_;
  uint8_t* distances_;
};

}  // namespace discmc::detail::slices

#endif
