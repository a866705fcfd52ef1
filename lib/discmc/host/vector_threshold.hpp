// Comparing 32 samples with a threshold at once, where there are vectors.
#ifndef DISCMC_HOST_VECTOR_THRESHOLD_HPP
#define DISCMC_HOST_VECTOR_THRESHOLD_HPP

#include <discmc/compiler.hpp>
#include <discmc/host/vector.hpp>

namespace discmc::trace {

/// A threshold of any value for samples of type uint8_t, uint16_t or int16_t.
template <class Sample>
class VectorThreshold {
 public:
  /// Samples that are compared at once.
  static constexpr uint32_t lanes = 32;

  // A sample is on when it is above the threshold less one; none is above the greatest.
  explicit VectorThreshold(int32_t threshold)
      : bound_(fill(static_cast<Sample>(threshold > least && threshold <= greatest ? threshold - 1
                                                                                   : greatest))),
        always_(threshold <= least ? ~uint32_t{0} : 0) {}

  /// Bit i: whether samples[i] is on, for 32 samples at any address.
  uint32_t reached(const Sample* samples) const {
    constexpr uint32_t bytes = sizeof(Vector);
    Vector on[2];
    DISCMC_UNROLL(2)
    for (uint32_t i = 0; i < 2; ++i) {
      const Sample* const at = samples + bytes * i;
      if constexpr (sizeof(Sample) == 1)
        on[i] = above<Sample>(load(at), bound_);
      else
        on[i] =
            narrow(above<Sample>(load(at), bound_), above<Sample>(load(at + bytes / 2), bound_));
    }
    return nonzero(on) | always_;
  }

 private:
  static constexpr int32_t least = Sample(-1) < 0 ? -(1 << (8 * sizeof(Sample) - 1)) : 0;
  static constexpr int32_t greatest = least + (1 << 8 * sizeof(Sample)) - 1;

  Vector bound_;
  uint32_t always_;
};

}  // namespace discmc::trace

#endif
