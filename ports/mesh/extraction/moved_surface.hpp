// Moves a surface that was extracted within a box of its volume.
#ifndef DISCMC_MESH_EXTRACTION_MOVED_SURFACE_HPP
#define DISCMC_MESH_EXTRACTION_MOVED_SURFACE_HPP

#include <array>
#include <cstdint>

#include "surface/joined_surface.hpp"

namespace discmc::meshing {

/// Moves the events and regions of a box to its position in the volume.
class MovedSurface {
 public:
  /// surface: Owner: the caller. first: the box's first voxel in the volume.
  MovedSurface(JoinedSurface& surface, const std::array<std::uint32_t, 3>& first)
      : surface_(surface),
        offset_{half_steps(first[0]), half_steps(first[1]), half_steps(first[2])} {}

  SinkResult accept(const Event& event) {
    Event moved = event;
    moved.start = event.start + offset_;
    return surface_.accept(moved);
  }
  SinkResult accept_region(const OneRingRegion& region) {
    OneRingRegion moved = region;
    moved.move(offset_);
    return surface_.accept_region(moved);
  }

  /// Returns the vector from the origin of the volume to the box.
  const Vertex& offset() const { return offset_; }

 private:
  static std::int32_t half_steps(std::uint32_t voxels) {
    return static_cast<std::int32_t>(2 * voxels);
  }

  JoinedSurface& surface_;
  Vertex offset_;
};

}  // namespace discmc::meshing

#endif
