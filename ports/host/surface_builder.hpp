// A sink that puts a scan together again: regions whole, fragments back in place, rings simple.
#ifndef DISCMC_HOST_SURFACE_BUILDER_HPP
#define DISCMC_HOST_SURFACE_BUILDER_HPP

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <discmc/sink.hpp>

#include "surface.hpp"

namespace discmc::host {

/// Takes events of an extractor or a decoder and always answers "taken".
/// Throws std::runtime_error beyond max_links, since a few bytes of a hostile stream can stand for
/// any number of links.
class SurfaceBuilder {
 public:
  static constexpr std::uint64_t max_links = std::uint64_t{1} << 27;

  Answer take(const Event& event);

  /// What has been delivered so far; spacing_mm is for the caller to set.
  Surface& surface() { return surface_; }
  const Surface& surface() const { return surface_; }

  /// Regions that could not be put together because a fragment of theirs was lost.
  std::uint64_t incomplete_regions() const { return incomplete_regions_; }

 private:
  struct OpenRing {
    Vertex start;
    std::vector<Run> runs;
  };

  void end_region();
  bool is_sound(const OpenRing& ring, const std::vector<Run>& runs);
  bool append(const std::vector<Run>& runs, std::vector<Run>& whole);
  void add_simple_rings(const OpenRing& ring, const std::vector<Run>& runs, Polygon& polygon);

  Surface surface_;
  std::uint64_t incomplete_regions_ = 0;
  std::uint64_t links_ = 0;                                        // unfolded so far
  std::unordered_map<std::uint32_t, std::vector<Run>> fragments_;  // sent, not yet put back
  Incidence incidence_ = no_incidence;
  std::vector<OpenRing> rings_;  // of the region under way
  std::vector<Run> fragment_;    // under way
  std::uint32_t fragment_number_ = 0;
  bool in_fragment_ = false;
};

}  // namespace discmc::host

#endif
