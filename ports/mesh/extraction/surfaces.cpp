#include "surfaces.hpp"

#include <algorithm>

#include "extractors.hpp"
#include "part_extraction.hpp"

namespace discmc::meshing {
namespace {

// A single sweep is fastest for one job. Streams and the seams of slabs depend on the parts.
bool is_for_parts(const SurfaceOptions& options, const std::vector<SurfaceRequest>& surfaces) {
  return *options.jobs > 1 || options.memory > 0 || options.slab.has_value() ||
         std::any_of(surfaces.begin(), surfaces.end(),
                     [](const SurfaceRequest& each) { return each.encoder != nullptr; });
}

}  // namespace

std::vector<Extraction> extract_surfaces(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces) {
  if (options.jobs && is_for_parts(options, surfaces))
    return extract_in_parts(volume, options, surfaces);
  const Limits limits = limits_of(volume.info(), options);
  return extract_by<HostExtractor>(volume, limits, options, generous_arena(limits), surfaces);
}

}  // namespace discmc::meshing
