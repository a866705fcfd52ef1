// MetaImage, https://itk.org/Wiki/MetaIO/Documentation. The only libraries that read it come with
// ITK or VTK, so its lines of "key = value" are parsed here.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "text/words.hpp"
#include "volumes/data_files.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_text.hpp"
#include "volumes/told_place.hpp"

namespace discmc::command {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

Fields parse(const std::filesystem::path& file, ByteStream& stream) {
  Fields fields;
  while (fields.count("ElementDataFile") == 0) {
    const auto line = stream.read_line();
    if (!line)
      fail(file, "the header field ElementDataFile is missing",
           "end the header with it: LOCAL, or the name of the data file");
    if (trimmed(*line).empty()) continue;
    const std::string_view text = *line;
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos)
      fail(file, "the header line " + shown(*line) + " has no equals sign",
           "check that it is a MetaImage file");
    const std::string name(trimmed(text.substr(0, equals)));
    if (!fields.emplace(name, trimmed(text.substr(equals + 1))).second)
      fail(file, "the header field " + shown(name) + " is there twice", "delete one of the lines");
  }
  return fields;
}

// One header with the file for its refusals.
class Description {
 public:
  Description(const std::filesystem::path& file, const Fields& fields)
      : file_(file), fields_(fields) {}

  /// The text of the first name that is there.
  std::string_view text(std::initializer_list<std::string_view> names) const {
    for (const auto name : names) {
      const auto found = fields_.find(name);
      if (found != fields_.end()) return found->second;
    }
    return {};
  }

  std::string_view needed(std::string_view name) const {
    const auto found = text({name});
    if (found.empty())
      fail(file_, "the header field " + shown(name) + " is missing", "add it to the header");
    return found;
  }

  bool flag(std::initializer_list<std::string_view> names, bool otherwise) const {
    const std::string_view found = text(names);
    if (found.empty()) return otherwise;
    const std::string value = lower(found);
    if (value == "true" || value == "1") return true;
    if (value == "false" || value == "0") return false;
    fail(file_, std::string(*names.begin()) + " is " + shown(found), "write True or False");
  }

  std::int64_t whole(std::string_view name, std::int64_t otherwise) const {
    const std::string_view found = text({name});
    return found.empty() ? otherwise : integer(file_, name, found);
  }

  std::vector<double> reals(std::initializer_list<std::string_view> names) const {
    std::vector<double> numbers;
    for (const auto word : words(text(names))) numbers.push_back(real(file_, *names.begin(), word));
    return numbers;
  }

 private:
  const std::filesystem::path& file_;
  const Fields& fields_;
};

// How samples are stored.
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

// What the command reads has one value for this field.
void expect(const std::filesystem::path& file, std::string_view name, std::string_view found,
            std::string_view expected) {
  if (lower(found) != lower(expected))
    fail(file, std::string(name) + " is " + shown(found) + " and not " + std::string(expected),
         "write the image anew, e.g. with ITK or SimpleITK");
}

SampleType sample_type(const std::filesystem::path& file, std::string_view text) {
  // A "long" has four bytes in files, whatever it has in programs.
  constexpr std::pair<std::string_view, SampleType> names[] = {
      {"MET_UCHAR", SampleType::u8},       {"MET_CHAR", SampleType::i8},
      {"MET_USHORT", SampleType::u16},     {"MET_SHORT", SampleType::i16},
      {"MET_UINT", SampleType::u32},       {"MET_INT", SampleType::i32},
      {"MET_ULONG", SampleType::u32},      {"MET_LONG", SampleType::i32},
      {"MET_ULONG_LONG", SampleType::u64}, {"MET_LONG_LONG", SampleType::i64},
      {"MET_FLOAT", SampleType::f32},      {"MET_DOUBLE", SampleType::f64}};
  for (const auto& [name, type] : names)
    if (text == name) return type;
  fail_type(file, text);
}

void set_sizes(VolumeInfo& info, const std::filesystem::path& file, const Description& header,
               const VolumeOptions& options) {
  const auto dimensions = integer(file, "NDims", header.needed("NDims"));
  std::vector<std::int64_t> sizes;
  for (const auto word : words(header.needed("DimSize")))
    sizes.push_back(integer(file, "DimSize", word));
  if (dimensions != static_cast<std::int64_t>(sizes.size()))
    fail(file,
         "NDims is " + std::to_string(dimensions) + " but DimSize holds " +
             std::to_string(sizes.size()),
         "correct the header");
  set_dims(info, file, sizes, options.frame);
}

// Where the axes come from by their letters: RAI are axes along LPS. ITK writes them beside the
// matrix and does not read them.
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

void note_orientation(VolumeInfo& info, std::string_view told) {
  if (told.empty() || told.find('?') != std::string_view::npos || !info.placement) return;
  const std::string taken = orientation_of(info.placement->axes_mm);
  if (told != taken)
    note(info, "AnatomicalOrientation " + shown(told) + " dropped: by the TransformMatrix it is '" +
                   taken + "'");
}

// A row an axis, of length 1; nothing where the numbers are no matrix of the axes.
std::optional<Axes> directions_of(VolumeInfo& info, const std::vector<double>& matrix,
                                  std::size_t axes) {
  if (matrix.size() != axes * axes) {
    if (!matrix.empty())
      note(info, "TransformMatrix of " + std::to_string(matrix.size()) + " numbers dropped: " +
                     std::to_string(axes) + " dimensions take " + std::to_string(axes * axes));
    return std::nullopt;
  }
  Axes directions = coordinates;
  for (std::size_t axis = 0; axis < std::min<std::size_t>(axes, 3); ++axis)
    for (std::size_t i = 0; i < std::min<std::size_t>(axes, 3); ++i)
      directions[axis][i] = matrix[axis * axes + i];
  return directions;
}

void set_spacing(VolumeInfo& info, const std::filesystem::path& file, const Description& header,
                 std::size_t axes, ToldPlace& told) {
  auto lengths = header.reals({"ElementSpacing"});
  if (lengths.empty()) {
    lengths = header.reals({"ElementSize"});
    if (!lengths.empty()) note(info, "no ElementSpacing given, ElementSize taken");
  }
  if (!lengths.empty() && lengths.size() < axes)
    fail(file,
         "ElementSpacing holds " + std::to_string(lengths.size()) + " numbers for " +
             std::to_string(axes) + " dimensions",
         "correct the header");
  std::copy_n(lengths.begin(), std::min<std::size_t>(lengths.size(), 3), told.spacing.begin());
}

void set_geometry(VolumeInfo& info, const std::filesystem::path& file, const Description& header,
                  const VolumeOptions& options) {
  const std::size_t axes = words(header.needed("DimSize")).size();
  ToldPlace told;
  // ITK, which the format is from, has millimetres and the space of DICOM.
  const std::string_view unit = header.text({"DistanceUnits"});
  told.set_unit(unit.empty() ? "mm" : unit == "?" ? "" : std::string(unit));
  set_spacing(info, file, header, axes, told);
  const auto matrix = header.reals({"TransformMatrix", "Rotation", "Orientation"});
  const auto origin = header.reals({"Offset", "Position", "Origin"});
  if (!matrix.empty() || !origin.empty()) told.frame = Frame::lps;
  told.directions = directions_of(info, matrix, axes);
  std::copy_n(origin.begin(), std::min<std::size_t>(origin.size(), 3), told.origin.begin());
  set_place(info, told, options);
  note_orientation(info, header.text({"AnatomicalOrientation"}));
}

void set_values(VolumeInfo& info, const std::filesystem::path& file, const Description& header) {
  const auto slope = header.reals({"ElementToIntensityFunctionSlope"});
  const auto intercept = header.reals({"ElementToIntensityFunctionOffset"});
  set_scale(info, file, slope.empty() ? 1 : slope[0], intercept.empty() ? 0 : intercept[0]);
}

// Leaves a data file at its first sample. HeaderSize counts from the beginning of the file that
// holds the data, and -1 says that the data is its end.
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

// Takes the samples from behind the header, or from the files that it names.
ByteStream open_data(ByteStream& stream, const Description& header, const Storage& storage,
                     VolumeInfo& info) {
  const std::string_view name = header.needed("ElementDataFile");
  const std::int64_t header_bytes = header.whole("HeaderSize", 0);
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
  const std::filesystem::path file = stream.file();
  const Fields fields = parse(file, stream);
  const Description header(file, fields);
  const std::string_view object = header.text({"ObjectType"});
  if (!object.empty()) expect(file, "ObjectType", object, "Image");
  if (header.whole("ElementNumberOfChannels", 1) != 1)
    expect(file, "ElementNumberOfChannels", header.text({"ElementNumberOfChannels"}), "1");

  VolumeInfo info;
  info.type = sample_type(file, header.needed("ElementType"));
  set_sizes(info, file, header, options);
  set_geometry(info, file, header, options);
  set_values(info, file, header);
  const Storage storage{info.type, header.flag({"CompressedData"}, false),
                        !header.flag({"BinaryData"}, true)};
  const std::initializer_list<std::string_view> order = {"BinaryDataByteOrderMSB",
                                                         "ElementByteOrderMSB"};
  const bool big_endian = storage.is_text ? is_native_big_endian() : header.flag(order, false);
  if (!storage.is_text && sample_bytes(info.type) > 1 && header.text(order).empty())
    note(info, "byte order not given, little-endian taken");

  ByteStream data = open_data(stream, header, storage, info);
  info.format = "MetaImage, " + storage.name() +
                (is_local(header.needed("ElementDataFile")) ? "" : ", detached");
  return std::make_unique<SliceStream>(std::move(info), std::move(data), big_endian, options.frame);
}

}  // namespace discmc::command
