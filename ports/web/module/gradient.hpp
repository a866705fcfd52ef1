// Normals of a drawn surface, from the samples.
#pragma once

#include <vector>

#include <discmc/normal.hpp>

#include "drawn_surface.hpp"
#include "memory_volume.hpp"

namespace discmc::web {

/// One normal per vertex, in space: the direction in which the samples fall. Zero if the samples
/// are level, and on the walls around the volume. iso: the threshold of the surface.
std::vector<OctahedralNormal> gradient_normals(const std::vector<DrawnVertex>& vertices,
                                               const MemoryVolume& volume, double iso);

}  // namespace discmc::web
