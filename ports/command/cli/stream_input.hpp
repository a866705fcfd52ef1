// The stream of a command: reads and decodes it, and reports what is missing.
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include <discmc/sink.hpp>

#include "arguments.hpp"
#include "extraction/crossings.hpp"
#include "meshing.hpp"
#include "samples/volume_placement.hpp"
#include "streams/sent_fractions.hpp"
#include "streams/stream_reader.hpp"
#include "surface/surface_builder.hpp"

namespace discmc::command {

/// Reads the named stream; "-" is standard input.
void read_file(const std::string& path, StreamReader& reader);

/// Prints the other surfaces if there are several and the user has chosen none.
void note_others(const std::string& path, const StreamChoice& choice, const StreamReader& reader);

/// Throws if the stream has several surfaces and the user has chosen none, for commands that use
/// one.
void require_one_surface(const std::string& path, const StreamReader& reader);

/// The surface of a stream, and its properties.
struct DecodedStream {
  StreamHeader header;
  std::array<std::uint32_t, 3> dims;  ///< as StreamReader::dims()
  std::uint8_t channel;
  std::vector<StreamHeader> streams;  ///< headers of all streams on the link
  StreamReport report;
  Surface surface;                           ///< without polygons if only counts are kept
  Counts counts;                             ///< only if counts are kept
  std::vector<std::string> records;          ///< the user's own records, as text
  std::optional<VolumePlacement> placement;  ///< if the stream has a usable one
  SentFractions fractions;
};

DecodedStream decode_surface(const std::string& path, const StreamChoice& choice,
                             Kept kept = Kept::polygons);
/// Likewise decodes bytes from another source. path: its name in messages.
DecodedStream decode_surface(const std::string& path, std::istream& in, const StreamChoice& choice);

/// Returns the places of a decoded surface's vertices, or nothing for halfway between voxels.
/// tolerance: of the mesh. Throws std::invalid_argument if the stream has nothing to interpolate.
std::optional<Crossings> crossings_of(const std::string& path, const DecodedStream& decoded,
                                      SurfaceKind surface, double tolerance);

/// Returns all bytes of the named file, or of standard input ("-"), even if they are not a stream.
std::string stream_bytes(const std::string& path);

/// Prints a note if the surface is empty although nothing is missing.
void note_empty(const std::string& path, const DecodedStream& decoded);

/// Prints what is missing, and returns the exit code. Received parts are used in any case.
int completeness(const std::string& path, const StreamReport& report);

}  // namespace discmc::command
