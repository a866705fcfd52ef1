// The size of a scan, and the abilities of an extractor.
#ifndef DISCMC_LIMITS_HPP
#define DISCMC_LIMITS_HPP

#include <stdint.h>
#include <discmc/base/compiler.hpp>

namespace discmc {

/// The surroundings of the volume. In the coordinates below, which count half-steps, `extent` is
/// the number of voxels along an axis.
enum class Border : uint8_t {
  closed,  ///< voxels outside are off, so the surface is closed; coordinates -1 to 2 * extent - 1
  open,    ///< the surface ends at the outermost voxels; coordinates 0 to 2 * extent - 2
};

/// The slices of a volume that one of several extractors scans: its own slices. If the volume
/// continues below them, push one context slice first: the last slice of the slab below. If the
/// volume continues above, push one context slice last: the first slice of the slab above.
///
/// Events have the coordinates of the whole volume. Boundaries that cross a seam leave as loose
/// fragments; a Joiner with InputOrder::any joins those of all slabs.
struct Slab {
  uint32_t first = 0;            ///< the number of the first own slice in the volume
  bool continues_below = false;  ///< a context slice precedes; Limit: exactly if first > 0
  bool continues_above = false;  ///< a context slice follows
};

/// The size of a scan. Memory depends on the size of a slice, not on the number of slices.
struct Limits {
  static constexpr uint32_t max_extent = 32766;
  static constexpr uint32_t max_slices = (uint32_t{1} << 30) - 1;  ///< of a volume

  uint32_t width;   ///< voxels per row; Limit: 1 to max_extent
  uint32_t height;  ///< rows per slice; Limit: 1 to max_extent
  Border border = Border::closed;
  Slab slab = {};  ///< default: the whole volume

  /// Whether all members keep their limits; start() returns bad_limits otherwise.
  constexpr bool is_valid() const {
    return width >= 1 && width <= max_extent && height >= 1 && height <= max_extent &&
           border <= Border::open && slab.first < max_slices &&
           slab.continues_below == (slab.first > 0);
  }
};
static_assert(2 * int64_t{Limits::max_slices} - 1 <= INT32_MAX,
              "z of the last vertices has 32 bits");
static_assert(uint64_t{Limits::max_extent + 1} * (Limits::max_extent + 1) <= UINT32_MAX,
              "32 bits count the cells of a slice");

}  // namespace discmc

#endif
