#include "sweep.hpp"

#include <utility>

namespace discmc::web {

Sweep::Result Sweep::run(const VoxelBits& bits, std::uint32_t width, std::uint32_t height) {
  meshing::JoinedSurface surface;
  scan_.start({width, height}, make_sink(surface), make_region_receiver(surface));
  for (std::uint32_t row = 0; row < bits.rows(); ++row) scan_.push(bits.row(row));
  scan_.finish();
  surface.finish();
  return {std::move(surface.surface().polygons), scan_.statistics()};
}

}  // namespace discmc::web
