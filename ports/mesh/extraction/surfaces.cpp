#include "surfaces.hpp"

#include <algorithm>

#include "extractors.hpp"
#include "part_extraction.hpp"

namespace discmc::meshing {
namespace {

// Whether a HostExtractor would refuse the slices, with those of context.
bool is_deep(const SampleGrid& info, const SurfaceOptions& options) {
  return slices_of(options.slab, info.dims[2]).count() + 2 > host::CornerCode::max_slices;
}

// A single sweep is fastest for one job. Streams and the seams of slabs depend on the parts.
bool is_for_parts(const SampleGrid& info, const SurfaceOptions& options,
                  const std::vector<SurfaceRequest>& surfaces) {
  return *options.jobs > 1 || options.slab.has_value() || is_deep(info, options) ||
         std::any_of(surfaces.begin(), surfaces.end(),
                     [](const SurfaceRequest& each) { return each.encoder != nullptr; });
}

}  // namespace

std::vector<Extraction> extract_surfaces(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces) {
  const SampleGrid& info = volume.info();
  if (options.jobs && is_for_parts(info, options, surfaces))
    return extract_in_parts(volume, options, surfaces);
  const Limits limits = limits_of(info, options);
  return is_deep(info, options)
             ? extract_by<Extractor32>(volume, limits, options, arena_of<Extractor32>(limits),
                                       surfaces)
             : extract_by<HostExtractor>(volume, limits, options, arena_of<HostExtractor>(limits),
                                         surfaces);
}

}  // namespace discmc::meshing
