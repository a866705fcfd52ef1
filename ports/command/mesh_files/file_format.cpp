#include "file_format.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "text/words.hpp"

namespace discmc::command {
namespace {

constexpr FormatTraits all_formats[] = {
    // extension, polygons, normals, several meshes, doubles, measures, text
    {Format::stream, ".dmc", false, false, false, false, false, false},
    {Format::stl, ".stl", false, false, false, false, false, false},
    {Format::ply, ".ply", true, true, false, true, false, false},
    {Format::obj, ".obj", true, true, false, true, false, true},
    {Format::glb, ".glb", false, true, true, false, false, false},
    {Format::three_mf, ".3mf", false, false, true, true, false, false},
    {Format::vtp, ".vtp", true, true, false, true, false, false},
    {Format::jsonl, ".jsonl", true, false, false, false, false, true},
    {Format::csv, ".csv", false, false, true, true, true, true},
    {Format::json, ".json", false, false, true, true, true, true},
};

}  // namespace

Format format_of(const std::filesystem::path& path) {
  const std::string extension = path == "-" ? ".dmc" : lower(path.extension().string());
  for (const FormatTraits& traits : all_formats)
    if (extension == traits.extension) return traits.format;
  throw std::invalid_argument(path.string() + ": unknown extension \"" + extension + "\"; use " +
                              extensions());
}

const FormatTraits& traits_of(Format format) {
  return *std::find_if(std::begin(all_formats), std::end(all_formats),
                       [format](const FormatTraits& traits) { return traits.format == format; });
}

std::string extensions(bool FormatTraits::*holds) {
  std::vector<std::string> names;
  for (const FormatTraits& traits : all_formats)
    if (holds == nullptr || (traits.*holds && !traits.holds_measures))
      names.emplace_back(traits.extension);
  std::string list = names.front();
  for (std::size_t i = 1; i < names.size(); ++i)
    list += (i + 1 == names.size() ? " or " : ", ") + names[i];
  return list;
}

}  // namespace discmc::command
