// Headerless samples with a text file that describes them: VGStudio (.vgi), Phoenix (.pcr) and
// Nikon (.xtekct), from industrial scanners.
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

#include "text/number_text.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

// Fields by lower-case name. Some names repeat in several sections, with an equal value.
using Fields = std::map<std::string, std::string>;

Fields read_fields(ByteStream& stream) {
  Fields fields;
  while (const auto line = stream.read_line()) {
    const std::string_view text = *line;
    const std::size_t equals = text.find('=');
    if (equals != std::string_view::npos)
      fields.emplace(lower(trimmed(text.substr(0, equals))), trimmed(text.substr(equals + 1)));
  }
  return fields;
}

// The names of three fields, or of one field with three numbers.
using Names = std::array<const char*, 3>;

std::array<std::string, 3> three_of(Fields& fields, const Names& names) {
  std::array<std::string, 3> texts;
  const auto parts = words(fields[names[0]]);
  for (std::size_t i = 0; i < 3; ++i)
    texts[i] = parts.size() == 3 ? std::string(parts[i]) : fields[names[i]];
  return texts;
}

SampleType type_of(const std::filesystem::path& file, Fields& fields) {
  if (fields.count("voxelsx") > 0) return SampleType::f32;
  const std::string kind = fields.count("format") > 0
                               ? "format " + fields["format"]
                               : lower(fields["datatype"]) + " of " + fields["bitsperelement"];
  constexpr std::pair<std::string_view, SampleType> types[] = {
      {"format 1", SampleType::u8},
      {"format 5", SampleType::u16},
      {"format 10", SampleType::f32},
      {"unsigned integer of 8", SampleType::u8},
      {"unsigned integer of 16", SampleType::u16},
      {"unsigned integer of 32", SampleType::u32},
      {"signed integer of 8", SampleType::i8},
      {"signed integer of 16", SampleType::i16},
      {"integer of 16", SampleType::i16},
      {"float of 32", SampleType::f32}};
  for (const auto& [name, type] : types)
    if (kind == name) return type;
  fail_type(file, kind);
}

}  // namespace

std::unique_ptr<VolumeReader> open_described(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  Fields fields = read_fields(stream);
  const bool is_nikon = fields.count("voxelsx") > 0, is_phoenix = fields.count("volume_sizex") > 0;
  const auto sizes =
      three_of(fields, is_nikon     ? Names{"voxelsx", "voxelsy", "voxelsz"}
                       : is_phoenix ? Names{"volume_sizex", "volume_sizey", "volume_sizez"}
                                    : Names{"size", "size", "size"});
  const char* const edge = fields.count("voxelsizerec") > 0 ? "voxelsizerec" : "voxelsize";
  const auto steps =
      three_of(fields, is_nikon     ? Names{"voxelsizex", "voxelsizey", "voxelsizez"}
                       : is_phoenix ? Names{edge, edge, edge}
                                    : Names{"resolution", "resolution", "resolution"});
  RawLayout layout;
  layout.type = type_of(file, fields);
  layout.skipped_bytes = whole_number<std::uint64_t>(fields["skipheader"]).value_or(0);
  std::array<double, 3> spacing_mm{};
  const double unit_mm = millimetres_in(fields["unit"]).value_or(1);
  bool has_spacing = true;
  for (std::size_t i = 0; i < 3; ++i) {
    layout.dims[i] = static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(integer(file, "the size", sizes[i]), 0, max_across));
    spacing_mm[i] = decimal(steps[i]).value_or(0) * unit_mm;
    has_spacing = has_spacing && spacing_mm[i] > 0;
  }
  // The name may be a path on another machine.
  const std::string named = fields["name"];
  auto samples = named.empty() ? std::filesystem::path(file)
                               : beside(file, named.substr(named.find_last_of("/\\") + 1));
  if (named.empty()) samples.replace_extension(".vol");
  // Nikon writes the name without its ending, but the name may contain points.
  if (is_nikon && lower(samples.extension().string()) != ".vol") samples += ".vol";
  std::error_code ignored;
  if (!std::filesystem::exists(samples, ignored))
    fail(file,
         "the file describes " + shown(samples.filename().string()) + ", of " +
             extents(layout.dims) + " voxels, which is not beside it",
         "copy it there too");
  VolumeOptions sample_options = options;
  sample_options.layout = layout;
  if (has_spacing && !options.spacing_mm) sample_options.spacing_mm = spacing_mm;
  return open_raw(open_content(samples), sample_options);
}

}  // namespace discmc::command
