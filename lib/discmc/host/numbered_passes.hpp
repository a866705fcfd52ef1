// Passes by number: two bytes name a corner pass, and what a sweep needs of it is at hand.
#ifndef DISCMC_HOST_NUMBERED_PASSES_HPP
#define DISCMC_HOST_NUMBERED_PASSES_HPP

#include <discmc/host/corner_pass.hpp>

namespace discmc::trace {

/// CornerCode::position() of the voxel at the lower end of an edge, and in the lowest 16 bits the
/// number of a corner pass at the vertex there.
using FoundPass = uint64_t;

/// Gives numbers to passes as they first come by.
class NumberedPasses {
 public:
  /// The numbers of the corner passes that a pass consists of: the first one, and how many.
  struct Numbers {
    uint16_t first;
    uint16_t count;
  };

  /// The corner pass that has been found: its `corner` makes the CornerCode of the FoundPass as it
  /// is, number and all.
  const CornerPass& operator[](FoundPass found) const { return numbered_[found & 0xFFFF]; }

  /// Cost: a look-up, once it has come by.
  Numbers of(const Pass& pass, int axis);

  /// How many numbers there are for all passes that exist, 2,256 on the three axes.
  static constexpr uint32_t most = 2760;

 private:
  static constexpr uint32_t place_bits = 12;

  struct Known {
    uint64_t pass;  // its bits
    Numbers numbers;
  };

  Known known_[1U << place_bits] = {};  // by open addressing
  uint32_t count_ = 0;
  CornerPass numbered_[most] = {};
};

}  // namespace discmc::trace

#endif
