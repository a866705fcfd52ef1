// A volume in parts, on several cores.
#ifndef DISCMC_MESH_EXTRACTION_PART_EXTRACTION_HPP
#define DISCMC_MESH_EXTRACTION_PART_EXTRACTION_HPP

#include <cstdint>
#include <vector>

#include "slab_spans.hpp"
#include "surfaces.hpp"

namespace discmc::meshing {

/// The parts that slices of a volume are divided into: 16 to 32 slices each, fewer where these are
/// large. They do not depend on the jobs, and neither does the surface.
std::vector<SliceSpan> parts_of(const SampleGrid& info, const SliceSpan& slices);

/// As extract(), by `jobs` threads at once. Regions come in the order of the parts: those that
/// cross seams with the part that they end in, before its own. Memory: twice as many parts as jobs,
/// and the pieces that cross seams. Limit: at least one job; of the options and requests as for
/// SurfaceOptions::jobs.
std::vector<Extraction> extract_in_parts(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces);

}  // namespace discmc::meshing

#endif
