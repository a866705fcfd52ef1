// Compares samples with a threshold, a word at a time: 4 lanes of 8 bits or 2 of 16.
//
// Most rows of most scans are off, and their samples are far below the threshold. Therefore blocks
// of words that are off are skipped first, which costs a load and an instruction per word.
#ifndef DISCMC_TRACE_THRESHOLD_HPP
#define DISCMC_TRACE_THRESHOLD_HPP

#include <discmc/base/compiler.hpp>

namespace discmc::detail::trace {

/// Returns the least sample of a type.
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

/// Compares all lanes of a word, as unsigned numbers, with a level, by a lane selection of the
/// processor.
template <uint32_t lane_bits, bool selects = has_lane_selection>
class LaneThreshold : public LanesOf<lane_bits> {
  using Lanes = LanesOf<lane_bits>;

 public:
  /// Limit: level <= 2 * half, which no lane reaches.
  explicit LaneThreshold(uint32_t level)
      : level_(level * Lanes::ones), answer_(level < 2 * Lanes::half ? Lanes::tops : 0) {}

  /// Returns the top bits of the lanes that reach the level.
  uint32_t reached(uint32_t word) const {
    return select_lanes<lane_bits>(word, level_, answer_, 0);
  }

 private:
  uint32_t level_;
  uint32_t answer_;
};

/// Likewise compares with instructions of every processor.
template <uint32_t lane_bits>
class LaneThreshold<lane_bits, false> : public LanesOf<lane_bits> {
  using Lanes = LanesOf<lane_bits>;

 public:
  explicit LaneThreshold(uint32_t level)
      : flip_(level > Lanes::half ? ~uint32_t{0} : 0),
        addend_((level > Lanes::half ? level - Lanes::half : Lanes::half - level) * Lanes::ones) {}

  /// A sample reaches a level of at most half if its top bit is set. It also does if adding half -
  /// level to the other bits sets the top bit. No carry reaches the next lane. For higher levels
  /// the complement is compared, and the result is complemented.
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

  /// Whether words of samples can be read here, with the first sample in the lowest bits.
  static bool reads_words(const Sample* samples) {
    return is_little_endian && reinterpret_cast<uintptr_t>(samples) % sizeof(uint32_t) == 0;
  }

  /// Returns the number of samples up to the next word boundary, at least one.
  static uint32_t samples_to_word(const Sample* samples) {
    return lanes - reinterpret_cast<uintptr_t>(samples) / sizeof(Sample) % lanes;
  }

  /// The number of samples in eight words.
  static constexpr uint32_t block = 8 * lanes;
  /// Whether a block is certainly off. Blocks with samples of many values near the threshold are
  /// not recognised. Limit: reads_words(samples).
  bool is_block_off(const Sample* samples) const {
    uint32_t combined = word_at(samples);
    DISCMC_UNROLL(8)
    for (uint32_t word = 1; word < 8; ++word)
      combined |= word_at(samples + word * lanes);  // a bound
    return lanes_.reached(combined) == 0;
  }
  /// Returns the number of leading samples that are certainly off, in whole blocks. Limit:
  /// reads_words(samples).
  uint32_t leading_off(const Sample* samples, uint32_t count) const {
    const Sample* at = samples;
    for (; count >= block; count -= block, at += block)
      if (!is_block_off(at)) break;
    return static_cast<uint32_t>(at - samples);
  }

  /// Sets bit i if samples[i] is on. Limit: reads_words(samples), count <= 32, whole words.
  uint32_t words_reached(const Sample* samples, uint32_t count) const {
    // Multiplication gathers the top bits of the lanes in the topmost bits of the word.
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

  // Returns samples as unsigned numbers of the same order.
  static uint32_t word_at(const Sample* samples) {
    const uint32_t word = aligned_word(samples);
    return min_sample<Sample> < 0 ? word ^ Lanes::tops : word;
  }

  int32_t threshold_;
  Lanes lanes_;
};

}  // namespace discmc::detail::trace

#endif
