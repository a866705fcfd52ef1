// MetaImage, https://itk.org/Wiki/MetaIO/Documentation. The only libraries that read it come with
// ITK or VTK, so its lines of "key = value" are parsed here.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "volume_format.hpp"

namespace discmc::host {
namespace {

using Fields = std::map<std::string, std::string, std::less<>>;

struct Header {
  Fields fields;
  std::uint64_t bytes = 0;
};

Header parse(const std::filesystem::path& file, ByteStream& stream) {
  const std::string all = header_text(stream);
  std::string_view rest = all;
  Header header;
  while (header.fields.count("ElementDataFile") == 0) {
    const auto line = take_line(rest);
    if (!line)
      fail(file, "the header field ElementDataFile is missing",
           "end the header with it: LOCAL, or the name of the data file");
    if (trimmed(*line).empty()) continue;
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos)
      fail(file, "the header line " + shown(*line) + " has no equals sign",
           "check that it is a MetaImage file");
    const std::string name(trimmed(line->substr(0, equals)));
    if (!header.fields.emplace(name, trimmed(line->substr(equals + 1))).second)
      fail(file, "the header field " + shown(name) + " is there twice", "delete one of the lines");
  }
  header.bytes = all.size() - rest.size();
  return header;
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

void set_sizes(VolumeInfo& info, const std::filesystem::path& file, const Description& header) {
  const auto dimensions = integer(file, "NDims", header.needed("NDims"));
  std::vector<std::int64_t> sizes;
  for (const auto word : words(header.needed("DimSize")))
    sizes.push_back(integer(file, "DimSize", word));
  if (dimensions != static_cast<std::int64_t>(sizes.size()))
    fail(file,
         "NDims is " + std::to_string(dimensions) + " but DimSize holds " +
             std::to_string(sizes.size()),
         "correct the header");
  set_dims(info, file, sizes);
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
    info.notes.push_back("AnatomicalOrientation " + shown(told) +
                         " dropped: by the TransformMatrix it is '" + taken + "'");
}

void set_geometry(VolumeInfo& info, const std::filesystem::path& file, const Description& header) {
  auto lengths = header.reals({"ElementSpacing", "ElementSize"});
  const std::size_t axes = words(header.needed("DimSize")).size();
  if (lengths.empty())
    info.notes.emplace_back("no spacing given, 1 mm taken");
  else if (lengths.size() < axes)
    fail(file,
         "ElementSpacing holds " + std::to_string(lengths.size()) + " numbers for " +
             std::to_string(axes) + " dimensions",
         "correct the header");
  lengths.resize(3, 1.0);
  set_spacing(info, {lengths[0], lengths[1], lengths[2]});
  const auto matrix = header.reals({"TransformMatrix", "Rotation", "Orientation"});
  const auto origin = header.reals({"Offset", "Position", "Origin"});
  if (matrix.empty() && origin.empty()) return;

  // A row an axis, of length 1. ITK, which the format is from, has the space of DICOM.
  VolumePlacement placement = along_coordinates(info.spacing_mm);
  placement.frame = Frame::lps;
  std::copy_n(origin.begin(), std::min<std::size_t>(origin.size(), 3), placement.origin_mm.begin());
  if (matrix.size() == axes * axes) {
    for (std::size_t axis = 0; axis < std::min<std::size_t>(axes, 3); ++axis)
      for (std::size_t i = 0; i < std::min<std::size_t>(axes, 3); ++i)
        placement.axes_mm[axis][i] = matrix[axis * axes + i] * info.spacing_mm[axis];
  } else if (!matrix.empty()) {
    info.notes.push_back("TransformMatrix of " + std::to_string(matrix.size()) +
                         " numbers dropped: " + std::to_string(axes) + " dimensions take " +
                         std::to_string(axes * axes));
  }
  set_placement(info, placement);
  note_orientation(info, header.text({"AnatomicalOrientation"}));
}

void set_values(VolumeInfo& info, const std::filesystem::path& file, const Description& header) {
  const auto slope = header.reals({"ElementToIntensityFunctionSlope"});
  const auto intercept = header.reals({"ElementToIntensityFunctionOffset"});
  set_scale(info, file, slope.empty() ? 1 : slope[0], intercept.empty() ? 0 : intercept[0]);
}

std::filesystem::path data_file(const std::filesystem::path& file, std::string_view name) {
  if (name.substr(0, 4) == "LIST" || name.find('%') != std::string_view::npos)
    fail(file, "ElementDataFile is " + shown(name) + ", but data in several files is not read",
         "write it to one file, e.g. with ITK or SimpleITK");
  return beside(file, name);
}

// Leaves the stream at the first sample. HeaderSize counts from the beginning of the file that
// holds the data, and -1 says that the data is its end.
void go_to_data(VolumeInfo& info, ByteStream& data, const Description& header) {
  const auto bytes = header.whole("HeaderSize", 0);
  const bool compressed = header.flag({"CompressedData"}, false);
  if (bytes < (compressed ? 0 : -1))
    fail(data.file(), "HeaderSize is " + std::to_string(bytes), "give a number from 0");
  if (bytes > 0) data.seek(static_cast<std::uint64_t>(bytes));
  if (bytes == -1) seek_volume_at_end(data, info);
  info.format = compressed ? "MetaImage, zlib" : "MetaImage, raw";
  if (compressed) data.start_inflate();
}

}  // namespace

std::unique_ptr<VolumeReader> open_metaimage(const std::filesystem::path& file) {
  ByteStream stream(file);
  const Header parsed = parse(file, stream);
  const Description header(file, parsed.fields);
  const std::string_view object = header.text({"ObjectType"});
  if (!object.empty()) expect(file, "ObjectType", object, "Image");
  if (!header.flag({"BinaryData"}, true)) expect(file, "BinaryData", "False", "True");
  if (header.whole("ElementNumberOfChannels", 1) != 1)
    expect(file, "ElementNumberOfChannels", header.text({"ElementNumberOfChannels"}), "1");

  VolumeInfo info;
  info.type = sample_type(file, header.needed("ElementType"));
  set_sizes(info, file, header);
  set_geometry(info, file, header);
  set_values(info, file, header);
  const bool big_endian = header.flag({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
  if (sample_bytes(info.type) > 1 &&
      header.text({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}).empty())
    info.notes.emplace_back("byte order not given, little-endian taken");

  const std::string_view name = header.needed("ElementDataFile");
  const bool local = lower(name) == "local";
  ByteStream data = local ? std::move(stream) : ByteStream(data_file(file, name));
  if (local) data.seek(parsed.bytes);
  go_to_data(info, data, header);
  if (!local) info.format += ", detached";
  return std::make_unique<SliceStream>(std::move(info), std::move(data), big_endian);
}

}  // namespace discmc::host
