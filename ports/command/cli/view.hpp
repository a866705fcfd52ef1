// What discmc view does, by where the page has its data.
#pragma once

#include <cstdint>
#include <string>

#include "arguments.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Serves the page with the data beside it, until the user ends it. Returns the exit code.
int serve_view(const ViewArguments& arguments);

/// Whether the page gets meshes, not samples or a stream.
bool shows_meshes(const ViewArguments& arguments);

/// The name of the input, for people.
std::string name_of(const std::string& input);

/// A file for the page, in memory. code: of a stream, as of completeness().
struct NamedBytes {
  std::string name;
  std::string bytes;
  int code;
};

/// The surface at the threshold that is asked for, as slices.
NamedBytes stream_of_threshold(const ViewArguments& arguments);
/// A file that is a stream already.
NamedBytes stream_in_file(const ViewArguments& arguments);
/// The meshes of labels, or in a file, as GLB with normals. most: throws std::runtime_error where
/// they have more bytes.
NamedBytes meshes_to_show(const ViewArguments& arguments, std::uint64_t most);

/// Throws std::runtime_error where the volume has more bytes of samples than a page holds.
void require_size(const std::string& input, const VolumeInfo& info, std::uint64_t most);

}  // namespace discmc::command
