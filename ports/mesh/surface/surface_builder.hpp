// A sink that puts a scan together again: regions whole, rings simple.
#ifndef DISCMC_MESH_SURFACE_SURFACE_BUILDER_HPP
#define DISCMC_MESH_SURFACE_SURFACE_BUILDER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "array.hpp"
#include "counts.hpp"
#include "host/whole_region.hpp"
#include "surface.hpp"

namespace discmc::meshing {

/// What a SurfaceBuilder keeps of regions: polygons, or their counts alone, which take no memory.
enum class Kept { polygons, counts };

/// Takes events of an extractor or a decoder and always answers "taken". Loose fragments are to be
/// joined before.
/// Memory: one region at a time, in proportion to its runs, not to its links. A few bytes of a
/// hostile stream can encode any number of links.
/// Errors: accept() and append() throw std::length_error beyond the limit of Polygons.
class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(Kept kept = Kept::polygons) : kept_(kept) {}

  SinkResult accept(const Event& event);
  /// Takes a region in place of its events.
  void accept_region(const WholeRegion& region);

  Kept kept() const { return kept_; }

  /// Adds what another has kept, behind its own. Limit: both keep the same.
  void append(SurfaceBuilder&& other);

  /// What has been delivered so far; spacing_mm is for the caller to set. A `finish` event sorts
  /// the polygons: they do not depend on how the scan was divided, nor does their order.
  Surface& surface() { return surface_; }
  const Surface& surface() const { return surface_; }
  /// Limit: Kept::counts.
  const Counts& counts() const { return counts_; }

  /// Regions and loose fragments that could not be made polygons of.
  std::uint64_t incomplete_regions() const { return incomplete_regions_; }

 private:
  struct OpenRing {
    Vertex start;
    std::size_t first_run;
  };
  // A ring of the region under way, by its runs.
  struct Chain {
    Vertex start;
    const Run* begin;
    const Run* end;
  };

  // A simple ring of the region under way, by its corners.
  struct Span {
    std::size_t begin, end;
  };

  void end_region();
  void begin_polygon();
  void end_polygon();
  Chain chain(std::size_t ring) const;
  bool is_sound(const Chain& chain) const;
  bool add_corners(const WholeRegion& region);
  bool add_corners(const Chain& chain);
  bool is_simple_in_window(std::size_t first_corner) const;
  void end_ring();
  void add_touching_rings(std::size_t first_corner);
  void collect_ends(const Chain& chain);
  bool index_ends();
  bool is_end(const Vertex& vertex) const;
  bool find_touches();
  void add_touches_of(const Vertex& from, const Side& side);
  Ring simple_ring(const Span& span) const;
  bool put_outer_first();
  void sort_holes();
  void keep_or_count();
  void keep_region();
  void keep_normals(std::size_t ring);
  void count_region();

  Kept kept_;
  Surface surface_;
  Counts counts_;
  std::uint64_t incomplete_regions_ = 0;
  Incidence incidence_ = no_incidence;
  // The region under way.
  std::vector<OpenRing> rings_;
  std::vector<Run> runs_;
  std::vector<OctahedralNormal> normals_;  // where the runs start
  std::vector<Span> simple_rings_;
  Array<Vertex> corners_;
  // Buffers of one ring; here to keep the memory.
  std::vector<Vertex> ends_;          // its start and its corners
  std::vector<std::uint32_t> slots_;  // their places, by a hash
  std::vector<Vertex> vertices_;      // the ends, and where a side passes through another one
  std::vector<std::int32_t> touches_;
  std::vector<std::uint32_t> scratch_;
};

}  // namespace discmc::meshing

#endif
