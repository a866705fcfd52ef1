// A sink that makes polygons of regions, with simple rings.
#ifndef DISCMC_MESH_SURFACE_SURFACE_BUILDER_HPP
#define DISCMC_MESH_SURFACE_SURFACE_BUILDER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "array.hpp"
#include "counts.hpp"
#include "host/one_ring_region.hpp"
#include "surface.hpp"

namespace discmc::meshing {

/// The result that a SurfaceBuilder keeps: polygons, or only counts, which need no memory.
enum class Kept { polygons, counts };

/// Makes polygons of the events of an extractor or a decoder. Accepts every event. Limit: loose
/// fragments have been joined.
/// Memory: one region at a time, in proportion to its runs, not to its links. A few bytes of a
/// hostile stream can encode any number of links.
/// Errors: accept() and append() throw std::length_error beyond the limit of Polygons.
class SurfaceBuilder {
 public:
  /// jobs: threads that sort the polygons.
  explicit SurfaceBuilder(Kept kept = Kept::polygons, unsigned jobs = 1)
      : kept_(kept), jobs_(jobs) {}

  SinkResult accept(const Event& event);
  /// Accepts a region instead of its events.
  void accept_region(const OneRingRegion& region);

  Kept kept() const { return kept_; }

  /// Appends the polygons or counts of another builder. Limit: both keep the same kind.
  void append(SurfaceBuilder&& other);

  /// Returns the surface so far; the caller sets spacing_mm. A `finish` event sorts the polygons,
  /// so their order does not depend on the division of the scan.
  Surface& surface() { return surface_; }
  const Surface& surface() const { return surface_; }
  /// Limit: Kept::counts.
  const Counts& counts() const { return counts_; }

  /// Returns the number of regions and loose fragments that gave no polygon.
  std::uint64_t incomplete_regions() const { return incomplete_regions_; }

 private:
  struct OpenRing {
    Vertex start;
    std::size_t first_run;
  };
  // A ring of the current region, by its runs.
  struct Chain {
    Vertex start;
    const Run* begin;
    const Run* end;
  };

  // A simple ring of the current region, by its corners.
  struct Span {
    std::size_t begin, end;
  };

  void end_region();
  void begin_polygon();
  void end_polygon();
  Chain chain(std::size_t ring) const;
  bool is_sound(const Chain& chain) const;
  bool read_region_corners(const OneRingRegion& region);
  bool read_chain_corners(const Chain& chain);
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
  unsigned jobs_;
  Surface surface_;
  Counts counts_;
  std::uint64_t incomplete_regions_ = 0;
  Incidence incidence_ = no_incidence;
  // The current region.
  std::vector<OpenRing> rings_;
  std::vector<Run> runs_;
  std::vector<OctahedralNormal> normals_;  // at the starts of runs
  std::vector<Span> simple_rings_;
  Array<Vertex> corners_;
  // Buffers of one ring, whose memory is kept.
  std::vector<Vertex> ends_;          // the start and the corners of the ring
  std::vector<std::uint32_t> slots_;  // indexes of ends, hashed
  std::vector<Vertex> vertices_;      // the ends, also those within other sides, in order
  std::vector<std::int32_t> touches_;
  std::vector<std::uint32_t> scratch_;
};

}  // namespace discmc::meshing

#endif
