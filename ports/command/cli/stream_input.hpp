// The stream of a command: read and decoded, and what of it is missing.
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

/// Prints the other surfaces if there are several and none was chosen.
void note_others(const std::string& path, const StreamChoice& choice, const StreamReader& reader);

/// Throws if the stream has several surfaces and none was chosen, for commands that take one.
void require_one_surface(const std::string& path, const StreamReader& reader);

/// The surface of a stream, and its properties.
struct DecodedStream {
  StreamHeader header;
  std::array<std::uint32_t, 3> dims;  ///< as StreamReader::dims()
  std::uint8_t channel;
  std::vector<StreamHeader> streams;  ///< all of the link
  StreamReport report;
  Surface surface;                           ///< without polygons where counts alone are kept
  Counts counts;                             ///< else none
  std::vector<std::string> records;          ///< the user's own, in words
  std::optional<VolumePlacement> placement;  ///< if the stream has a usable one
  SentFractions fractions;
};

DecodedStream decode_surface(const std::string& path, const StreamChoice& choice,
                             Kept kept = Kept::polygons);
/// The same of bytes that come from elsewhere. path: what they are called.
DecodedStream decode_surface(const std::string& path, std::istream& in, const StreamChoice& choice);

/// Where the vertices of a decoded surface lie; nothing: halfway between voxels. tolerance: of the
/// mesh. Throws std::invalid_argument if the stream has nothing to interpolate.
std::optional<Crossings> crossings_of(const std::string& path, const DecodedStream& decoded,
                                      SurfaceKind surface, double tolerance);

/// All bytes of the named stream, or of standard input by the name "-"; what is no stream, too.
std::string stream_bytes(const std::string& path);

/// Prints that the surface is empty though nothing is missing, if so.
void note_empty(const std::string& path, const DecodedStream& decoded);

/// Prints what is missing, and returns the exit code. The received parts are used.
int completeness(const std::string& path, const StreamReport& report);

}  // namespace discmc::command
