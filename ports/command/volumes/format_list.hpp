// The formats of files: names, first bytes, and readers. Also lists files that are not volumes, by
// their names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "volumes/formats/readers.hpp"

namespace discmc::command {

/// Bytes at an offset of a file, or anywhere in its first bytes.
struct Magic {
  std::size_t offset;
  std::string_view bytes;
};

/// A format that is read from a stream of bytes, from an existing unpacked file, or not at all.
struct VolumeFormat {
  std::string_view name;
  std::vector<std::string_view> endings;  ///< endings of file names, in lower case
  std::vector<Magic> magics;
  std::unique_ptr<VolumeReader> (*open_stream)(ByteStream stream, const VolumeOptions& options);
  std::unique_ptr<VolumeReader> (*open_file)(const std::filesystem::path& file,
                                             const VolumeOptions& options);
  /// The remedy for an unsupported format: a program that converts it.
  std::string_view remedy = {};
};

inline bool is_read(const VolumeFormat& format) {
  return format.open_stream != nullptr || format.open_file != nullptr;
}

/// Returns the format of a file by its name, which may be the name of an array in it, or null. A
/// packed file has the format of its content.
const VolumeFormat* format_of_name(const std::filesystem::path& file);

/// Returns the format by the first bytes, or null. head: the first magic_bytes bytes, fewer in a
/// shorter file.
const VolumeFormat* format_of_head(std::string_view head);

/// Whether the name means an array, whose axes the user may name.
bool names_no_axes(const std::filesystem::path& file);

/// Units: bytes at the beginning of a file that identify its format.
constexpr std::size_t magic_bytes = 348;

/// Whether the first bytes are those of a volume format with a header, or of a packed file. Streams
/// never begin like this.
bool is_volume_head(std::string_view head);

bool is_stream_name(const std::filesystem::path& file);
bool is_mesh_name(const std::filesystem::path& file);

/// The end of the message if a mesh is given to another command.
constexpr const char* commands_for_meshes =
    "only discmc compare, render and view read meshes: .stl, .ply, .obj, .glb or .3mf";

}  // namespace discmc::command
