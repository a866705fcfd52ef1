// A sink that puts a scan together again: regions whole, rings simple.
#ifndef DISCMC_COMMAND_SURFACE_SURFACE_BUILDER_HPP
#define DISCMC_COMMAND_SURFACE_SURFACE_BUILDER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

#include "surface.hpp"

namespace discmc::command {

/// Takes events of an extractor or a decoder and always answers "taken". Loose fragments are to be
/// joined before.
/// Throws std::runtime_error beyond max_links, since a few bytes of a hostile stream can stand for
/// any number of links.
class SurfaceBuilder {
 public:
  static constexpr std::uint64_t max_links = std::uint64_t{1} << 27;

  SinkResult take(const Event& event);

  /// Adds the polygons of another, behind its own. Throws as take().
  void append(SurfaceBuilder&& other);

  /// What has been delivered so far; spacing_mm is for the caller to set.
  Surface& surface() { return surface_; }
  const Surface& surface() const { return surface_; }

  /// Regions and loose fragments that could not be made polygons of.
  std::uint64_t incomplete_regions() const { return incomplete_regions_; }

 private:
  // A run and the normal where it starts.
  struct PlacedRun {
    Run run;
    OctahedralNormal normal;
  };
  struct OpenRing {
    Vertex start;
    std::size_t first_run;
  };
  // A ring of the region under way, by its runs.
  struct Chain {
    Vertex start;
    const PlacedRun* begin;
    const PlacedRun* end;
  };

  // A simple ring of the region under way, by its corners.
  struct Span {
    std::size_t begin, end;
  };

  void end_region();
  void add_links(std::uint64_t links);
  Chain chain(std::size_t ring) const;
  bool is_sound(const Chain& chain);
  bool is_convex(const Chain& chain) const;
  bool has_recurrence();
  void add_corners(const Chain& chain);
  void end_ring();
  void add_simple_rings(const Chain& chain);
  Ring simple_ring(const Span& span) const;
  bool put_outer_first();
  void add_normals(const Chain& chain);

  Surface surface_;
  std::uint64_t incomplete_regions_ = 0;
  std::uint64_t links_ = 0;  // unfolded so far
  Incidence incidence_ = no_incidence;
  // Of the region under way.
  std::vector<OpenRing> rings_;
  std::vector<PlacedRun> runs_;
  std::vector<Span> simple_rings_;
  std::vector<Vertex> corners_;
  // Of one ring; here to keep the memory.
  std::vector<Run> ring_runs_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> scratch_;
};

}  // namespace discmc::command

#endif
