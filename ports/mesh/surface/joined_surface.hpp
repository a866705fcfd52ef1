// The polygons of a scan or of a stream.
#ifndef DISCMC_MESH_SURFACE_JOINED_SURFACE_HPP
#define DISCMC_MESH_SURFACE_JOINED_SURFACE_HPP

#include "growing_joiner.hpp"
#include "surface_builder.hpp"

namespace discmc::meshing {

/// A sink that joins loose fragments, and keeps the polygons or their counts. It points to itself,
/// so it cannot be moved.
class JoinedSurface {
 public:
  explicit JoinedSurface(Kept kept = Kept::polygons, unsigned jobs = 1) : builder_(kept, jobs) {}
  JoinedSurface(const JoinedSurface&) = delete;
  JoinedSurface& operator=(const JoinedSurface&) = delete;

  SinkResult accept(const Event& event) { return joiner_.accept(event); }
  /// Accepts a region instead of its events. Answers `busy` if fragments may belong to it.
  SinkResult accept_region(const OneRingRegion& region) {
    if (joiner_.has_fragments()) return SinkResult::busy;
    builder_.accept_region(region);
    return SinkResult::accepted;
  }
  /// Ends the events.
  void finish() { joiner_.finish(); }

  SurfaceBuilder& builder() { return builder_; }
  const SurfaceBuilder& builder() const { return builder_; }
  Surface& surface() { return builder_.surface(); }
  const Surface& surface() const { return builder_.surface(); }

 private:
  SurfaceBuilder builder_;
  GrowingJoiner joiner_{make_sink(builder_)};
};

}  // namespace discmc::meshing

#endif
