// Comparing samples with a threshold, a word of them at a time: 4 lanes of 8 bits or 2 of 16.
//
// Most rows of most scans are off, and their samples are far below the threshold. So blocks of
// words that are off are passed by first, which takes a load and an instruction a word.
#ifndef DISCMC_TRACE_THRESHOLD_HPP
#define DISCMC_TRACE_THRESHOLD_HPP

#include <discmc/base/compiler.hpp>

namespace discmc::detail::trace {

/// The least sample of a type.
template <class Sample>
inline constexpr int32_t min_sample = Sample(-1) < 0 ? -(int32_t{1} << (8 * sizeof(Sample) - 1))
                                                     : 0;

/// A word of lanes.
template <uint32_t lane_bits>
struct LanesOf {
  static constexpr uint32_t half = uint32_t{1} << (lane_bits - 1);
  static constexpr uint32_t ones = lane_bits == 8 ? 0x01010101 : 0x00010001;
  static constexpr uint32_t tops = ones * half;
};

/// Compares all lanes of a word, as unsigned numbers, with a level: where the processor selects
/// lanes, by doing so.
template <uint32_t lane_bits, bool selects = has_lane_selection>
class LaneThreshold : public LanesOf<lane_bits> {
  using Lanes = LanesOf<lane_bits>;

 public:
  /// Limit: level <= 2 * half, which no lane reaches.
  explicit LaneThreshold(uint32_t level)
      : level_(level * Lanes::ones), answer_(level < 2 * Lanes::half ? Lanes::tops : 0) {}

  /// The top bits of the lanes that reach the level.
  uint32_t reached(uint32_t word) const {
    return select_lanes<lane_bits>(word, level_, answer_, 0);
  }

 private:
  uint32_t level_;
  uint32_t answer_;
};

/// The same by what every processor has.
template <uint32_t lane_bits>
class LaneThreshold<lane_bits, false> : public LanesOf<lane_bits> {
  using Lanes = LanesOf<lane_bits>;

 public:
  explicit LaneThreshold(uint32_t level)
      : flip_(level > Lanes::half ? ~uint32_t{0} : 0),
        addend_((level > Lanes::half ? level - Lanes::half : Lanes::half - level) * Lanes::ones) {}

  /// A sample reaches a level of at most half if its top bit is set, or becomes set by adding half
  /// - level to the rest. There is no carry into the next lane. For higher levels the complement is
  /// compared, and the result is complemented.
  uint32_t reached(uint32_t word) const {
    const uint32_t lanes = word ^ flip_;
    return ((lanes | ((lanes & ~Lanes::tops) + addend_)) ^ flip_) & Lanes::tops;
  }

 private:
  uint32_t flip_;
  uint32_t addend_;
};

/// A threshold of any value for samples of type uint8_t, uint16_t or int16_t.
template <class Sample>
class Threshold {
 public:
  static constexpr uint32_t lanes = sizeof(uint32_t) / sizeof(Sample);

  explicit Threshold(int32_t threshold)
      : threshold_(threshold),
        lanes_(static_cast<uint32_t>(threshold < min_sample<Sample> ? 0
                                     : threshold > min_sample<Sample> + 2 * half
                                         ? 2 * half
                                         : threshold - min_sample<Sample>)) {}

  bool reached(Sample sample) const { return int32_t{sample} >= threshold_; }

  /// Whether words of samples can be read here, the first sample lowest.
  static bool reads_words(const Sample* samples) {
    return is_little_endian && reinterpret_cast<uintptr_t>(samples) % sizeof(uint32_t) == 0;
  }

  /// Samples from here to where the next word begins, at least one.
  static uint32_t samples_to_word(const Sample* samples) {
    return lanes - reinterpret_cast<uintptr_t>(samples) / sizeof(Sample) % lanes;
  }

  /// Samples of eight words.
  static constexpr uint32_t block = 8 * lanes;
  /// Whether a block is certainly off. Blocks with samples of many values near the threshold are
  /// not recognised. Limit: reads_words(samples).
  bool block_is_off(const Sample* samples) const {
    uint32_t most = word_at(samples);
    DISCMC_UNROLL(8)
    for (uint32_t word = 1; word < 8; ++word) most |= word_at(samples + word * lanes);  // a bound
    return lanes_.reached(most) == 0;
  }
  /// How many samples from the first on are certainly off, in whole blocks. Limit:
  /// reads_words(samples).
  uint32_t leading_off(const Sample* samples, uint32_t count) const {
    const Sample* at = samples;
    for (; count >= block; count -= block, at += block)
      if (!block_is_off(at)) break;
    return static_cast<uint32_t>(at - samples);
  }

  /// Bit i: whether samples[i] is on. Limit: reads_words(samples), count <= 32, whole words.
  uint32_t words_reached(const Sample* samples, uint32_t count) const {
    // Multiplies the top bits of the lanes into the topmost bits of the word.
    constexpr uint32_t gather = lanes == 4 ? 1 | 1 << 7 | 1 << 14 | 1 << 21 : 1 | 1 << 15;
    uint32_t bits = 0;
    for (const Sample* end = samples + count; end != samples;) {
      end -= lanes;
      bits = bits << lanes | lanes_.reached(word_at(end)) * gather >> (32 - lanes);
    }
    return bits;
  }

 private:
  using Lanes = LaneThreshold<8 * sizeof(Sample)>;
  static constexpr int32_t half = Lanes::half;

  // Samples as unsigned numbers of the same order.
  static uint32_t word_at(const Sample* samples) {
    const uint32_t word = aligned_word(samples);
    return min_sample<Sample> < 0 ? word ^ Lanes::tops : word;
  }

  int32_t threshold_;
  Lanes lanes_;
};

}  // namespace discmc::detail::trace

#endif
