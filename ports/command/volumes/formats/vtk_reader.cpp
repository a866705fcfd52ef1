// VTK's legacy format, https://docs.vtk.org/en/latest/vtk_file_formats/vtk_legacy_file_format.html:
// lines of keywords up to the first array of samples, which are big-endian or text.
#include <algorithm>
#include <utility>

#include "text/words.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

struct Header {
  bool is_text = false;
  std::vector<std::int64_t> sizes;
  std::int64_t samples = 0;
  bool are_of_cells = false;  // in cells between points, else at points
  DeclaredPlace place;
  std::string type;
  std::string components = "1";
};

SampleType sample_type(const std::filesystem::path& file, const std::string& type) {
  constexpr std::pair<std::string_view, SampleType> names[] = {
      {"unsigned_char", SampleType::u8}, {"char", SampleType::i8},
      {"signed_char", SampleType::i8},   {"unsigned_short", SampleType::u16},
      {"short", SampleType::i16},        {"unsigned_int", SampleType::u32},
      {"int", SampleType::i32},          {"unsigned_long", SampleType::u64},
      {"long", SampleType::i64},         {"vtktypeuint64", SampleType::u64},
      {"vtktypeint64", SampleType::i64}, {"float", SampleType::f32},
      {"double", SampleType::f64}};
  for (const auto& [name, of_name] : names)
    if (type == name) return of_name;
  fail_type(file, type);
}

class HeaderReader {
 public:
  explicit HeaderReader(ByteStream& stream) : stream_(stream) {}

  Header read() {
    line();  // the magic number
    line();  // a title
    const std::string storage = lower(trimmed(line()));
    if (storage != "ascii" && storage != "binary")
      refuse("the third line is " + shown(storage), "write ASCII or BINARY there");
    header_.is_text = storage == "ascii";
    while (header_.type.empty()) read_header_line(line());
    return std::move(header_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const {
    fail(stream_.file(), what, remedy);
  }

  std::string line() {
    auto line = stream_.read_line();
    if (!line) refuse("the header holds no array of samples", "give an image with samples");
    return std::move(*line);
  }

  void expect_words(const std::vector<std::string_view>& found, std::size_t count) const {
    if (found.size() < count)
      refuse(lower(found[0]) + " is followed by " + std::to_string(found.size() - 1) + " words",
             "correct the header");
  }

  std::array<double, 3> reals(const std::vector<std::string_view>& found) const {
    expect_words(found, 4);
    std::array<double, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i) numbers[i] = real(stream_.file(), found[0], found[i + 1]);
    return numbers;
  }

  void read_header_line(const std::string& text) {
    const auto found = words(text);
    if (found.empty()) return;
    const std::string key = lower(found[0]);
    if (key == "dataset") {
      expect_words(found, 2);
      if (lower(found[1]) != "structured_points")
        refuse("the data set is of kind " + shown(found[1]), "give structured points: an image");
    } else if (key == "dimensions") {
      expect_words(found, 4);
      header_.sizes.clear();
      for (std::size_t i = 1; i <= 3; ++i)
        header_.sizes.push_back(integer(stream_.file(), key, found[i]));
    } else if (key == "spacing" || key == "aspect_ratio") {
      const auto spacing = reals(found);
      std::copy(spacing.begin(), spacing.end(), header_.place.spacing.begin());
    } else if (key == "origin") {
      header_.place.origin = reals(found);
    } else if (key == "point_data" || key == "cell_data") {
      expect_words(found, 2);
      header_.samples = integer(stream_.file(), key, found[1]);
      header_.are_of_cells = key == "cell_data";
      are_arrays_next_ = true;
    } else if (key == "metadata") {
      skip_metadata();
    } else if (key == "field" && !are_arrays_next_) {
      expect_words(found, 3);
      skip_field(integer(stream_.file(), key, found[2]));
    } else if (are_arrays_next_) {
      read_array(key, found);
    } else {
      refuse("the header line " + shown(text) + " is unknown", "correct the header");
    }
  }

  void skip_metadata() {
    while (!trimmed(line()).empty()) continue;
  }

  // Skips the field data beside the image, such as a time.
  void skip_field(std::int64_t arrays) {
    while (arrays > 0) {
      const std::string text = line();
      const auto parts = words(text);
      if (parts.empty()) continue;
      if (lower(parts[0]) == "metadata") {
        skip_metadata();
        continue;
      }
      constexpr std::int64_t max_count = 1 << 20;
      const auto count = [&](std::size_t place) {
        return parts.size() < 4 ? -1
                                : integer(stream_.file(), "the size of field data", parts[place]);
      };
      if (count(1) < 0 || count(1) > max_count || count(2) < 0 || count(2) > max_count)
        refuse("the field's line " + shown(text) + " is not that of an array",
               "leave the field out");
      const std::int64_t values = count(1) * count(2);
      if (header_.is_text)
        for (auto left = values; left > 0;) left -= static_cast<std::int64_t>(words(line()).size());
      else
        stream_.skip(static_cast<std::uint64_t>(values) *
                     sample_bytes(sample_type(stream_.file(), lower(parts[3]))));
      --arrays;
    }
  }

  void read_array(const std::string& key, const std::vector<std::string_view>& found) {
    if (key == "scalars") {
      expect_words(found, 3);
      header_.type = lower(found[2]);
      if (found.size() > 3) header_.components = found[3];
      const std::string table = line();
      if (words(table).empty() || lower(words(table)[0]) != "lookup_table")
        refuse("after SCALARS the header has " + shown(table), "name a LOOKUP_TABLE there");
    } else if (key == "vectors" || key == "normals") {
      expect_words(found, 3);
      header_.type = lower(found[2]);
      header_.components = "3";
    } else if (key == "color_scalars") {
      // Colours are bytes in binary files, and shares of 255 in text.
      expect_words(found, 3);
      if (header_.is_text)
        refuse("the samples are colours in text", "store them in binary, or with SCALARS");
      header_.type = "unsigned_char";
      header_.components = found[2];
    } else if (key == "field") {
      const std::string array = line();
      const auto parts = words(array);
      if (parts.size() < 4) refuse("the field's line " + shown(array) + " is short", "correct it");
      header_.components = parts[1];
      header_.samples = integer(stream_.file(), "the field's length", parts[2]);
      header_.type = lower(parts[3]);
    } else {
      refuse("the first array is of kind " + shown(key), "store scalars first");
    }
  }

  ByteStream& stream_;
  Header header_;
  bool are_arrays_next_ = false;
};

// There is one cell less than points along each axis, and its centre is half a step behind a point.
std::vector<std::int64_t> sizes(const Header& header) {
  std::vector<std::int64_t> sizes = header.sizes;
  for (std::int64_t& size : sizes) size -= header.are_of_cells ? 1 : 0;
  return sizes;
}

DeclaredPlace place(const Header& header) {
  DeclaredPlace place = header.place;
  for (std::size_t axis = 0; axis < 3 && header.are_of_cells; ++axis)
    place.origin[axis] += place.spacing[axis].value_or(1) / 2;
  return place;
}

// Notes further arrays. The decoder of text ends at the first word that is not a number.
std::string note_of_rest(ByteStream& stream) {
  constexpr std::size_t max_shown = 256;
  std::string_view text = trimmed(stream.peek(max_shown));
  const std::string damage = stream.damage();
  const std::string_view line = next_line(text).value_or("");
  if (line.empty() && damage.empty()) return {};
  return "everything after the first array is left out: " + (damage.empty() ? shown(line) : damage);
}

}  // namespace

std::unique_ptr<VolumeReader> open_vtk(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const Header header = HeaderReader(stream).read();
  VolumeInfo info;
  info.type = sample_type(file, header.type);
  info.format = header.is_text ? "VTK, text" : "VTK, raw";
  set_dims(info, file, sizes(header));
  const std::int64_t components = integer(file, "the number of components", header.components);
  set_channels(info, file, static_cast<std::uint64_t>(std::max<std::int64_t>(1, components)),
               options.channel);
  set_place(info, place(header), options);
  const std::uint64_t voxels = volume_bytes(info) / sample_bytes(info.type);
  if (header.samples < 0 || static_cast<std::uint64_t>(header.samples) != voxels)
    fail(file,
         "there are " + std::to_string(header.samples) + " samples for the " +
             std::to_string(voxels) + (header.are_of_cells ? " cells" : " points") +
             " of DIMENSIONS",
         "correct the header");
  if (header.is_text)
    stream.decode([&info](auto in) { return samples_of_text(std::move(in), info.type); });
  const bool is_big_endian = header.is_text ? is_native_big_endian() : true;
  return channel_of(file, std::move(info), options.channel, [&](VolumeInfo all) {
    return std::make_unique<SliceStream>(std::move(all), std::move(stream), is_big_endian,
                                         std::nullopt, note_of_rest);
  });
}

}  // namespace discmc::command
