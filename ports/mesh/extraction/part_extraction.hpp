// Extracts a volume in parts, on several cores.
#ifndef DISCMC_MESH_EXTRACTION_PART_EXTRACTION_HPP
#define DISCMC_MESH_EXTRACTION_PART_EXTRACTION_HPP

#include <cstdint>
#include <vector>

#include "slab_spans.hpp"
#include "surfaces.hpp"

namespace discmc::meshing {

/// Returns the parts into which slices of a volume are divided: 16 to 32 slices each, fewer if
/// slices are large. Neither the parts nor the surface depend on the number of jobs.
std::vector<SliceSpan> parts_of(const SampleGrid& info, const SliceSpan& slices);

/// Extracts like extract_surfaces(), with `jobs` threads. Regions have the order of the parts;
/// regions that cross seams precede the own regions of the part in which they end. Memory: twice as
/// many parts as jobs, and the pieces that cross seams. Limit: at least one job; options and
/// requests as for SurfaceOptions::jobs.
std::vector<Extraction> extract_in_parts(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces);

}  // namespace discmc::meshing

#endif
