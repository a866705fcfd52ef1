// A volume through the extractor of a host or of a device.
#pragma once

#include <optional>
#include <vector>

#include <discmc/stream/wire.hpp>

#include "extraction/surfaces.hpp"
#include "meshing.hpp"

namespace discmc::command {

/// How a volume is extracted: on the host, or as a device would.
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
  /// In place of `memory`: the arena is as large as these need.
  std::optional<Capacities> capacities{};
  /// Whether the memory is used as on a device, so that what is measured of it is true there. So
  /// it is also with memory, capacities or normals. The surface is the same.
  bool measures_memory = false;
};

/// The header of a volume's stream.
StreamHeader stream_header(const SampleGrid& info, const ExtractionOptions& options);

/// Throws std::invalid_argument when the stream cannot be of this volume, because their extents or
/// spacings differ; the text names both. What the header lacks is not compared.
void require_same_volume(const SampleGrid& info, const StreamHeader& header);

/// Reads the volume to its end and gives its surface to the sink, which must not return "busy".
/// Throws VolumeError as the reader does, std::invalid_argument when the memory is too small (the
/// text names the minimum) or the capacities are not valid.
Extraction extract(SliceReader& volume, const ExtractionOptions& options, const Sink& sink);

/// The same for several surfaces in one pass, whatever the selection of the options; each has an
/// arena by the options.
std::vector<Extraction> extract(SliceReader& volume, const ExtractionOptions& options,
                                const std::vector<SurfaceRequest>& surfaces);

}  // namespace discmc::command
