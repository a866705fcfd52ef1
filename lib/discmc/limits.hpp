// The size limits of a scan, and the features of an extractor.
#ifndef DISCMC_LIMITS_HPP
#define DISCMC_LIMITS_HPP

#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// The surroundings of the volume.
enum class Border : uint8_t {
  closed,  ///< a halo of off voxels: the surface is closed; coordinates -1 to 2 * extent - 1
  open,    ///< nothing: the surface ends at the outermost voxels; coordinates 0 to 2 * extent - 2
};

/// The slices of a volume that one extractor scans. If the volume continues, also push one slice of
/// the neighbour, before the first or after the last own slice. Boundaries that cross the seam
/// leave as loose fragments; a Joiner joins them with those of the other slabs.
struct Slab {
  uint32_t first = 0;  ///< number of its first own slice in the volume
  bool continues_below = false;
  bool continues_above = false;
};

/// The size of a slice. Memory does not limit the number of slices.
struct Limits {
  static constexpr uint32_t max_extent = 32766;
  static constexpr uint32_t max_slices = (uint32_t{1} << 30) - 1;

  uint32_t width;   ///< voxels per row; Limit: 1 to max_extent
  uint32_t height;  ///< rows per slice; Limit: 1 to max_extent
  Border border = Border::closed;
  Slab slab = {};  ///< default: the whole volume; Limit: first > 0 exactly if it continues below

  constexpr bool is_valid() const {
    return width >= 1 && width <= max_extent && height >= 1 && height <= max_extent &&
           border <= Border::open && slab.first < max_slices &&
           slab.continues_below == (slab.first > 0);
  }
};

/// What an extractor supports beside whole volumes with a closed border. Firmware that needs less
/// passes a struct derived from this one to Extractor and saves flash (FOOTPRINT.md):
///
///   struct Features : AllFeatures {
///     static constexpr bool slabs = false;
///   };
struct AllFeatures {
  static constexpr bool open_border = true;  ///< Border::open
  static constexpr bool slabs = true;        ///< Limits::slab
  static constexpr bool cell_counts = true;  ///< cells, facets and classic_triangles in Statistics
  static constexpr bool holes_wait = true;   ///< else holes are loose fragments, in any memory
};

}  // namespace discmc

#endif
