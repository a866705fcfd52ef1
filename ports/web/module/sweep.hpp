// Makes polygons from bits for each new threshold.
#pragma once

#include <cstdint>

#include "host/host_scan.hpp"
#include "surface/joined_surface.hpp"
#include "voxel_bits.hpp"

namespace discmc::web {

/// Keeps its memory from one sweep to the next.
class Sweep {
 public:
  struct Result {
    meshing::Polygons polygons;
    Statistics statistics{};
  };
  /// Border::closed. Throws as SurfaceBuilder.
  Result run(const VoxelBits& bits, std::uint32_t width, std::uint32_t height);

 private:
  meshing::HostScan scan_;
};

}  // namespace discmc::web
