// Extracts the voxels of a label from successive slices.
#ifndef DISCMC_MESH_EXTRACTION_LABEL_RUN_HPP
#define DISCMC_MESH_EXTRACTION_LABEL_RUN_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/limits.hpp>

#include "host/host_scan.hpp"
#include "surface/joined_surface.hpp"

namespace discmc::meshing {

/// Collects the voxels of one label from its first slice to its last, then extracts their surface
/// within their box. A label therefore costs nothing in slices without it, nor beside its voxels; a
/// label that reappears gets a further run. Memory: 12 bytes per row of voxels.
class LabelRun {
 public:
  /// first: the first slice with a voxel of the label.
  explicit LabelRun(std::uint32_t first) : first_(first), slice_(first) {}

  /// Adds voxels of the current slice: of row y, from `begin` to before `end`.
  void add(std::uint32_t y, std::uint32_t begin, std::uint32_t end);

  /// Ends the current slice.
  void end_slice();

  /// Whether no later slice can change the surface, with or without a filter.
  bool is_over() const { return slices_without_voxels_ == 2; }

  /// Extracts the surface of all voxels. limits: of the volume. filters_by_majority: whether the
  /// bits pass a MajorityFilter. scan: may be reused.
  void extract(const Limits& limits, bool filters_by_majority, HostScan& scan,
               JoinedSurface& surface) const;

 private:
  struct Stretch {
    std::uint32_t slice;
    std::uint16_t y, begin, end;
  };

  std::uint32_t first_, slice_;  // slice_: the current one
  bool has_voxels_ = false;      // of the current slice
  std::uint32_t slices_without_voxels_ = 0;
  std::vector<Stretch> stretches_;
};

}  // namespace discmc::meshing

#endif
