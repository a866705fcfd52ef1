// A volume through the extractor: what the `extract` command does, slice by slice.
#ifndef DISCMC_COMMAND_EXTRACTION_EXTRACTION_HPP
#define DISCMC_COMMAND_EXTRACTION_EXTRACTION_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/placement.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/stream/wire.hpp>

#include "crossings.hpp"
#include "selection.hpp"
#include "surface/surface_builder.hpp"
#include "volumes/volume_reader.hpp"

namespace discmc::command {

struct ExtractionOptions {
  Selection selection;  ///< the voxels that are on
  Border border = Border::closed;
  /// The arena. 0 takes a generous default. Units: bytes
  std::uint64_t memory = 0;
  /// Called after every slice with how many are done.
  std::function<void(std::uint32_t)> progress;
  /// Whether the events contain gradient normals. The arena then also holds four slices.
  /// Limit: samples of a type with is_scanner_type(), selections without an upper end.
  bool normals = false;
  /// Whether bits pass a MajorityFilter first. Limit: not with normals.
  bool takes_majority = false;
  /// Is given the bits as well, and finished, if there is one; its output must take all.
  SliceEncoder* slices = nullptr;
  /// In place of `memory`: the arena is as large as these need.
  std::optional<Capacities> capacities{};
  /// Whether the memory is used as on a device, so that what is measured of it is true there.
  /// Otherwise by a HostExtractor, which is faster, unless memory, capacities or normals are
  /// asked for. The surface is the same.
  bool measures_memory = false;
  /// Is read along, if there is one: a voxel is off where it is 0. Limit: u8, the extents of the
  /// volume, not with normals. Owner: the caller.
  VolumeReader* mask = nullptr;
  /// Only these slices of the volume, where there is one. What crosses its seams are loose
  /// fragments. Slices behind it are not read. Limit: its depth is the volume's.
  std::optional<SlabRange> slab{};
  /// If set, extracts the volume in parts, this many at once (extract_in_parts()). `memory` is then
  /// the first try; a part that needs more gets more.
  /// Limit: not with capacities, measures_memory, normals, slices or crossings.
  std::optional<unsigned> jobs{};
};

/// What a device would need.
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
};

/// A surface of a volume: the voxels inside, and the sink of its events, which must not return
/// "busy".
struct SurfaceRequest {
  Selection selection;
  Sink sink;
  /// Is given the samples, if there is one. Owner: the caller.
  CrossingFinder* crossings = nullptr;
  /// If the volume is extracted in parts, these get the regions that lie in one part, and the sink
  /// gets the others: as polygons or counts, and encoded, in packets that a join passes on. Limit:
  /// in parts there is one of the two; the sink is what starts the encoder, whose output takes all.
  /// Owner: the caller.
  SurfaceBuilder* builder = nullptr;
  Encoder* encoder = nullptr;
  /// Is offered regions before the sink gets their events, if it is there.
  RegionReceiver regions{};
};

/// The header of a volume's stream.
StreamHeader stream_header(const VolumeInfo& info, const ExtractionOptions& options);

/// Throws std::invalid_argument when the stream cannot be of this volume, because their extents or
/// spacings differ; the text names both. What the header lacks is not compared.
void require_same_volume(const VolumeInfo& info, const StreamHeader& header);

/// Reads the volume to its end and gives its surface to the sink, which must not return "busy".
/// Throws VolumeError as the reader does, std::invalid_argument when the memory is too small (the
/// text names the minimum) or the capacities are not valid.
Extraction extract(VolumeReader& volume, const ExtractionOptions& options, const Sink& sink);

/// The same for several surfaces in one pass, whatever the selection of the options; each has an
/// arena by the options.
std::vector<Extraction> extract(VolumeReader& volume, const ExtractionOptions& options,
                                const std::vector<SurfaceRequest>& surfaces);

}  // namespace discmc::command

#endif
