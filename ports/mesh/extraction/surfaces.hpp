// The surfaces of a volume on a host, in one pass over it.
#ifndef DISCMC_MESH_EXTRACTION_SURFACES_HPP
#define DISCMC_MESH_EXTRACTION_SURFACES_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/placement.hpp>
#include <discmc/slice_encoder.hpp>

#include "crossings.hpp"
#include "host/host_extractor.hpp"
#include "samples/slice_reader.hpp"
#include "selection.hpp"
#include "surface/surface_builder.hpp"

namespace discmc::meshing {

struct SurfaceOptions {
  Border border = Border::closed;
  /// Called after every slice with how many are done.
  std::function<void(std::uint32_t)> progress;
  /// Whether bits pass a MajorityFilter first.
  bool takes_majority = false;
  /// Receives the bits as well, and is finished, if there is one; its output must accept all.
  SliceEncoder* slices = nullptr;
  /// Read along, if there is one: a voxel is off where it is 0. Limit: u8, the extents of the
  /// volume. Owner: the caller.
  SliceReader* mask = nullptr;
  /// Only these slices of the volume, if given. What crosses its seams are loose fragments. Slices
  /// behind it are not read. Limit: its depth is the volume's.
  std::optional<SlabRange> slab{};
  /// If set, extracts the volume in parts, this many at once; or in one sweep, if that gives the
  /// same with one job. Limit: not with slices or crossings.
  std::optional<unsigned> jobs{};
  /// The first arena of a part; a part that needs more gets more. 0: a generous one. Units: bytes.
  std::uint64_t memory = 0;
};

/// The use of an arena by a scan.
struct MemoryUse {
  std::uint64_t arena_bytes = 0;       ///< given
  std::uint64_t arena_bytes_used = 0;  ///< by bit rows and by slots that were ever in use
  Capacities capacities{};             ///< that the arena had
  Peaks peaks{};                       ///< of them, the peak
};

struct Extraction {
  Statistics statistics{};
  std::uint64_t voxels = 0;         ///< of a slab its own
  std::uint64_t not_numbers = 0;    ///< samples that are not a number: off
  bool is_full = false;             ///< whether every voxel is on
  bool is_of_slab = false;          ///< so there may be loose fragments
  std::optional<MemoryUse> memory;  ///< if it was measured
  /// As in host::Sweep, if this is a part.
  std::uint32_t left_triangle_parts = 0;
};

/// A surface of a volume: the voxels inside, and the sink of its events, which must not return
/// "busy".
struct SurfaceRequest {
  Selection selection;
  Sink sink;
  /// Receives the samples, if there is one. Owner: the caller.
  CrossingFinder* crossings = nullptr;
  /// If the volume is extracted in parts, these receive the regions that lie in one part, and the
  /// sink the others. Both are polygons or counts, and encoded, in packets that a join passes on.
  /// Limit: in parts there is one of the two; the sink starts the encoder, whose output accepts
  /// all. Owner: the caller.
  SurfaceBuilder* builder = nullptr;
  Encoder* encoder = nullptr;
  /// If set, is offered each region of one ring before the sink receives its events. In parts, the
  /// builder receives these regions instead.
  RegionReceiver regions{};
};

/// Reads the volume to its end and sends the surfaces to their sinks. Throws what the reader
/// throws.
std::vector<Extraction> extract_surfaces(SliceReader& volume, const SurfaceOptions& options,
                                         const std::vector<SurfaceRequest>& surfaces);

}  // namespace discmc::meshing

#endif
