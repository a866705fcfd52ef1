// VTK's image and rectilinear grid in XML:
// https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html. Samples are in an
// element of their own, or behind all elements, where the file is no longer XML. Therefore only the
// text before the samples is parsed.
#include <algorithm>
#include <utility>

#include <pugixml.hpp>

#include "text/words.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/formats/vtk_image.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

// The text of the elements before the samples.
class Head {
 public:
  /// coordinate: for a grid, the axis whose coordinates follow in the stream, instead of the
  /// samples.
  explicit Head(ByteStream& stream, std::optional<std::size_t> coordinate = std::nullopt)
      : file_(stream.file()), coordinate_(coordinate) {
    std::string text;
    do {
      append_tag(stream, text);
      const std::string_view tag = std::string_view(text).substr(text.rfind('<'));
      const auto begins = [tag](std::string_view name) { return tag.rfind(name, 0) == 0; };
      is_appended_ = begins("<AppendedData");
      if (!is_appended_ && !begins("<DataArray") && !begins("<VTKFile")) continue;
      document_.load_buffer(text.data(), text.size());
      const std::string_view type = root().attribute("type").value();
      if (type != "ImageData" && type != "RectilinearGrid")
        fail(file_, "this is VTK's " + shown(type) + ", neither ImageData nor RectilinearGrid",
             "write one image, e.g. with ParaView's filter Resample To Image");
    } while (!is_appended_ && !(array() && format() != "appended"));
    if (!array()) fail(file_, "there is no array of samples", "give an image with samples");
  }

  pugi::xml_node root() const { return document_.child("VTKFile"); }
  bool is_grid() const { return !root().child("RectilinearGrid").empty(); }
  pugi::xml_node image() const { return root().child(is_grid() ? "RectilinearGrid" : "ImageData"); }
  pugi::xml_node piece() const { return image().child("Piece"); }
  /// Whether the samples belong to cells between points. They do if points have none.
  bool is_of_cells() const { return !piece().child("PointData").find_child(is_of_samples); }
  /// Whether an array is declared as the scalars.
  bool has_scalars() const { return !std::string_view(scalars()).empty(); }
  /// Returns the declared array, or else the first one.
  pugi::xml_node array() const {
    if (coordinate_) {
      const auto arrays = piece().child("Coordinates").children("DataArray");
      auto array = arrays.begin();
      for (std::size_t i = 0; i < *coordinate_ && array != arrays.end(); ++i) ++array;
      return array != arrays.end() ? *array : pugi::xml_node();
    }
    return has_scalars() ? data().find_child_by_attribute("DataArray", "Name", scalars())
                         : data().find_child(is_of_samples);
  }
  /// Returns the names of other arrays before the samples, such as "b, c".
  std::string other_arrays() const {
    std::string names;
    for (const char* kind : {"PointData", "CellData"})
      for (const pugi::xml_node& other : piece().child(kind).children("DataArray"))
        if (other != array() && is_of_samples(other))
          names += (names.empty() ? "" : ", ") + shown(other.attribute("Name").value());
    return names;
  }
  std::string_view format() const { return array().attribute("format").value(); }
  std::string_view appended_encoding() const {
    return root().child("AppendedData").attribute("encoding").value();
  }
  bool is_appended() const { return is_appended_; }

  std::vector<double> numbers(const pugi::xml_node& node, const char* name) const {
    return reals(file_, name, node.attribute(name).value());
  }
  VtkExtent extent(const pugi::xml_node& node, const char* name) const {
    return vtk_extent(file_, name, numbers(node, name));
  }

 private:
  static bool is_of_samples(const pugi::xml_node& node) {
    return node.name() == std::string_view("DataArray") &&
           node.attribute("Name").value() != vtk_ghosts;
  }
  pugi::xml_node data() const { return piece().child(is_of_cells() ? "CellData" : "PointData"); }
  const char* scalars() const { return data().attribute("Scalars").value(); }

  // Appends the stream's text up to the end of a tag.
  void append_tag(ByteStream& stream, std::string& text) const {
    // The samples may precede the coordinates.
    const std::size_t max_header_bytes = std::size_t{1} << (coordinate_ ? 30 : 20);
    char c = 0;
    bool has_tag = false;
    while (c != '>' || !has_tag) {
      if (text.size() == max_header_bytes || stream.read(&c, 1) == 0)
        fail(file_,
             "there is no array of samples in the first " + std::to_string(text.size()) + " bytes",
             "give an image with samples");
      text += c;
      has_tag = has_tag || c == '<';
    }
  }

  std::filesystem::path file_;
  std::optional<std::size_t> coordinate_;
  pugi::xml_document document_;
  bool is_appended_ = false;
};

// Notes which of several arrays is the volume, if the choice is unclear.
void note_arrays(VolumeInfo& info, const Head& head) {
  const std::string read = "array " + shown(head.array().attribute("Name").value()) + " is read, ";
  if (const std::string others = head.other_arrays(); !others.empty())
    note(info, read + "others are left out: " + others);
  else if (!head.is_appended() && !head.has_scalars())
    note(info, read + "the first; everything after its samples is left out");
}

SampleType sample_type(const std::filesystem::path& file, std::string_view type) {
  constexpr std::pair<std::string_view, SampleType> names[] = {
      {"UInt8", SampleType::u8},   {"Int8", SampleType::i8},    {"UInt16", SampleType::u16},
      {"Int16", SampleType::i16},  {"UInt32", SampleType::u32}, {"Int32", SampleType::i32},
      {"UInt64", SampleType::u64}, {"Int64", SampleType::i64},  {"Float32", SampleType::f32},
      {"Float64", SampleType::f64}};
  for (const auto& [name, of_name] : names)
    if (type == name) return of_name;
  fail_type(file, type);
}

// The header of the data: its size or, if compressed, the number and sizes of blocks.
class Blocks {
 public:
  Blocks(ByteStream& stream, const Head& head, bool is_big_endian)
      : stream_(stream),
        number_bytes_(
            head.root().attribute("header_type").value() == std::string_view("UInt64") ? 8 : 4),
        is_big_endian_(is_big_endian) {}

  void go_to_samples(std::uint64_t volume) {
    const std::uint64_t bytes = number();
    if (bytes != volume) refuse(bytes, volume);
  }

  void go_to_compressed_samples(std::uint64_t volume) {
    const std::uint64_t count = number();
    const std::uint64_t each = number();
    const std::uint64_t last = number();
    if (count == 0 || each == 0 || count - 1 > volume / each) refuse(count * each, volume);
    const std::uint64_t bytes = (count - 1) * each + (last == 0 ? each : last);
    if (bytes != volume) refuse(bytes, volume);
    stream_.skip(count * number_bytes_);
    stream_.decode([count](auto in) { return inflated_blocks(std::move(in), count); });
  }

 private:
  std::uint64_t number() {
    unsigned char bytes[8] = {};
    if (stream_.read(bytes, number_bytes_) < number_bytes_)
      fail(stream_.file(),
           "the array ends before its samples" +
               (stream_.damage().empty() ? "" : ": " + stream_.damage()),
           copy_or_export);
    return whole_of(bytes, number_bytes_, is_big_endian_);
  }

  [[noreturn]] void refuse(std::uint64_t found, std::uint64_t volume) const {
    fail(stream_.file(),
         "the array has " + std::to_string(found) + " bytes, the volume " + std::to_string(volume),
         copy_or_export);
  }

  ByteStream& stream_;
  std::size_t number_bytes_;
  bool is_big_endian_;
};

// Moves to the data of the array, in its encoding. Returns whether the encoding is base64.
bool go_to_array(ByteStream& stream, const Head& head) {
  if (!head.is_appended()) return true;
  char c = 0;
  while (c != '_')
    if (stream.read(&c, 1) == 0 || (c != '_' && !trimmed({&c, 1}).empty()))
      fail(stream.file(), "the appended data does not begin with _", "export the file again");
  const auto offset =
      integer(stream.file(), "offset", trimmed(head.array().attribute("offset").value()));
  if (offset < 0) fail(stream.file(), "the offset of the array is negative", "correct it");
  stream.skip(static_cast<std::uint64_t>(offset));
  return head.appended_encoding() == "base64";
}

// Opens the samples of the array that follows in the stream. info: its type and extents are set.
std::unique_ptr<VolumeReader> open_array(ByteStream stream, const Head& head, VolumeInfo info,
                                         const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const std::string_view compressor = head.root().attribute("compressor").value();
  if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
    fail(file, "samples of " + shown(compressor) + " are not supported",
         "write the file with zlib, or not compressed");
  const std::string_view order = head.root().attribute("byte_order").value();
  if (order != "LittleEndian" && order != "BigEndian")
    fail(file, "byte_order is " + shown(order), "write LittleEndian or BigEndian");
  bool is_big_endian = order == "BigEndian";
  const bool is_text = head.format() == "ascii";
  info.format = std::string("VTK XML, ") + (is_text ? "text" : compressor.empty() ? "raw" : "zlib");
  if (is_text) {
    is_big_endian = is_native_big_endian();
    stream.decode([&info](auto in) { return samples_of_text(std::move(in), info.type); });
  } else {
    if (go_to_array(stream, head)) stream.decode(base64_decoded);
    Blocks blocks(stream, head, is_big_endian);
    if (compressor.empty())
      blocks.go_to_samples(info.channels * bytes_of_all(info));
    else
      blocks.go_to_compressed_samples(info.channels * bytes_of_all(info));
  }
  // Other elements follow the array, whose length is stored.
  const auto no_note = [](ByteStream&) { return std::string(); };
  return channel_of(file, std::move(info), options.channel, [&](VolumeInfo all) {
    return std::make_unique<SliceStream>(std::move(all), std::move(stream), is_big_endian,
                                         std::nullopt, no_note);
  });
}

// Reads the coordinates of a grid's points along an axis.
std::vector<double> coordinates_of(const std::filesystem::path& file, std::size_t axis,
                                   std::uint32_t count) {
  ByteStream stream = open_content(file);
  const Head head(stream, axis);
  VolumeInfo info;
  info.type = sample_type(file, head.array().attribute("type").value());
  info.dims = {count, 1, 1};
  const auto array = open_array(std::move(stream), head, info, {});
  std::vector<unsigned char> bytes(info.slice_bytes());
  array->read_slice(bytes.data());
  std::vector<double> values(count);
  with_sample_type(info.type, [&](auto typed) {
    using Sample = decltype(typed);
    const auto* const samples = reinterpret_cast<const Sample*>(bytes.data());
    std::transform(samples, samples + count, values.begin(),
                   [](Sample sample) { return static_cast<double>(sample); });
  });
  return values;
}

void place_grid(DeclaredPlace& place, const std::filesystem::path& file, const Head& head,
                const VolumeInfo& info, const VolumeOptions& options) {
  place.directions = coordinates;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t count = info.dims[axis] + (head.is_of_cells() ? 1 : 0);
    set_place_from_coordinates(place, axis, file, std::string(1, "xyz"[axis]),
                               coordinates_of(file, axis, count), info.dims[axis], options);
  }
}

void set_geometry(VolumeInfo& info, const std::filesystem::path& file, const Head& head,
                  const VolumeOptions& options) {
  const auto extent = head.extent(head.image(), "WholeExtent");
  if (head.extent(head.piece(), "Extent") != extent)
    fail(file, "the image is in several pieces",
         "write it in one, or as .pvti with a file a piece");
  const bool is_of_cells = head.is_of_cells();
  const auto size = [&](std::size_t axis) { return vtk_size(extent, axis, is_of_cells); };
  set_dims(info, file, {size(0), size(1), size(2)});
  DeclaredPlace place;
  if (head.is_grid())
    place_grid(place, file, head, info, options);
  else
    place = declared_place(file, head.numbers(head.image(), "Spacing"),
                           head.numbers(head.image(), "Origin"),
                           head.numbers(head.image(), "Direction"), extent, is_of_cells);
  set_place(info, place, options);
}

}  // namespace

std::unique_ptr<VolumeReader> open_vti(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const Head head(stream);
  const std::int64_t components = integer(
      file, "NumberOfComponents", head.array().attribute("NumberOfComponents").as_string("1"));
  VolumeInfo info;
  info.type = sample_type(file, head.array().attribute("type").value());
  set_geometry(info, file, head, options);
  set_channels(info, file, static_cast<std::uint64_t>(std::max<std::int64_t>(1, components)),
               options.channel);
  note_arrays(info, head);
  return open_array(std::move(stream), head, std::move(info), options);
}

}  // namespace discmc::command
