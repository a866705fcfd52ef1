// OME-Zarr 0.1 to 0.5, https://ngff.openmicroscopy.org: an image is a group of arrays, which hold
// one volume in several resolutions.
#include "image.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "chunks.hpp"
#include "text/words.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/array_name.hpp"
#include "volumes/byte_source.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

char letter_of(const std::string& name, const std::string& type) {
  if (type == "channel") return 'c';
  return name.size() == 1 && std::string_view("tczyx").find(name[0]) != std::string_view::npos
             ? name[0]
             : 't';
}

// Axes are objects since version 0.4, names in 0.3, and absent before.
std::vector<ZarrAxis> axes_of(const Json& multiscale) {
  const Json& listed = member(multiscale, "axes");
  std::vector<ZarrAxis> axes;
  for (const Json& axis : listed.is_array() ? listed : Json{"t", "c", "z", "y", "x"}) {
    const std::string name = axis.is_string() ? text_of(axis) : text_of(member(axis, "name"));
    axes.push_back(
        {letter_of(name, text_of(member(axis, "type"))), 1, 0, text_of(member(axis, "unit"))});
  }
  return axes;
}

// Applies scales and translations in order. Returns whether there was a scale.
bool transform(std::vector<ZarrAxis>& axes, const std::filesystem::path& file, const Json& steps) {
  bool has_scale = false;
  for (const Json& step : steps) {
    const std::string type = text_of(member(step, "type"));
    if (type == "identity") continue;
    if (type != "scale" && type != "translation")
      fail(file, "the coordinates are transformed by " + shown(type),
           "give an image with scales and translations only");
    const auto numbers = reals_of(file, type.c_str(), member(step, type.c_str()));
    if (numbers.size() != axes.size())
      fail(file, "a " + type + " has other axes than the image", "correct it");
    has_scale = has_scale || type == "scale";
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      if (type == "translation") {
        axes[axis].origin += numbers[axis];
      } else {
        axes[axis].scale *= numbers[axis];
        axes[axis].origin *= numbers[axis];
      }
    }
  }
  return has_scale;
}

bool fits(const ZarrDescription& array, const std::vector<ZarrAxis>& axes) {
  for (std::size_t axis = 0; axis < std::min(axes.size(), array.sizes.size()); ++axis)
    if ((axes[axis].letter == 'x' || axes[axis].letter == 'y') && array.sizes[axis] > max_across)
      return false;
  return true;
}

std::filesystem::path level_folder(const ZarrNode& image, const Json& dataset) {
  const std::string path = text_of(member(dataset, "path"));
  if (path.empty()) fail(image.file, "a level has no path", "write the image again");
  return beside(image.file, path);
}

// Returns the names and colours of labels, which have separate lists.
LabelTable labels_of(const Json& attributes) {
  const Json& label = member(attributes, "image-label");
  std::map<std::int64_t, LabelDescription> labels;
  const auto described = [&labels](const Json& entry) -> LabelDescription* {
    const Json& value = member(entry, "label-value");
    if (!value.is_number_integer()) return nullptr;
    LabelDescription& found = labels[value.get<std::int64_t>()];
    found.values = {LabelValue(value.get<std::int64_t>())};
    if (found.name.empty()) found.name = found.values[0].text();
    return &found;
  };
  for (const Json& property : member(label, "properties"))
    for (const char* key : {"name", "label", "class"})
      if (const std::string name = text_of(member(property, key)); !name.empty())
        if (LabelDescription* const found = described(property)) {
          found->name = name;
          break;
        }
  for (const Json& colour : member(label, "colors")) {
    const Json& rgba = member(colour, "rgba");
    std::array<std::uint8_t, 3> parts{};
    bool is_colour = rgba.is_array() && rgba.size() >= 3;
    for (std::size_t i = 0; i < 3 && is_colour; ++i) {
      is_colour = rgba[i].is_number_integer() && rgba[i] >= 0 && rgba[i] <= 255;
      if (is_colour) parts[i] = rgba[i].get<std::uint8_t>();
    }
    if (LabelDescription* const found = is_colour ? described(colour) : nullptr)
      found->colour = Srgb{parts[0], parts[1], parts[2]};
  }
  LabelTable table;
  for (auto& [value, each] : labels) table.push_back(std::move(each));
  return table;
}

// level: the requested resolution.
ZarrImage image_at(const ZarrNode& node, const Json& multiscale,
                   std::optional<std::uint32_t> level) {
  const Json& datasets = member(multiscale, "datasets");
  if (!datasets.is_array() || datasets.empty())
    fail(node.file, "the image has no levels", "write it again");
  if (level.value_or(0) >= datasets.size())
    fail(node.file,
         "there is no level " + std::to_string(*level) + ": the image has " +
             std::to_string(datasets.size()),
         "choose one with --level 0 to " + std::to_string(datasets.size() - 1));
  ZarrImage image;
  image.is_ome = true;
  std::size_t number = level.value_or(0);
  image.axes = axes_of(multiscale);
  image.array = described(read_zarr_node(level_folder(node, datasets[number])));
  while (!level && !fits(image.array, image.axes) && number + 1 < datasets.size())
    image.array = described(read_zarr_node(level_folder(node, datasets[++number])));
  if (datasets.size() > 1)
    image.level = "level " + std::to_string(number) + " of " + std::to_string(datasets.size());
  constexpr const char* listed = "coordinateTransformations";
  const bool is_scaled = transform(image.axes, node.file, member(datasets[number], listed));
  image.has_scale = transform(image.axes, node.file, member(multiscale, listed)) || is_scaled;
  image.labels = labels_of(node.attributes);
  for (const Json& channel : member(member(node.attributes, "omero"), "channels"))
    image.channels.push_back(text_of(member(channel, "label")));
  return image;
}

// Returns the image of an array that is a level of its parent group.
std::optional<ZarrImage> image_of_level(const std::filesystem::path& folder_of_array) {
  std::error_code ignored;
  const std::filesystem::path array = std::filesystem::canonical(folder_of_array, ignored);
  const std::filesystem::path folder = array.parent_path();
  if (!is_zarr(folder)) return std::nullopt;
  const ZarrNode parent = read_zarr_node(folder);
  const Json& multiscales = member(parent.attributes, "multiscales");
  if (parent.is_array || !multiscales.is_array() || multiscales.empty()) return std::nullopt;
  const Json& datasets = member(multiscales[0], "datasets");
  for (std::uint32_t level = 0; level < datasets.size(); ++level)
    if (text_of(member(datasets[level], "path")) == array.filename().native())
      return image_at(parent, multiscales[0], level);
  return std::nullopt;
}

std::vector<double> numbers_of(ZarrChunks line) {
  std::vector<double> numbers;
  const auto count = static_cast<std::uint64_t>(line.array().sizes[0]);
  for (std::uint64_t chunk = 0; numbers.size() < count; ++chunk) {
    const auto bytes = line.read({chunk});
    if (!bytes) return {};
    with_sample_type(line.array().type, [&](auto sample) {
      for (std::size_t at = 0; at < bytes->size() && numbers.size() < count; at += sizeof sample) {
        std::memcpy(&sample, bytes->data() + at, sizeof sample);
        numbers.push_back(static_cast<double>(sample));
      }
    });
  }
  return numbers;
}

// Reads coordinates of xarray: one-dimensional arrays beside the volume's, named like its axes.
void read_coordinates_of_axes(ZarrImage& image, const ZarrNode& node) {
  for (std::size_t i = 0; i < image.axes.size(); ++i) {
    ZarrAxis& axis = image.axes[i];
    axis.name = image.array.axis_names[i];
    if (axis.letter == 't' || axis.letter == 'c') continue;
    const std::filesystem::path folder = beside(node.folder, axis.name);
    if (!is_zarr(folder)) continue;
    const ZarrNode line = read_zarr_node(folder);
    if (!line.is_array) continue;
    ZarrDescription array = described(line);
    if (array.sizes != std::vector<std::int64_t>{image.array.sizes[i]}) continue;
    axis.unit = text_of(member(line.attributes, "units"));
    axis.coordinates = numbers_of(ZarrChunks(std::move(array)));
  }
}

// Decodes a floating-point fill value as xarray writes it in version 3: eight bytes, the lowest
// first.
std::optional<double> number_in_base64(const std::string& text) {
  constexpr std::size_t characters = 12;
  if (text.size() != characters) return std::nullopt;
  std::array<unsigned char, 8> bytes{};
  const auto source = base64_decoded(bytes_in_memory({text.begin(), text.end()}));
  if (source->read(bytes.data(), bytes.size()) < bytes.size() || text.back() != '=')
    return std::nullopt;
  const std::uint64_t bits = whole_of(bytes.data(), bytes.size(), false);
  double number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

ZarrImage image_of_array(const ZarrNode& node, const std::filesystem::path& folder,
                         const VolumeOptions& options) {
  if (options.level) fail(folder, "an array has no levels", "leave out --level");
  if (auto level = image_of_level(folder)) return std::move(*level);
  ZarrImage image;
  image.array = described(node);
  const auto number = [&node](const char* name) {
    const Json& value = member(node.attributes, name);
    return value.is_number() ? std::optional(value.get<double>())
                             : number_in_base64(text_of(value));
  };
  image.values = declared_values(number, text_of(member(node.attributes, "_Unsigned")));
  const auto& names = image.array.axis_names;
  // In version 2, xarray uses the chunks' fill value, which is otherwise 0.
  const Json& chunk_fill = member(node.array, "fill_value");
  if (!image.values.fill && !names.empty() && chunk_fill.is_number() && chunk_fill != 0 &&
      member(node.array, "zarr_format") == 2)
    image.values.fill = chunk_fill.get<double>();
  for (const std::string& name : names)
    if (const char letter = axis_letter(name); letter != '?') image.axes.push_back({letter});
  if (image.axes.size() != image.array.sizes.size()) image.axes.clear();
  read_coordinates_of_axes(image, node);
  return image;
}

// Returns the groups and arrays in a group.
std::vector<std::filesystem::path> children(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.is_directory(ignored) && is_zarr(entry.path())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

std::string list_of(const std::vector<std::filesystem::path>& folders) {
  constexpr std::size_t max_listed = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(folders.size(), max_listed); ++i)
    text += (i > 0 ? ", " : "") + without_control(folders[i].filename().string());
  return text + (folders.size() > max_listed ? ", ..." : "");
}

// Whether an array has less than two axes, like coordinates of xarray and single numbers.
bool has_no_plane(const std::filesystem::path& folder) {
  const ZarrNode node = read_zarr_node(folder);
  return node.is_array && member(node.array, "shape").size() < 2;
}

// Returns the only child of a group that is not an image: a series of bioformats2raw, a well, or
// labels.
std::filesystem::path only_child(const ZarrNode& node) {
  std::vector<std::filesystem::path> inner = children(node.folder);
  inner.erase(std::remove_if(inner.begin(), inner.end(),
                             [](const auto& folder) {
                               return folder.filename() == "OME" || has_no_plane(folder);
                             }),
              inner.end());
  if (inner.empty()) fail(node.folder, "the group holds no array", "give one that holds a volume");
  if (inner.size() > 1)
    fail(node.folder, "the group holds several images or arrays: " + list_of(inner),
         "choose one by its folder, as in " + (node.folder / inner[0].filename()).string());
  return inner[0];
}

}  // namespace

ZarrImage read_zarr_image(const std::filesystem::path& folder, const VolumeOptions& options) {
  constexpr int max_depth = 8;
  std::filesystem::path at = folder;
  for (int depth = 0; depth < max_depth; ++depth) {
    const ZarrNode node = read_zarr_node(at);
    if (node.is_array) return image_of_array(node, at, options);
    const Json& multiscales = member(node.attributes, "multiscales");
    if (multiscales.is_array() && !multiscales.empty())
      return image_at(node, multiscales[0], options.level);
    at = only_child(node);
  }
  fail(folder, "its groups contain each other", "give the folder of an image");
}

}  // namespace discmc::command
