// Formats of the files that a command writes, by extension.
#pragma once

#include <filesystem>
#include <string>

namespace discmc::command {

enum class Format { stream, stl, ply, obj, glb, three_mf, vtp, jsonl, csv, json };

/// The contents that a format supports.
struct FormatTraits {
  Format format;
  const char* extension;
  bool holds_polygons;  ///< faces of more than three corners
  bool holds_normals;   ///< of vertices
  bool holds_several;   ///< several meshes with names and colours, or their measures
  bool holds_doubles;   ///< coordinates as 64-bit numbers, or with all digits
  bool holds_measures;  ///< measures of meshes instead of meshes
  bool is_text;         ///< readable on a terminal
};

/// Returns the format of an extension; "-" is a stream. Throws std::invalid_argument with the
/// supported extensions.
Format format_of(const std::filesystem::path& path);

const FormatTraits& traits_of(Format format);

/// Returns the extensions of all formats, such as ".obj, .ply or .stl". With `holds`, only mesh
/// formats that have the trait.
std::string extensions(bool FormatTraits::*holds = nullptr);

}  // namespace discmc::command
