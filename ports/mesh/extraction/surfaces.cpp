#include "surfaces.hpp"

#include "extractors.hpp"
#include "part_extraction.hpp"

namespace discmc::meshing {

std::vector<Extraction> extract_surfaces(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces) {
  if (options.jobs) return extract_in_parts(volume, options, surfaces);
  const Limits limits = limits_of(volume.info(), options);
  return extract_by<HostExtractor>(volume, limits, options, generous_arena(limits), surfaces);
}

}  // namespace discmc::meshing
