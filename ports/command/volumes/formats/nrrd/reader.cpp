// NRRD0001 to NRRD0005, https://teem.sourceforge.net/nrrd/format.html.
//
// The header is parsed here and not by libteem, whose parser (1.12) hands the name in "data file:"
// to sprintf as a format: "%99999d" writes past its heap block before any check could help.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <utility>

#include "segment_labels.hpp"
#include "text/words.hpp"
#include "volumes/data_files.hpp"
#include "volumes/filters/component_volume.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_text.hpp"
#include "volumes/told_place.hpp"

namespace discmc::command {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

struct Header {
  Fields fields;
  SegmentLabels segments{};
  bool closed = false;  // by the empty line that data may follow
};

bool one_of(std::string_view text, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), text) != names.end();
}

// The specification's fields; anything else may be a misspelt one that matters.
std::string field_name(const std::filesystem::path& file, std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> second_spellings[] = {
      {"datafile", "data file"},      {"lineskip", "line skip"}, {"byteskip", "byte skip"},
      {"axismins", "axis mins"},      {"axismaxs", "axis maxs"}, {"centers", "centerings"},
      {"blocksize", "block size"},    {"oldmin", "old min"},     {"oldmax", "old max"},
      {"sampleunits", "sample units"}};
  std::string name = lower(trimmed(text));
  for (const auto& [second, first] : second_spellings)
    if (name == second) name = first;
  if (!one_of(name, {"dimension",
                     "type",
                     "sizes",
                     "spacings",
                     "space directions",
                     "space",
                     "units",
                     "encoding",
                     "space units",
                     "space dimension",
                     "endian",
                     "data file",
                     "line skip",
                     "byte skip",
                     "space origin",
                     "kinds",
                     "axis mins",
                     "axis maxs",
                     "labels",
                     "content",
                     "number",
                     "thicknesses",
                     "measurement frame",
                     "centerings",
                     "min",
                     "max",
                     "sample units",
                     "old min",
                     "old max",
                     "block size"}))
    fail(file, "the header field " + shown(name) + " is not known", "correct or delete the line");
  return name;
}

Header parse(const std::filesystem::path& file, ByteStream& stream) {
  const std::string magic = stream.read_line().value_or("");
  if (magic.size() != 8 || magic.substr(0, 7) != "NRRD000" || magic[7] < '1' || magic[7] > '5')
    fail(file, "the file begins with " + shown(magic) + " and not with NRRD0001 to NRRD0005",
         "check that it is an NRRD file");
  Header header;
  while (const auto line = stream.read_line()) {
    header.closed = line->empty();
    if (header.closed) break;
    if (line->front() == '#') continue;
    const std::size_t colon = line->find(':');
    if (colon == std::string::npos)
      fail(file, "the header line " + shown(*line) + " has no colon",
           "end the header with an empty line");
    const std::string_view text = *line;
    if (text.substr(colon, 2) == ":=") {  // a key of some program, with its value
      header.segments.take(text.substr(0, colon), text.substr(colon + 2));
      continue;
    }
    const std::string name = field_name(file, text.substr(0, colon));
    const auto [entry, is_new] = header.fields.emplace(name, trimmed(text.substr(colon + 1)));
    if (!is_new)
      fail(file, "the header field " + shown(name) + " is there twice", "delete one of the lines");
    // The rest of the header is the list.
    if (name == "data file" && entry->second.rfind("LIST", 0) == 0) break;
  }
  return header;
}

std::string_view field(const Fields& fields, std::string_view name) {
  const auto found = fields.find(name);
  return found == fields.end() ? std::string_view() : std::string_view(found->second);
}

std::string_view needed(const std::filesystem::path& file, const Fields& fields,
                        std::string_view name) {
  const std::string_view text = field(fields, name);
  if (text.empty())
    fail(file, "the header field " + shown(name) + " is missing", "add it to the header");
  return text;
}

SampleType sample_type(const std::filesystem::path& file, std::string_view text) {
  const std::string type = lower(text);
  if (one_of(type, {"uchar", "unsigned char", "uint8", "uint8_t"})) return SampleType::u8;
  if (one_of(type, {"signed char", "int8", "int8_t"})) return SampleType::i8;
  if (one_of(type, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}))
    return SampleType::u16;
  if (one_of(type, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}))
    return SampleType::i16;
  if (one_of(type, {"uint", "unsigned int", "uint32", "uint32_t"})) return SampleType::u32;
  if (one_of(type, {"int", "signed int", "int32", "int32_t"})) return SampleType::i32;
  if (one_of(type,
             {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}))
    return SampleType::u64;
  if (one_of(type, {"longlong", "long long", "long long int", "signed long long",
                    "signed long long int", "int64", "int64_t"}))
    return SampleType::i64;
  if (type == "float") return SampleType::f32;
  if (type == "double") return SampleType::f64;
  fail_type(file, text);
}

// The next entry of a field that has one an axis: "in quotes", (in brackets), or a word.
std::string_view first_entry(std::string_view text) {
  const char first = text.front();
  if (first != '"' && first != '(') return text.substr(0, text.find_first_of(" \t"));
  const std::size_t end = text.find(first == '"' ? '"' : ')', 1);
  return text.substr(0, end == std::string_view::npos ? end : end + 1);
}

bool is_of_space(std::string_view kind) {
  return one_of(lower(kind), {"domain", "space", "time", "none", "???"});
}

// What the first axis is where it is none of space: its samples lie side by side.
enum class SideBySide { nothing, volumes, channels };

// A list is of volumes: the layers of a segmentation, as 3D Slicer has them. Vectors and colours
// have channels.
SideBySide side_by_side(const Fields& fields) {
  const auto kinds = words(field(fields, "kinds"));
  const auto directions = words(field(fields, "space directions"));
  if (words(field(fields, "sizes")).size() != 4) return SideBySide::nothing;
  if (!kinds.empty() && !is_of_space(kinds[0]))
    return lower(kinds[0]) == "list" ? SideBySide::volumes : SideBySide::channels;
  const bool has_no_direction = !directions.empty() && lower(directions[0]) == "none";
  return has_no_direction ? SideBySide::volumes : SideBySide::nothing;
}

[[noreturn]] void fail_axis(const std::filesystem::path& file, std::size_t axis,
                            const std::string& what, std::size_t axes) {
  std::string order;
  for (std::size_t other = 0; other < axes; ++other)
    if (other != axis) order += std::to_string(other) + ' ';
  const std::string command =
      axes > 3 ? "make it the last one, e.g. with: unu permute -p " + order + std::to_string(axis)
               : "extract one component, e.g. with: unu slice -p 0 -a " + std::to_string(axis);
  fail(file, "axis " + std::to_string(axis + 1) + ' ' + what, command + " -i in.nrrd -o out.nrrd");
}

// Makes the first axis the last one, where lists of volumes are otherwise.
void move_first_axis_back(Fields& fields) {
  for (const char* name : {"sizes", "spacings", "space directions", "units", "kinds", "labels",
                           "thicknesses", "axis mins", "axis maxs", "centerings"}) {
    const auto found = fields.find(name);
    if (found == fields.end() || found->second.empty()) continue;
    const std::string_view entries = found->second;
    const std::string_view first = first_entry(entries);
    found->second = std::string(trimmed(entries.substr(first.size()))) + ' ' + std::string(first);
  }
}

void set_sizes(VolumeInfo& info, const std::filesystem::path& file, const Fields& fields,
               const VolumeOptions& options, SideBySide first_axis) {
  const auto dimension = integer(file, "dimension", needed(file, fields, "dimension"));
  std::vector<std::int64_t> sizes;
  for (const auto word : words(needed(file, fields, "sizes")))
    sizes.push_back(integer(file, "sizes", word));
  if (dimension != static_cast<std::int64_t>(sizes.size()))
    fail(file,
         "dimension is " + std::to_string(dimension) + " but there are " +
             std::to_string(sizes.size()) + " sizes",
         "correct the header");
  const std::int64_t last = sizes.back();
  if (first_axis == SideBySide::channels) sizes.pop_back();
  set_dims(info, file, sizes, options.frame);
  if (first_axis == SideBySide::channels)
    set_channels(info, file, static_cast<std::uint64_t>(std::max<std::int64_t>(1, last)),
                 options.channel);

  const auto kinds = words(field(fields, "kinds"));
  for (std::size_t axis = 0; axis < kinds.size() && axis < 3; ++axis)
    if (!is_of_space(kinds[axis]))
      fail_axis(file, axis, "is of kind " + shown(kinds[axis]), sizes.size());
}

// The units of three axes, each in double quotes or a word.
std::array<std::string, 3> units_of(std::string_view text) {
  std::array<std::string, 3> units;
  for (std::string& unit : units) {
    text = trimmed(text);
    const bool is_quoted = !text.empty() && text.front() == '"';
    if (is_quoted) text.remove_prefix(1);
    const std::size_t end = std::min(text.find_first_of(is_quoted ? "\"" : " \t"), text.size());
    unit = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return units;
}

// Parses "(x,y,z)", at most three numbers.
std::vector<double> vector_of(const std::filesystem::path& file, std::string_view name,
                              std::string_view text) {
  std::vector<double> numbers;
  const bool bracketed = text.size() >= 2 && text.front() == '(' && text.back() == ')';
  while (bracketed && numbers.size() <= 3) {
    text.remove_prefix(1);
    const std::size_t end = text.find_first_of(",)");
    numbers.push_back(real(file, name, trimmed(text.substr(0, end))));
    text.remove_prefix(end);
    if (text.size() == 1) break;
  }
  if (numbers.empty() || numbers.size() > 3)
    fail(file, std::string(name) + " holds " + shown(text) + ", which is no vector of up to three",
         "correct the header");
  return numbers;
}

// What is given for each axis must be there for all of them.
void expect_per_axis(const std::filesystem::path& file, const Fields& fields, std::string_view name,
                     std::size_t found) {
  const std::size_t axes = words(field(fields, "sizes")).size();
  if (found < std::min<std::size_t>(axes, 3))
    fail(file,
         std::string(name) + " holds " + std::to_string(found) + " entries for " +
             std::to_string(axes) + " dimensions",
         "correct the header");
}

Axes directions_of(const std::filesystem::path& file, const Fields& fields) {
  std::string_view text = field(fields, "space directions");
  Axes directions{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::size_t axis = 0;
  for (; axis < 3 && !trimmed(text).empty(); ++axis) {
    text = trimmed(text);
    const std::size_t end = text.front() == '(' ? text.find(')') : text.find_first_of(" \t");
    const std::string_view word = text.substr(0, end == std::string_view::npos ? end : end + 1);
    text.remove_prefix(word.size());
    if (lower(trimmed(word)) == "none")
      fail_axis(file, axis, "has no direction in space", words(field(fields, "sizes")).size());
    const auto numbers = vector_of(file, "space directions", trimmed(word));
    directions[axis] = {0, 0, 0};
    std::copy(numbers.begin(), numbers.end(), directions[axis].begin());
  }
  expect_per_axis(file, fields, "space directions", axis);
  return directions;
}

using Numbers = std::array<std::optional<double>, 3>;

// What a field has for each of the first three axes, where it is not "nan": not known.
Numbers numbers_of(const std::filesystem::path& file, const Fields& fields, std::string_view name) {
  const auto parts = words(field(fields, name));
  if (!parts.empty()) expect_per_axis(file, fields, name, parts.size());
  Numbers numbers;
  for (std::size_t axis = 0; axis < 3 && axis < parts.size(); ++axis) {
    const double number = real(file, name, parts[axis]);
    if (!std::isnan(number)) numbers[axis] = number;
  }
  return numbers;
}

// The bounds of axes stand for a spacing, and for an origin where there is no other.
void set_bounds(VolumeInfo& info, const std::filesystem::path& file, const Fields& fields,
                ToldPlace& told) {
  const Numbers mins = numbers_of(file, fields, "axis mins");
  const Numbers maxs = numbers_of(file, fields, "axis maxs");
  const auto centerings = words(field(fields, "centerings"));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!mins[axis]) continue;
    const std::string center = axis < centerings.size() ? lower(centerings[axis]) : std::string();
    const bool is_node = center == "node";
    if (!is_node && center != "cell")
      note(info, "no centerings given: axis mins and maxs taken as bounds of whole voxels");
    const double steps = info.dims[axis] - (is_node ? 1.0 : 0.0);
    if (maxs[axis] && steps > 0) {
      const double spacing = (*maxs[axis] - *mins[axis]) / steps;
      if (!told.spacing[axis]) told.spacing[axis] = spacing;
      if (std::fabs(*told.spacing[axis] - spacing) > 1e-3 * std::fabs(spacing))
        note(info, "axis mins and maxs contradict the spacings, which are taken");
    }
    told.origin[axis] = *mins[axis] + (is_node ? 0 : told.spacing[axis].value_or(1) / 2);
  }
  if (fields.count("axis mins") > 0) told.space_units = told.axis_units;
}

// What is told without directions.
void set_spacings(VolumeInfo& info, const std::filesystem::path& file, const Fields& fields,
                  ToldPlace& told) {
  told.spacing = numbers_of(file, fields, "spacings");
  if (fields.count("space origin") == 0) set_bounds(info, file, fields, told);
  const Numbers thicknesses = numbers_of(file, fields, "thicknesses");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (told.spacing[axis] || !thicknesses[axis]) continue;
    told.spacing[axis] = thicknesses[axis];
    note(info, "no spacing of axis " + std::to_string(axis + 1) + " given, its thickness taken");
  }
}

// What the coordinates of the file are.
void set_space(VolumeInfo& info, std::string_view text, ToldPlace& told) {
  std::string name = lower(text);
  constexpr std::string_view time = "-time";
  if (name.size() > time.size() && name.substr(name.size() - time.size()) == time)
    name.resize(name.size() - time.size());
  if (one_of(name, {"left-posterior-superior", "lps", "lpst"})) told.frame = Frame::lps;
  if (one_of(name, {"right-anterior-superior", "ras", "rast"})) told.frame = Frame::ras;
  if (one_of(name, {"left-anterior-superior", "las", "last"})) told.frame = Frame::ras;
  told.is_left_handed = one_of(name, {"left-anterior-superior", "las", "last", "3d-left-handed"});
  if (name == "3d-left-handed")
    note(info, "x of the left-handed space " + shown(text) + " negated");
  const bool is_known = told.frame != Frame::none || told.is_left_handed || name.empty() ||
                        one_of(name, {"scanner-xyz", "3d-right-handed"});
  if (!is_known) note(info, "the space " + shown(text) + " is not known, taken as right-handed");
}

void set_geometry(VolumeInfo& info, const std::filesystem::path& file, const Fields& fields,
                  const VolumeOptions& options) {
  ToldPlace told;
  set_space(info, field(fields, "space"), told);
  // The space of patients is in millimetres, as programs have it that tell no unit.
  if (told.frame != Frame::none) told.set_unit("mm");
  if (fields.count("units") > 0) told.axis_units = units_of(field(fields, "units"));
  if (fields.count("space units") > 0) told.space_units = units_of(field(fields, "space units"));
  if (field(fields, "space directions").empty())
    set_spacings(info, file, fields, told);
  else
    told.steps = directions_of(file, fields);
  const std::string_view origin = field(fields, "space origin");
  if (!origin.empty()) {
    const auto numbers = vector_of(file, "space origin", origin);
    std::copy(numbers.begin(), numbers.end(), told.origin.begin());
  }
  if (fields.count("axis mins") + fields.count("axis maxs") > 0 &&
      fields.count("space origin") + fields.count("space directions") > 0)
    note(info, "axis mins and axis maxs dropped: the place is told by space directions or origin");
  set_place(info, told, options);
  if (fields.count("old min") > 0)
    note(info, "old min and old max dropped: values are the stored ones");
}

// Returns the encoding by the first of its names.
std::string encoding_of(const std::filesystem::path& file, const Fields& fields) {
  std::string encoding = lower(needed(file, fields, "encoding"));
  if (encoding == "raw") return encoding;
  if (one_of(encoding, {"gzip", "gz"})) return "gzip";
  if (one_of(encoding, {"bzip2", "bz2"})) return "bzip2";
  if (one_of(encoding, {"text", "txt", "ascii"})) return "text";
  fail(file, "encoding " + shown(encoding) + " is not read",
       "use raw, gzip, bzip2 or text, e.g. with: unu save -f nrrd -e gzip -i in.nrrd -o out.nrrd");
}

bool big_endian(const std::filesystem::path& file, const Fields& fields, SampleType type) {
  if (encoding_of(file, fields) == "text") return is_native_big_endian();
  if (sample_bytes(type) == 1) return false;
  const std::string endian = lower(needed(file, fields, "endian"));
  if (endian != "big" && endian != "little")
    fail(file, "endian is " + shown(endian), "write big or little");
  return endian == "big";
}

// Leaves a data file at its first sample. Lines are skipped in the file, bytes in its content.
ByteStream at_data(ByteStream data, const Fields& fields, SampleType type,
                   std::uint64_t bytes_in_file) {
  const auto& file = data.file();
  const std::string encoding = encoding_of(file, fields);
  const auto skip_of = [&](const char* name) {
    const std::string_view number = field(fields, name);
    return number.empty() ? 0 : integer(file, name, number);
  };
  const auto lines = skip_of("line skip");
  const auto bytes = skip_of("byte skip");
  if (lines < 0 || bytes < (encoding == "raw" ? -1 : 0))
    fail(file,
         "line skip " + std::to_string(lines) + ", byte skip " + std::to_string(bytes) +
             " is not read with encoding " + encoding,
         "give the bytes to skip as a number from 0");
  data.skip_lines(static_cast<std::uint64_t>(lines));
  if (encoding == "gzip") data.decode(inflated);
  if (encoding == "bzip2")
    data.decode([name = std::filesystem::path(file)](auto in) {
      return unpacked(std::move(in), Packing::bzip2, name);
    });
  if (bytes >= 0)
    data.skip(static_cast<std::uint64_t>(bytes));
  else
    skip_to_end(data, bytes_in_file);
  if (encoding == "text")
    data.decode([type](auto in) { return samples_of_text(std::move(in), type); });
  return data;
}

// Takes the samples from behind the header, or from the files that it names.
ByteStream open_data(ByteStream& header, std::string_view name, const Fields& fields,
                     VolumeInfo& info) {
  const std::uint64_t bytes = bytes_of_all(info);
  if (name.empty()) return at_data(std::move(header), fields, info.type, bytes);
  if (!names_several_files(name))
    return at_data(ByteStream(beside(header.file(), name)), fields, info.type, bytes);
  const DataFiles files = data_files(header, "data file", name);
  const auto open = [fields, type = info.type, each = bytes / files.count](const auto& path) {
    return at_data(ByteStream(path), fields, type, each);
  };
  return joined(header.file(), files, info, open);
}

// As it is stored: one volume, in whose rows the samples of all are side by side.
VolumeInfo stored(const std::filesystem::path& file, VolumeInfo info) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  const std::uint64_t count = info.frames * info.channels;
  if (count > most / info.dims[0])
    fail(file, "the first axis has size " + std::to_string(count) + ", and the rows are too long",
         "make it the last axis, e.g. with: unu permute -p 1 2 3 0 -i in.nrrd -o out.nrrd");
  info.dims[0] *= static_cast<std::uint32_t>(count);
  info.frames = info.channels = 1;
  return info;
}

}  // namespace

std::unique_ptr<VolumeReader> open_nrrd(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  Header header = parse(file, stream);
  const SideBySide first_axis = side_by_side(header.fields);
  if (first_axis != SideBySide::nothing) move_first_axis_back(header.fields);
  VolumeInfo info;
  info.type = sample_type(file, needed(file, header.fields, "type"));
  set_sizes(info, file, header.fields, options, first_axis);
  set_geometry(info, file, header.fields, options);
  header.segments.describe(info);
  const bool is_big_endian = big_endian(file, header.fields, info.type);

  const std::string_view name = field(header.fields, "data file");
  if (name.empty() && !header.closed)
    fail(file, "the header has no end", "end it with an empty line, or name a data file in it");
  info.format = "NRRD, " + encoding_of(file, header.fields) + (name.empty() ? "" : ", detached");
  VolumeInfo all = first_axis == SideBySide::nothing ? info : stored(file, info);
  ByteStream data = open_data(stream, name, header.fields, all);
  info.notes = all.notes;
  auto volume = std::make_unique<SliceStream>(
      std::move(all), std::move(data), is_big_endian,
      first_axis == SideBySide::nothing ? options.frame : std::nullopt);
  if (first_axis == SideBySide::nothing) return volume;
  const auto count = static_cast<std::uint32_t>(info.frames * info.channels);
  const auto chosen = first_axis == SideBySide::volumes ? options.frame : options.channel;
  return component(std::move(volume), std::move(info), chosen.value_or(0), count);
}

}  // namespace discmc::command
