// Formats of the files that a command writes, by their names.
#pragma once

#include <filesystem>
#include <string>

namespace discmc::command {

enum class Format { stream, stl, ply, obj, glb, three_mf, vtp, jsonl, csv, json };

/// What a format can hold.
struct FormatTraits {
  Format format;
  const char* extension;
  bool holds_polygons;  ///< faces of more than three corners
  bool holds_normals;   ///< of vertices
  bool holds_several;   ///< meshes, each with its name and colour, or their measures
  bool holds_doubles;   ///< coordinates of 64 bits, or all their digits
  bool holds_measures;  ///< of meshes, in place of meshes
  bool is_text;         ///< that a terminal can show
};

/// By the extension; "-" is the stream. Throws std::invalid_argument with the
/// extensions that are known.
Format format_of(const std::filesystem::path& path);

const FormatTraits& traits_of(Format format);

/// The extensions of all formats, as ".obj, .ply or .stl"; or only of those of meshes that hold
/// something.
std::string extensions(bool FormatTraits::*holds = nullptr);

}  // namespace discmc::command
