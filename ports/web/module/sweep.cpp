#include "sweep.hpp"

#include <algorithm>
#include <utility>

#include "require.hpp"
#include "surface/surface_builder.hpp"

namespace discmc::web {
namespace {

// As the command has it.
constexpr std::uint64_t generous_bytes = std::uint64_t{64} << 20;

}  // namespace

Sweep::Result Sweep::run(const VoxelBits& bits, std::uint32_t width, std::uint32_t height) {
  const Limits limits{width, height};
  const std::uint64_t bytes = std::max(generous_bytes, 2 * minimum_bytes<std::uint32_t>(limits));
  if (memory_.size() < bytes) memory_.resize(bytes);
  constexpr std::int32_t threshold = 1;  // of bits
  meshing::SurfaceBuilder builder;
  meshing::require(
      extractor_.start(limits, threshold, {memory_.data(), memory_.size()}, make_sink(builder)));
  for (std::uint32_t row = 0; row < bits.rows(); ++row)
    meshing::require(extractor_.push_bits(bits.row(row)).status);
  meshing::require(extractor_.finish());
  return {std::move(builder.surface().polygons), extractor_.statistics()};
}

}  // namespace discmc::web
