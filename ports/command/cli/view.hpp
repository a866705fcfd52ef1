// The parts of discmc view, by where the page has its data.
#pragma once

#include <cstdint>
#include <string>

#include "arguments.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Serves the page and its data until the user ends the program. Returns the exit code.
int serve_view(const ViewArguments& arguments);

/// Whether the page shows meshes, not samples or a stream.
bool shows_meshes(const ViewArguments& arguments);

/// The name of the input, for people.
std::string name_of(const std::string& input);

/// A file for the page, in memory. code: of a stream, from completeness().
struct NamedBytes {
  std::string name;
  std::string bytes;
  int code;
};

/// Returns the surface at the requested threshold, as slices.
NamedBytes stream_of_threshold(const ViewArguments& arguments);
/// Returns the stream in a file.
NamedBytes stream_in_file(const ViewArguments& arguments);
/// Returns the meshes of labels or of a file, as GLB with normals. max_bytes: throws
/// std::runtime_error if they have more bytes.
NamedBytes meshes_to_show(const ViewArguments& arguments, std::uint64_t max_bytes);

/// Throws std::runtime_error if the samples of the volume have more bytes than a page holds.
void require_size(const std::string& input, const VolumeInfo& info, std::uint64_t max_bytes);

}  // namespace discmc::command
