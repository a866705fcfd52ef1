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
  FractionIntake(const FractionRow& row, int32_t threshold, uint32_t levels, Sample* samples_before,
                 uint8_t* distances)
      : row_(row),
        threshold_(static_cast<uint32_t>(threshold < least            ? least
                                         : threshold > least + extent ? least + extent
                                                                      : threshold)),
        levels_(levels),
        before_(samples_before),
        distances_(distances) {}

  /// Finds the fractions whose upper end is among these samples. Limit: the bits of the samples are
  /// in the row.
  void find(const Sample* samples, uint32_t column, uint32_t count, uint32_t stride) {
    if (row_.is_off()) return;
    const uint32_t end = column + count;
    for (uint32_t word = trace::word_of(column + 1); word <= trace::word_of(end); ++word) {
      uint32_t crossing[3];
      if (!row_.find(word, crossing)) continue;
      // Column x + 1 is bit x + 2 of word 0.
      const uint32_t first = word * trace::columns_per_word;
      uint32_t columns = trace::own_columns;
      if (column + 1 > first) columns &= 0U - (uint32_t{2} << (column + 1 - first));
      if (end - first < trace::columns_per_word) columns &= (uint32_t{4} << (end - first)) - 1;
      for (uint32_t any = (crossing[0] | crossing[1] | crossing[2]) & columns; any != 0;
           any &= any - 1) {
        const uint32_t bit = trailing_zeros(any);
        const uint32_t voxel = first + bit - 2;
        const Sample* const sample = samples + size_t{voxel - column} * stride;
        const uint32_t distance = distance_of(*sample);
        const bool is_on = (row_.here[word] >> bit & 1) != 0;
        uint32_t entry = row_.now[voxel];
        for (uint32_t axis = 0; axis < 3; ++axis) {
          if ((crossing[axis] >> bit & 1) == 0) continue;
          uint32_t lower;
          if (axis == 2)
            lower = kept_distance(voxel);
          else if (axis == 1)
            lower = distance_of(before_[voxel]);
          else
            lower = distance_of(voxel > column ? *(sample - stride) : before_[voxel - 1]);
          entry |= fraction(lower, distance, is_on) << 3 * axis;
        }
        row_.now[voxel] = static_cast<uint16_t>(entry);
        *row_.is_any = true;
      }
    }
  }

  /// Keeps the samples, and the bit widths of their distances, at most 15.
  void keep(const Sample* samples, uint32_t column, uint32_t count, uint32_t stride) {
    const uint32_t end = column + count;
    const uint32_t doubled = 2 * threshold_ - 1;
    if (column % 2 != 0) {
      keep_one(column++, *samples);
      samples += stride;
    }
    Sample* kept = before_ + column;
    uint8_t* to = distances_ + column / 2;
    const uint8_t* const last = distances_ + end / 2;
    while (to < last) {
      const Sample even = samples[0], odd = samples[stride];
      samples += 2 * stride;
      *kept++ = even;
      *kept++ = odd;
      *to++ = static_cast<uint8_t>(kept_width(even, doubled) | kept_width(odd, doubled) << 4);
    }
    if (end % 2 != 0 && column < end) keep_one(end - 1, *samples);
  }

 private:
  static constexpr int32_t extent = int32_t{1} << 8 * sizeof(Sample);
  static constexpr int32_t least = Sample(-1) < 0 ? -(extent / 2) : 0;

  // The distance to threshold - 1/2. Units: halves.
  uint32_t distance_of(Sample sample) const { return 2 * folded(sample, threshold_) + 1; }
  // sample - threshold if that is at least 0, otherwise threshold - sample - 1.
  DISCMC_ALWAYS_INLINE static uint32_t folded(Sample sample, uint32_t threshold) {
    const uint32_t difference = static_cast<uint32_t>(int32_t{sample}) - threshold;
    return difference ^ (0U - (difference >> 31));
  }
  // Its bit width, at most 15. doubled: twice the threshold, less one. The distance in halves is a
  // bit longer; its lowest bit is set.
  DISCMC_ALWAYS_INLINE static uint32_t kept_width(Sample sample, uint32_t doubled) {
    const uint32_t difference = 2 * static_cast<uint32_t>(int32_t{sample}) - doubled;
    const uint32_t halves = (difference ^ (0U - (difference >> 31))) | 1;
    const uint32_t width = bit_width_of_nonzero(halves) - 1;
    return sizeof(Sample) == 1 ? width : width - (width >> 4);
  }
  void keep_one(uint32_t voxel, Sample sample) {
    before_[voxel] = sample;
    uint8_t& pair = distances_[voxel / 2];
    const uint32_t shift = 4 * (voxel % 2);
    pair = static_cast<uint8_t>((pair & 0xF0 >> shift) | kept_width(sample, 2 * threshold_ - 1)
                                                             << shift);
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

  FractionRow row_;
  uint32_t threshold_;
  uint32_t levels_;
  Sample* before_;
  uint8_t* distances_;
};

}  // namespace discmc::detail::slices

#endif
