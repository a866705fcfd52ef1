// The formats of files: their names, their first bytes, and what reads them. Also files that are no
// volumes, by their names.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "volumes/formats/readers.hpp"

namespace discmc::command {

/// Bytes that files of a format have at an offset, or anywhere among the first.
struct Magic {
  std::size_t offset;
  std::string_view bytes;
};

/// A format is read from a stream of bytes, from a file that is there and not packed, or not at
/// all.
struct VolumeFormat {
  std::string_view name;
  std::vector<std::string_view> endings;  ///< of the names of files, in lower case
  std::vector<Magic> magics;
  std::unique_ptr<VolumeReader> (*open_stream)(ByteStream stream, const VolumeOptions& options);
  std::unique_ptr<VolumeReader> (*open_file)(const std::filesystem::path& file,
                                             const VolumeOptions& options);
  /// The remedy for a format that is not read: a program that converts it.
  std::string_view remedy = {};
};

inline bool is_read(const VolumeFormat& format) {
  return format.open_stream != nullptr || format.open_file != nullptr;
}

/// Returns the format that a file has by its name, which may be that of an array in it. A packed
/// file has the format of its content. Null if the name is of no format.
const VolumeFormat* format_of_name(const std::filesystem::path& file);

/// Returns the format that bytes begin like, or null. head: the first magic_bytes of them, fewer
/// where there are no more.
const VolumeFormat* format_of_head(std::string_view head);

/// Whether a file is named as arrays are, whose axes the user may name.
bool names_no_axes(const std::filesystem::path& file);

/// Units: bytes at the beginning of a file that identify its format.
constexpr std::size_t magic_bytes = 348;

/// Whether bytes begin like a file of a volume format with a header, or like a packed file. Streams
/// never do.
bool is_volume_head(std::string_view head);

bool is_stream_name(const std::filesystem::path& file);
bool is_mesh_name(const std::filesystem::path& file);

/// The end of an error where a mesh is given to another command.
constexpr const char* who_takes_meshes =
    "only discmc compare, render and view read meshes: .stl, .ply, .obj, .glb or .3mf";

}  // namespace discmc::command
