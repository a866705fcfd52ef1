// The learnt model of fractions: the part of an edge in which the surface crosses it. Each bit of a
// fraction is a decision, the higher bit first. Each context has a tree of decisions. A tree of 2
// levels has only the higher bit. A tree of 4 also has the lower bit, after a 0 and after a 1.
#ifndef DISCMC_SLICES_FRACTION_MODEL_HPP
#define DISCMC_SLICES_FRACTION_MODEL_HPP

#include <discmc/base/arena.hpp>
#include <discmc/stream/range_coder.hpp>

namespace discmc::detail::slices {

namespace fraction_context {

// The trees of edges: see FractionCode::context_of().
constexpr uint32_t lines = 7, off_ends = 4, on_ends = 4, forwards = 4;
constexpr uint32_t edges = lines * off_ends * on_ends * forwards;
// The trees of edges along z into a key slice, by the previous fraction in the row: 0 for none, or
// up to 7.
constexpr uint32_t key_edge = edges;
constexpr uint32_t trees = key_edge + 5;
// The bit width of the number of these edges in a row, coded as that many ones and a zero.
constexpr uint32_t count_widths = 16;

}  // namespace fraction_context

/// A learnt probability that adapts fast at first, because each context has few fractions per
/// slice. Units: 8,192nds, in the upper 13 bits. The lower 3 bits count its decisions, up to 7.
class FractionProbability {
 public:
  constexpr operator LearntProbability() const { return LearntProbability(one_); }
  /// Adapts to a bit: by half of the way to certainty at first, later by a 32nd.
  constexpr void learn(bool bit) {
    constexpr uint32_t max_count = 7;
    const uint32_t count = one_ & max_count;
    const uint32_t rate = (count + 3) >> 1;
    uint32_t one = one_ >> 3;
    one = bit ? one + ((8191 - one) >> rate) : one - (one >> rate);
    one_ = static_cast<uint16_t>(one << 3 | (count < max_count ? count + 1 : max_count));
  }

 private:
  uint16_t one_ = 0x8000;  // probability of a 1, and the count
};

class FractionModel {
 public:
  /// Limit: levels is 2 or 4.
  static constexpr uint32_t count(uint32_t levels) {
    return fraction_context::count_widths + fraction_context::trees * (levels - 1);
  }
  static constexpr uint64_t bytes_for(uint32_t levels) {
    return Arena::bytes_of(count(levels), sizeof(FractionProbability));
  }
  /// Allocates bytes_for() in the arena, and writes nothing.
  void start(Arena& arena, uint32_t levels) {
    levels_ = levels;
    probabilities_ = arena.allocate<FractionProbability>(count(levels));
  }
  /// Resets all: both values of each bit are equally likely.
  void begin() {
    for (uint32_t i = 0; i < count(levels_); ++i) probabilities_[i] = FractionProbability();
  }

  /// Returns the number of bits of a fraction, 1 or 2.
  uint32_t bits() const { return levels_ / 2; }
  FractionProbability* width(uint32_t ones) { return probabilities_ + ones; }
  FractionProbability* tree(uint32_t context) {
    return probabilities_ + fraction_context::count_widths + context * (levels_ - 1);
  }

 private:
  FractionProbability* probabilities_ = nullptr;
  uint32_t levels_ = 0;
};

}  // namespace discmc::detail::slices

#endif
