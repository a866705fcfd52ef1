// Extracts the surfaces of a volume on a host, in one pass.
#ifndef DISCMC_MESH_EXTRACTION_SURFACES_HPP
#define DISCMC_MESH_EXTRACTION_SURFACES_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/placement.hpp>

#include "crossings.hpp"
#include "host/host_extractor.hpp"
#include "samples/slice_reader.hpp"
#include "selection.hpp"
#include "surface/surface_builder.hpp"

namespace discmc::meshing {

struct SurfaceOptions {
  Border border = Border::closed;
  /// Called after every slice with the number of slices done.
  std::function<void(std::uint32_t)> progress;
  /// Whether bits pass a MajorityFilter first.
  bool filters_by_majority = false;
  /// Called for every slice that is read, in order, with the rows of its mask, or null without one.
  /// Threads: one at a time.
  std::function<void(const std::uint8_t* samples, const std::uint8_t* mask_rows)> slices{};
  /// The mask, read in parallel, or null: a voxel is off if the mask is 0. Limit: u8, the extents
  /// of the volume. Owner: the caller.
  SliceReader* mask = nullptr;
  /// The slices to extract, if set. Chains that cross the seams become loose fragments. Slices
  /// behind the slab are not read. Limit: its depth is the volume's.
  std::optional<SlabRange> slab{};
  /// If set, extracts the volume in parts, this many in parallel. One job may use one sweep, if the
  /// result is equal.
  std::optional<unsigned> jobs{};
};

/// The use of an arena by a scan.
struct MemoryUse {
  std::uint64_t arena_bytes = 0;       ///< size of the arena
  std::uint64_t arena_bytes_used = 0;  ///< by bit rows and by slots that were ever in use
  Capacities capacities{};             ///< of the arena
  Peaks peaks{};                       ///< peak use of the capacities
};

struct Extraction {
  Statistics statistics{};
  std::uint64_t voxels = 0;         ///< of a slab, only its own
  std::uint64_t not_numbers = 0;    ///< NaN samples, which are off
  bool is_full = false;             ///< whether every voxel is on
  bool is_of_slab = false;          ///< whether there may be loose fragments
  std::optional<MemoryUse> memory;  ///< if measured
  /// The fraction of a triangle that the statistics round down; see host::Sweep.
  std::uint32_t left_triangle_parts = 0;
};

/// A surface of a volume: the voxels inside, and the sink of its events, which must not return
/// "busy".
struct SurfaceRequest {
  Selection selection;
  Sink sink;
  /// Receives the samples, if not null. Owner: the caller.
  CrossingFinder* crossings = nullptr;
  /// Receive the regions that lie in one part, if the volume is extracted in parts; the sink
  /// receives the others. The builder gets polygons or counts; the encoder gets packets that a join
  /// passes on. Limit: without either, these regions are dropped. The sink starts the encoder,
  /// whose output accepts everything. Owner: the caller.
  SurfaceBuilder* builder = nullptr;
  Encoder* encoder = nullptr;
  /// Is offered each region of one ring before the sink receives its events, if set. In parts, the
  /// builder receives these regions instead.
  RegionReceiver regions{};
};

/// Reads the volume to its end and sends the surfaces to their sinks. Rethrows the reader's
/// exceptions.
std::vector<Extraction> extract_surfaces(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces);

}  // namespace discmc::meshing

#endif
