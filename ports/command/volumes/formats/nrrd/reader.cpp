// NRRD0001 to NRRD0005, https://teem.sourceforge.net/nrrd/format.html.
//
// The header is parsed here, not by libteem. Its parser (1.12) passes the name in "data file:" to
// sprintf as a format: "%99999d" writes beyond its heap block.
#include <algorithm>
#include <utility>

#include "header.hpp"
#include "text/words.hpp"
#include "volumes/data_files.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

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

// Returns the next entry of a field with one entry per axis: "in quotes", (in brackets), or a word.
std::string_view first_entry(std::string_view text) {
  const char first = text.front();
  if (first != '"' && first != '(') return text.substr(0, text.find_first_of(" \t"));
  const std::size_t end = text.find(first == '"' ? '"' : ')', 1);
  return text.substr(0, end == std::string_view::npos ? end : end + 1);
}

bool is_of_space(std::string_view kind) {
  return one_of(lower(kind), {"domain", "space", "time", "none", "???"});
}

// The meaning of a first axis that is not an axis of space: its samples are adjacent.
enum class SideBySide { nothing, volumes, channels };

// A list means volumes: the layers of a segmentation in 3D Slicer. Vectors and colours mean
// channels.
SideBySide side_by_side(const HeaderFields& fields) {
  const auto kinds = words(fields.text("kinds"));
  const auto directions = words(fields.text("space directions"));
  if (words(fields.text("sizes")).size() != 4) return SideBySide::nothing;
  if (!kinds.empty() && !is_of_space(kinds[0]))
    return lower(kinds[0]) == "list" ? SideBySide::volumes : SideBySide::channels;
  const bool has_no_direction = !directions.empty() && lower(directions[0]) == "none";
  return has_no_direction ? SideBySide::volumes : SideBySide::nothing;
}

// Moves the first axis to the end, where other files have the list of volumes.
void move_first_axis_back(HeaderFields& fields) {
  for (const char* name : {"sizes", "spacings", "space directions", "units", "kinds", "labels",
                           "thicknesses", "axis mins", "axis maxs", "centerings"}) {
    const std::string entries(fields.text(name));
    if (entries.empty()) continue;
    const std::string_view first = first_entry(entries);
    const std::string_view others = trimmed(std::string_view(entries).substr(first.size()));
    fields.replace(name, std::string(others) + ' ' + std::string(first));
  }
}

void set_sizes(VolumeInfo& info, const HeaderFields& fields, const VolumeOptions& options,
               SideBySide first_axis) {
  const std::filesystem::path& file = fields.file();
  const auto dimension = integer(file, "dimension", fields.needed("dimension"));
  std::vector<std::int64_t> sizes = fields.needed_integers("sizes");
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

  const auto kinds = words(fields.text("kinds"));
  for (std::size_t axis = 0; axis < kinds.size() && axis < 3; ++axis)
    if (!is_of_space(kinds[axis])) fail_axis(fields, axis, "is of kind " + shown(kinds[axis]));
}

// Returns the first name of the encoding.
std::string encoding_of(const HeaderFields& fields) {
  std::string encoding = lower(fields.needed("encoding"));
  if (encoding == "raw") return encoding;
  if (one_of(encoding, {"gzip", "gz"})) return "gzip";
  if (one_of(encoding, {"bzip2", "bz2"})) return "bzip2";
  if (one_of(encoding, {"text", "txt", "ascii"})) return "text";
  fail(fields.file(), "encoding " + shown(encoding) + " is not supported",
       "use raw, gzip, bzip2 or text, e.g. with: unu save -f nrrd -e gzip -i in.nrrd -o out.nrrd");
}

bool is_stored_big_endian(const HeaderFields& fields, SampleType type) {
  if (encoding_of(fields) == "text") return is_native_big_endian();
  if (sample_bytes(type) == 1) return false;
  const std::string endian = lower(fields.needed("endian"));
  if (endian != "big" && endian != "little")
    fail(fields.file(), "endian is " + shown(endian), "write big or little");
  return endian == "big";
}

// Moves to the first sample of a data file. Lines are skipped in the packed file, bytes in its
// content.
ByteStream at_data(ByteStream data, const HeaderFields& fields, SampleType type,
                   std::uint64_t bytes_in_file) {
  const std::string encoding = encoding_of(fields);
  const std::int64_t lines = fields.integer("line skip", 0);
  const std::int64_t bytes = fields.integer("byte skip", 0);
  if (lines < 0 || bytes < (encoding == "raw" ? -1 : 0))
    fail(fields.file(),
         "line skip " + std::to_string(lines) + ", byte skip " + std::to_string(bytes) +
             " is not supported with encoding " + encoding,
         "give the bytes to skip as a number from 0");
  data.skip_lines(static_cast<std::uint64_t>(lines));
  if (encoding == "gzip") data.decode(inflated);
  if (encoding == "bzip2")
    data.decode(
        [name = data.file()](auto in) { return unpacked(std::move(in), Packing::bzip2, name); });
  if (bytes >= 0)
    data.skip(static_cast<std::uint64_t>(bytes));
  else
    skip_to_end(data, bytes_in_file);
  if (encoding == "text")
    data.decode([type](auto in) { return samples_of_text(std::move(in), type); });
  return data;
}

// Opens the samples behind the header, or in the files that the header names.
ByteStream open_data(ByteStream& header, std::string_view name, const HeaderFields& fields,
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

// Returns the stored form: one volume, whose rows hold the adjacent samples of all volumes.
VolumeInfo stored(const std::filesystem::path& file, const VolumeInfo& info) {
  VolumeInfo stored_info = of_all_components(
      file, info, info.frames * info.channels,
      "make the first axis the last, e.g. with: unu permute -p 1 2 3 0 -i in.nrrd -o out.nrrd");
  stored_info.frames = 1;
  return stored_info;
}

}  // namespace

std::unique_ptr<VolumeReader> open_nrrd(ByteStream stream, const VolumeOptions& options) {
  NrrdHeader header = read_nrrd_header(stream);
  HeaderFields& fields = header.fields;
  const SideBySide first_axis = side_by_side(fields);
  if (first_axis != SideBySide::nothing) move_first_axis_back(fields);
  VolumeInfo info;
  info.type = sample_type(fields.file(), fields.needed("type"));
  set_sizes(info, fields, options, first_axis);
  set_place(info, nrrd_place(info, fields), options);
  if (fields.has("old min"))
    note(info, "old min and old max are ignored; the values are the stored ones");
  header.segments.describe(info);
  const bool is_big_endian = is_stored_big_endian(fields, info.type);

  const std::string_view name = fields.text("data file");
  if (name.empty() && !header.closed)
    fail(fields.file(), "the header has no end",
         "end it with an empty line, or name a data file in it");
  info.format = "NRRD, " + encoding_of(fields) + (name.empty() ? "" : ", detached");
  VolumeInfo stored_info = first_axis == SideBySide::nothing ? info : stored(fields.file(), info);
  ByteStream data = open_data(stream, name, fields, stored_info);
  info.notes = stored_info.notes;
  auto volume = std::make_unique<SliceStream>(
      std::move(stored_info), std::move(data), is_big_endian,
      first_axis == SideBySide::nothing ? options.frame : std::nullopt);
  if (first_axis == SideBySide::nothing) return volume;
  const auto count = static_cast<std::uint32_t>(info.frames * info.channels);
  const auto chosen = first_axis == SideBySide::volumes ? options.frame : options.channel;
  return component(std::move(volume), std::move(info), chosen.value_or(0), count);
}

}  // namespace discmc::command
