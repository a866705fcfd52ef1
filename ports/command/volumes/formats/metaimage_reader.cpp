// MetaImage, https://itk.org/Wiki/MetaIO/Documentation. Only ITK and VTK contain libraries for it,
// so discmc parses its lines of "key = value" itself.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "text/words.hpp"
#include "volumes/data_files.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

// Frames of a tracked sequence of Plus have separate poses, so they are not parallel slices.
void require_untracked(const HeaderFields& fields, const std::string& name,
                       std::map<std::string, std::string>& poses) {
  constexpr std::string_view begin = "Seq_Frame", end = "Transform";
  const std::size_t number = begin.size() + 4;
  if (name.rfind(begin, 0) != 0 || name.size() < number + end.size() ||
      name.compare(name.size() - end.size(), end.size(), end) != 0)
    return;
  const auto pose = poses.emplace(name.substr(number), fields.text(name)).first;
  if (pose->second != fields.text(name))
    fail(fields.file(), "this is a tracked sequence, whose frames lie in different poses",
         "reconstruct the volume, e.g. with VolumeReconstructor of the Plus toolkit");
}

HeaderFields read_header(ByteStream& stream) {
  HeaderFields fields(stream.file());
  std::map<std::string, std::string> poses;
  while (!fields.has("ElementDataFile")) {
    const auto line = stream.read_line();
    if (!line)
      fail(stream.file(), "the header field ElementDataFile is missing",
           "end the header with it: LOCAL, or the name of the data file");
    if (trimmed(*line).empty()) continue;
    const std::string_view text = *line;
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
      fail(stream.file(), "the header line " + shown(*line) + " has no equals sign",
           "check that it is a MetaImage file");
    const std::string name(trimmed(text.substr(0, equals)));
    fields.add(name, trimmed(text.substr(equals + 1)));
    require_untracked(fields, name, poses);
  }
  return fields;
}

bool flag(const HeaderFields& header, std::initializer_list<std::string_view> names,
          bool otherwise) {
  const std::string_view found = header.text(names);
  if (found.empty()) return otherwise;
  const std::string value = lower(found);
  if (value == "true" || value == "1") return true;
  if (value == "false" || value == "0") return false;
  fail(header.file(), std::string(*names.begin()) + " is " + shown(found), "write True or False");
}

// The storage of samples.
struct Storage {
  SampleType type;
  bool is_compressed;
  bool is_text;

  bool is_raw() const { return !is_compressed && !is_text; }
  std::string name() const { return is_compressed ? "zlib" : is_text ? "text" : "raw"; }
};

bool is_local(std::string_view data_file) {
  return lower(data_file) == "local";
}

// Throws unless a field has the only supported value.
void expect(const HeaderFields& header, std::string_view name, std::string_view expected) {
  const std::string_view found = header.text(name);
  if (!found.empty() && lower(found) != lower(expected))
    fail(header.file(),
         std::string(name) + " is " + shown(found) + " and not " + std::string(expected),
         "write the image again, e.g. with ITK or SimpleITK");
}

SampleType sample_type(const std::filesystem::path& file, std::string_view text) {
  // A "long" has four bytes in files, whatever its size in programs.
  constexpr std::pair<std::string_view, SampleType> names[] = {
      {"MET_UCHAR", SampleType::u8},       {"MET_CHAR", SampleType::i8},
      {"MET_USHORT", SampleType::u16},     {"MET_SHORT", SampleType::i16},
      {"MET_UINT", SampleType::u32},       {"MET_INT", SampleType::i32},
      {"MET_ULONG", SampleType::u32},      {"MET_LONG", SampleType::i32},
      {"MET_ULONG_LONG", SampleType::u64}, {"MET_LONG_LONG", SampleType::i64},
      {"MET_FLOAT", SampleType::f32},      {"MET_DOUBLE", SampleType::f64}};
  std::string_view bare = text;
  constexpr std::string_view of_channels = "_ARRAY";
  if (bare.size() > of_channels.size() &&
      bare.substr(bare.size() - of_channels.size()) == of_channels)
    bare.remove_suffix(of_channels.size());
  for (const auto& [name, type] : names)
    if (bare == name) return type;
  fail_type(file, text);
}

void set_sizes(VolumeInfo& info, const HeaderFields& header, const VolumeOptions& options) {
  const auto dimensions = integer(header.file(), "NDims", header.needed("NDims"));
  const std::vector<std::int64_t> sizes = header.needed_integers("DimSize");
  if (dimensions != static_cast<std::int64_t>(sizes.size()))
    fail(header.file(),
         "NDims is " + std::to_string(dimensions) + " but DimSize holds " +
             std::to_string(sizes.size()),
         "correct the header");
  set_dims(info, header.file(), sizes, options.frame);
  const std::int64_t channels = header.integer("ElementNumberOfChannels", 1);
  if (channels < 1)
    fail(header.file(), "ElementNumberOfChannels is " + std::to_string(channels),
         "correct the header");
  set_channels(info, header.file(), static_cast<std::uint64_t>(channels), options.channel);
}

// Returns the letters of the directions from which the axes come: RAI means axes along LPS. ITK
// writes them beside the matrix, but does not read them.
std::string orientation_of(const Axes& axes) {
  constexpr std::string_view from[] = {"RL", "AP", "IS"};
  std::string letters;
  for (const auto& axis : axes) {
    std::size_t along = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::fabs(axis[i]) > std::fabs(axis[along])) along = i;
    letters += from[along][axis[along] < 0 ? 1 : 0];
  }
  return letters;
}

void note_orientation(VolumeInfo& info, std::string_view letters) {
  if (letters.empty() || letters.find('?') != std::string_view::npos || !info.placement) return;
  const std::string matrix_letters = orientation_of(info.placement->axes_mm);
  if (letters != matrix_letters)
    note(info, "AnatomicalOrientation " + shown(letters) +
                   " is ignored; by the TransformMatrix it is '" + matrix_letters + "'");
}

// Returns one row of length 1 per axis, or nothing if the numbers are not a matrix of the axes.
std::optional<Axes> directions_of(VolumeInfo& info, const std::vector<double>& matrix,
                                  std::size_t axes) {
  if (matrix.size() != axes * axes) {
    if (!matrix.empty())
      note(info, "TransformMatrix of " + std::to_string(matrix.size()) + " numbers is ignored; " +
                     std::to_string(axes) + " dimensions need " + std::to_string(axes * axes));
    return std::nullopt;
  }
  Axes directions = coordinates;
  for (std::size_t axis = 0; axis < std::min<std::size_t>(axes, 3); ++axis)
    for (std::size_t i = 0; i < std::min<std::size_t>(axes, 3); ++i)
      directions[axis][i] = matrix[axis * axes + i];
  return directions;
}

void set_spacing(VolumeInfo& info, const HeaderFields& header, std::size_t axes,
                 DeclaredPlace& place) {
  auto lengths = header.reals({"ElementSpacing"});
  if (lengths.empty()) {
    lengths = header.reals({"ElementSize"});
    if (!lengths.empty()) note(info, "no ElementSpacing given, ElementSize is used");
  }
  if (!lengths.empty() && lengths.size() < axes)
    fail(header.file(),
         "ElementSpacing holds " + std::to_string(lengths.size()) + " numbers for " +
             std::to_string(axes) + " dimensions",
         "correct the header");
  std::copy_n(lengths.begin(), std::min<std::size_t>(lengths.size(), 3), place.spacing.begin());
}

void set_geometry(VolumeInfo& info, const HeaderFields& header, const VolumeOptions& options) {
  const std::size_t axes = words(header.needed("DimSize")).size();
  DeclaredPlace place;
  // ITK, which defines the format, uses millimetres and the space of DICOM.
  const std::string_view unit = header.text("DistanceUnits");
  place.set_unit(unit.empty() ? "mm" : unit == "?" ? "" : std::string(unit));
  set_spacing(info, header, axes, place);
  const auto matrix = header.reals({"TransformMatrix", "Rotation", "Orientation"});
  const auto origin = header.reals({"Offset", "Position", "Origin"});
  if (!matrix.empty() || !origin.empty()) place.space = Space::lps;
  place.directions = directions_of(info, matrix, axes);
  std::copy_n(origin.begin(), std::min<std::size_t>(origin.size(), 3), place.origin.begin());
  set_place(info, place, options);
  note_orientation(info, header.text("AnatomicalOrientation"));
}

void set_values(VolumeInfo& info, const HeaderFields& header) {
  const auto slope = header.reals({"ElementToIntensityFunctionSlope"});
  const auto intercept = header.reals({"ElementToIntensityFunctionOffset"});
  set_scale(info, header.file(), slope.empty() ? 1 : slope[0],
            intercept.empty() ? 0 : intercept[0]);
}

// Moves to the first sample of a data file. HeaderSize counts from the beginning of this file; -1
// means that the samples end the file.
ByteStream at_data(ByteStream data, std::int64_t header_bytes, const Storage& storage,
                   std::uint64_t bytes_in_file) {
  if (header_bytes < (storage.is_raw() ? -1 : 0))
    fail(data.file(), "HeaderSize is " + std::to_string(header_bytes), "give a number from 0");
  const auto offset = static_cast<std::uint64_t>(header_bytes);
  if (header_bytes > 0 && offset < data.position())
    fail(data.file(),
         "HeaderSize is " + std::to_string(header_bytes) + ", within the header itself",
         "leave it out");
  if (header_bytes > 0) data.skip(offset - data.position());
  if (header_bytes == -1) skip_to_end(data, bytes_in_file);
  if (storage.is_compressed) data.decode(inflated);
  if (storage.is_text)
    data.decode([&storage](auto in) { return samples_of_text(std::move(in), storage.type); });
  return data;
}

// Opens the samples behind the header, or in the files that the header names.
ByteStream open_data(ByteStream& stream, const HeaderFields& header, const Storage& storage,
                     VolumeInfo& info) {
  const std::string_view name = header.needed("ElementDataFile");
  const std::int64_t header_bytes = header.integer("HeaderSize", 0);
  const std::uint64_t bytes = bytes_of_all(info);
  if (is_local(name)) return at_data(std::move(stream), header_bytes, storage, bytes);
  if (!names_several_files(name))
    return at_data(ByteStream(beside(stream.file(), name)), header_bytes, storage, bytes);
  const DataFiles files = data_files(stream, "ElementDataFile", name);
  const auto open = [storage, header_bytes, each = bytes / files.count](const auto& path) {
    return at_data(ByteStream(path), header_bytes, storage, each);
  };
  return joined(stream.file(), files, info, open);
}

}  // namespace

std::unique_ptr<VolumeReader> open_metaimage(ByteStream stream, const VolumeOptions& options) {
  const HeaderFields header = read_header(stream);
  expect(header, "ObjectType", "Image");

  VolumeInfo info;
  info.type = sample_type(header.file(), header.needed("ElementType"));
  set_sizes(info, header, options);
  set_geometry(info, header, options);
  set_values(info, header);
  const Storage storage{info.type, flag(header, {"CompressedData"}, false),
                        !flag(header, {"BinaryData"}, true)};
  const std::initializer_list<std::string_view> order = {"BinaryDataByteOrderMSB",
                                                         "ElementByteOrderMSB"};
  const bool is_big_endian = storage.is_text ? is_native_big_endian() : flag(header, order, false);
  if (!storage.is_text && sample_bytes(info.type) > 1 && header.text(order).empty())
    note(info, "no byte order given, little-endian assumed");

  info.format = "MetaImage, " + storage.name() +
                (is_local(header.needed("ElementDataFile")) ? "" : ", detached");
  return channel_of(header.file(), std::move(info), options.channel, [&](VolumeInfo all) {
    ByteStream data = open_data(stream, header, storage, all);
    return std::make_unique<SliceStream>(std::move(all), std::move(data), is_big_endian,
                                         options.frame);
  });
}

}  // namespace discmc::command
