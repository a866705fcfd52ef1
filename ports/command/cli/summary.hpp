// The output about a surface or a volume: the tables of `extract` and the lines of `info`.
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

/// Returns the stream for tables about an output: standard error if the output is standard output.
std::ostream& table_stream(const std::string& output);

/// Throws std::invalid_argument if the output would write binary data to a terminal.
void require_no_terminal(const std::string& output);

/// Prints a line such as "v.stl: 684 bytes". Pipes and devices have no size; standard output has no
/// line.
void print_file(const std::string& file, std::ostream& out);

/// A mesh that was written.
struct MeshSummary {
  std::string faces;  ///< the word for its faces: triangles or polygons
  std::uint64_t face_count = 0;
  std::uint64_t vertex_count = 0;   ///< 0 if the format does not number them
  std::optional<bool> is_closed{};  ///< if it was checked
};

/// Prints the measures of a mesh in lines, for people.
void print_mesh_table(const MeshSummary& mesh, const Extraction& extraction, std::ostream& out);

/// Prints the measures of a stream: input, output and resources. slice_encoder_bytes: device memory
/// for a stream of slices; 0 for regions, which use an arena.
void print_table(const Extraction& extraction, const Counts& counts, std::uint64_t stream_bytes,
                 std::uint64_t slice_encoder_bytes, std::ostream& out);

/// Prints spacing and placement as lines of `info`, for streams and volumes.
void print_place(const std::array<double, 3>& spacing_mm,
                 const std::optional<VolumePlacement>& placement, std::ostream& out);

/// Prints one `key value` per line, for people and programs. channel: of the counted surface.
/// streams: all headers of the link. placement: if the stream has one.
void print_info(const StreamHeader& header, std::uint8_t channel,
                const std::vector<StreamHeader>& streams, const StreamReport& report,
                const Counts& counts, const std::optional<VolumePlacement>& placement,
                std::ostream& out);

/// Prints the description of a volume without its notes: a key and its values per line.
void print_volume_info(const VolumeInfo& info, std::ostream& out);

/// Prints the values likewise: range, mean, percentiles, a histogram, and options for extract. The
/// histogram has a line per value if values are few, otherwise per interval. The first and the last
/// interval include outliers.
void print_volume_statistics(const VolumeInfo& info, const VolumeStatistics& statistics,
                             std::ostream& out);

}  // namespace discmc::command
