// Polygons from bits, as often as the threshold changes.
#ifndef DISCMC_WEB_SWEEP_HPP
#define DISCMC_WEB_SWEEP_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "host/host_extractor.hpp"

#include "surface/surface.hpp"
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
  HostExtractor extractor_;
  std::vector<std::uint8_t> memory_;
};

}  // namespace discmc::web

#endif
