// Extracts a volume with the extractor of a host or of a device.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <discmc/stream/wire.hpp>

#include "extraction/surfaces.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// How to extract a volume: as a host or as a device does.
struct ExtractionOptions : SurfaceOptions {
  ExtractionOptions() = default;
  ExtractionOptions(const Selection& selected, Border at_ends = Border::closed)
      : selection(selected) {
    border = at_ends;
  }

  Selection selection;  ///< the voxels that are on
  /// Whether the events contain gradient normals. The arena then also holds four slices.
  /// Limit: samples of a type with is_scanner_type(), selections without an upper end.
  bool normals = false;
  /// The arena. 0: a generous one. Units: bytes.
  std::uint64_t memory = 0;
  /// Replaces `memory`: the arena is large enough for these capacities.
  std::optional<Capacities> capacities{};
  /// Whether memory is used as on a device, so that its measurements apply to a device. `memory`,
  /// `capacities` and `normals` imply this. The surface is the same. Limit: none of these with
  /// jobs.
  bool measures_memory = false;
};

/// Returns the header of a volume's stream.
StreamHeader stream_header(const SampleGrid& info, const ExtractionOptions& options);

/// Throws std::invalid_argument if the extents or spacings of the stream and the volume differ; the
/// text names both. Skips what the header lacks.
void require_same_volume(const SampleGrid& info, const StreamHeader& header);

/// Reads the volume to its end and gives its surface to the sink, which must not return "busy".
/// Throws VolumeError from the reader. Throws std::invalid_argument if the memory is too small (the
/// text names the minimum) or the capacities are invalid.
Extraction extract(SliceReader& volume, const ExtractionOptions& options, const Sink& sink);

/// Extracts several surfaces in one pass, each in an arena of its own. Ignores options.selection.
std::vector<Extraction> extract(SliceReader& volume, const ExtractionOptions& options,
                                const std::vector<SurfaceRequest>& surfaces);

}  // namespace discmc::command
