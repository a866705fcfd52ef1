// The slices of a slab, and the further slices that its extraction reads.
#ifndef DISCMC_MESH_EXTRACTION_SLAB_SPANS_HPP
#define DISCMC_MESH_EXTRACTION_SLAB_SPANS_HPP

#include <algorithm>
#include <cstdint>
#include <optional>

#include <discmc/limits.hpp>
#include <discmc/placement.hpp>

namespace discmc::meshing {

/// Successive slices of a volume.
struct SliceSpan {
  std::uint32_t first, end;

  bool holds(std::uint32_t z) const { return z >= first && z < end; }
  std::uint32_t count() const { return end - first; }
  /// Returns the slices with this many more on either side, as far as the volume has them.
  SliceSpan widened(std::uint32_t slices, std::uint32_t depth) const {
    return {first > slices ? first - slices : 0, end + std::min(slices, depth - end)};
  }
};

struct SlabSpans {
  SliceSpan own;
  SliceSpan pushed;  ///< to the extractor: includes a slice of each neighbour
  SliceSpan read;    ///< read for the pushed slices: a MajorityFilter needs one more on either side
};

/// slab: nothing for the whole volume. depth: of the volume.
inline SliceSpan slices_of(const std::optional<SlabRange>& slab, std::uint32_t depth) {
  return slab ? SliceSpan{slab->first, slab->end()} : SliceSpan{0, depth};
}

/// own: the slices of the slab. depth: of the volume.
inline SlabSpans slab_spans(const SliceSpan& own, std::uint32_t depth, bool filters_by_majority) {
  const SliceSpan pushed = own.widened(1, depth);
  return {own, pushed, pushed.widened(filters_by_majority ? 1 : 0, depth)};
}

/// Returns the slab in the form of the extractor. depth: of the volume.
inline Slab slab_limits(const SlabRange& slab, std::uint32_t depth) {
  return {slab.first, slab.first > 0, slab.end() < depth};
}

}  // namespace discmc::meshing

#endif
