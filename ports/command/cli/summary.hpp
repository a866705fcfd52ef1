// What the command prints about a surface or a volume: the tables after `extract`, the lines of
// `info`.
#pragma once

#include <array>
#include <cstdint>
#include <discmc/decoder.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "extraction/extraction.hpp"
#include "meshing.hpp"
#include "samples/volume_placement.hpp"
#include "statistics/volume_statistics.hpp"
#include "surface/counts.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Where tables about an output go: standard error if the output itself is standard output.
std::ostream& table_stream(const std::string& output);

/// Throws std::invalid_argument if the output would be bytes on a terminal.
void require_no_terminal(const std::string& output);

/// As in "v.stl: 684 bytes"; pipes and devices have no bytes, and standard output has no line.
void print_file(const std::string& file, std::ostream& out);

/// A mesh that was written.
struct MeshSummary {
  std::string faces;  ///< what they are: triangles, or polygons
  std::uint64_t face_count = 0;
  std::uint64_t vertex_count = 0;   ///< 0 where the format does not number them
  std::optional<bool> is_closed{};  ///< if it was checked
};

/// The same in lines, for people.
void print_mesh_table(const MeshSummary& mesh, const Extraction& extraction, std::ostream& out);

/// The same of a stream: what came in, what came out, what it took. slice_encoder_bytes: of the
/// device's memory for a stream of slices; 0 for regions, which take an arena.
void print_table(const Extraction& extraction, const Counts& counts, std::uint64_t stream_bytes,
                 std::uint64_t slice_encoder_bytes, std::ostream& out);

/// Spacing and placement as lines of `info`, for streams and volumes.
void print_place(const std::array<double, 3>& spacing_mm,
                 const std::optional<VolumePlacement>& placement, std::ostream& out);

/// One `key value` a line, for people and programs. channel: of the surface that was counted.
/// streams: all that share the link with it. placement: if the stream has one.
void print_info(const StreamHeader& header, std::uint8_t channel,
                const std::vector<StreamHeader>& streams, const StreamReport& report,
                const Counts& counts, const std::optional<VolumePlacement>& placement,
                std::ostream& out);

/// The header, without the notes: a key and its values per line, for people and programs.
void print_volume_info(const VolumeInfo& info, std::ostream& out);

/// The values, in the same way: range, mean, percentiles, a histogram, and options for extract. The
/// histogram has a line for every value if they are few, otherwise for intervals. The first and the
/// last interval also hold outliers.
void print_volume_statistics(const VolumeInfo& info, const VolumeStatistics& statistics,
                             std::ostream& out);

}  // namespace discmc::command
