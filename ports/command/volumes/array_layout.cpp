#include "array_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"
#include "volumes/filters/filters.hpp"

namespace discmc::command {
namespace {

constexpr std::string_view space_letters = "xyz";

using Sizes = std::vector<std::int64_t>;

std::string shape_text(const Sizes& sizes) {
  std::string text;
  for (const std::int64_t size : sizes) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text;
}

// Throws unless the number of samples and bytes fits 64 bits.
void require_countable(const std::filesystem::path& file, const Sizes& sizes) {
  constexpr std::int64_t max_sample_bytes = 8;
  std::int64_t max_samples = std::numeric_limits<std::int64_t>::max() / max_sample_bytes;
  for (const std::int64_t size : sizes) {
    if (size < 1 || size > max_samples)
      fail(file, "the array is " + shape_text(sizes) + ", nothing or more than a file can hold",
           "give an array of three axes");
    max_samples /= size;
  }
}

// Drops axes of size 1, the last first, until `count` axes are left. Returns these.
std::vector<std::size_t> kept_axes(const Sizes& sizes, std::size_t count) {
  std::vector<std::size_t> kept(sizes.size());
  for (std::size_t axis = 0; axis < kept.size(); ++axis) kept[axis] = axis;
  while (kept.size() > count) {
    const auto is_single = [&sizes](std::size_t axis) { return sizes[axis] == 1; };
    const auto dropped =
        is_single(kept.back()) ? kept.end() - 1 : std::find_if(kept.begin(), kept.end(), is_single);
    if (dropped == kept.end()) break;
    kept.erase(dropped);
  }
  return kept;
}

// Letters for unnamed axes: the last axes belong to the volume, all others count volumes.
std::string default_letters(std::size_t count) {
  std::string letters(count, 't');
  for (std::size_t i = 0; i < std::min<std::size_t>(count, 3); ++i)
    letters[count - 1 - i] = space_letters[i];
  return letters;
}

// An array as stored, the slowest axis first.
struct StoredArray {
  Sizes sizes;
  std::vector<std::size_t> axes;  // without dropped axes of size 1
  std::string letters;            // of `axes`
};

void note_default_axes(VolumeInfo& info, const ArrayShape& shape) {
  const bool is_first_fastest = shape.is_first_fastest;
  note(info, std::string("the axes are not named; read as array") +
                 (is_first_fastest ? "[x][y][z]" : "[z][y][x]") +
                 "; to read others, give --axes, such as " + (is_first_fastest ? "zyx" : "xyz"));
}

StoredArray stored_array(VolumeInfo& info, const std::filesystem::path& file,
                         const ArrayShape& shape, const std::string& named) {
  if (shape.sizes.size() < 2)
    fail(file, "the data has " + std::to_string(shape.sizes.size()) + " dimensions",
         "give a volume of three");
  StoredArray array{shape.sizes, {}, named};
  if (shape.is_first_fastest) {
    std::reverse(array.sizes.begin(), array.sizes.end());
    std::reverse(array.letters.begin(), array.letters.end());
  }
  require_countable(file, array.sizes);
  array.axes = kept_axes(array.sizes, named.empty() ? 3 : named.size());
  if (array.axes.size() < array.sizes.size())
    note(info, "axes of size 1 are dropped from " + shape_text(shape.sizes));
  if (named.empty()) array.letters = default_letters(array.axes.size());
  if (named.empty() && array.axes.size() > 2) note_default_axes(info, shape);
  if (array.letters.size() != array.axes.size())
    fail(file,
         "the axes are named " + shown(named) + ", but the array is " + shape_text(shape.sizes),
         "name each axis with --axes, as in --axes zyx");
  return array;
}

std::int64_t product_along(char letter, const StoredArray& array) {
  std::int64_t product = 1;
  for (std::size_t i = 0; i < array.axes.size(); ++i)
    if (array.letters[i] == letter) product *= array.sizes[array.axes[i]];
  return product;
}

// Begins the layout at an index along the last axis with this letter, which counts fastest.
void go_to(ArrayLayout& layout, const StoredArray& array, char letter, std::uint64_t index) {
  for (std::size_t i = array.axes.size(); i-- > 0;) {
    if (array.letters[i] != letter) continue;
    const std::size_t axis = array.axes[i];
    layout.first[axis] = index % layout.sizes[axis];
    index /= layout.sizes[axis];
  }
}

// Returns the distance between neighbouring samples along each axis. Units: samples.
std::vector<std::uint64_t> strides_of(const std::vector<std::uint64_t>& sizes) {
  std::vector<std::uint64_t> strides(sizes.size(), 1);
  for (std::size_t axis = sizes.size() - 1; axis-- > 0;)
    strides[axis] = strides[axis + 1] * sizes[axis + 1];
  return strides;
}

}  // namespace

std::size_t ArrayLayout::slowest() const {
  std::size_t axis = std::min(*axes[0], *axes[1]);
  return axes[2] ? std::min(axis, *axes[2]) : axis;
}

std::string ArrayLayout::order() const {
  std::string letters;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis)
    for (std::size_t i = 0; i < 3; ++i)
      if (axes[i] == axis) letters += space_letters[i];
  return letters;
}

ArrayLayout find_volume_axes(VolumeInfo& info, const std::filesystem::path& file,
                             const ArrayShape& shape, const VolumeOptions& options) {
  const std::string& named = options.axes.empty() ? shape.letters : options.axes;
  const StoredArray array = stored_array(info, file, shape, named);
  const std::int64_t frames = product_along('t', array);
  if (named.empty() && frames > 1 && !options.frame)
    fail(file, "the file holds " + std::to_string(frames) + " volumes, and one is read at a time",
         "choose one with --frame N, the first is 0; or name the axes of the array, " +
             shape_text(shape.sizes) + ", with --axes, as in --axes zyxc");

  ArrayLayout layout;
  layout.sizes.assign(array.sizes.begin(), array.sizes.end());
  layout.first.assign(array.sizes.size(), 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t found = array.letters.find(space_letters[i]);
    if (found != std::string::npos) layout.axes[i] = array.axes[found];
  }
  if (!layout.axes[0] || !layout.axes[1])
    fail(file, "the axes are named " + shown(named) + ", without x and y",
         "name the axes with --axes, as in --axes zyx");
  const auto size_of = [&](std::size_t i) { return array.sizes[*layout.axes[i]]; };
  Sizes dims{size_of(0), size_of(1)};
  if (layout.axes[2] || frames > 1) dims.push_back(layout.axes[2] ? size_of(2) : 1);
  if (frames > 1) dims.push_back(frames);
  set_dims(info, file, dims, options.frame);
  const auto channels = static_cast<std::uint64_t>(product_along('c', array));
  set_channels(info, file, channels, options.channel, shape.channels);
  go_to(layout, array, 't', options.frame.value_or(0));
  go_to(layout, array, 'c', options.channel.value_or(0));
  return layout;
}

char axis_letter(std::string_view name) {
  constexpr std::pair<char, std::array<std::string_view, 10>> letters[] = {
      {'x', {"x", "lon", "longitude", "easting", "column", "columns", "width", "i", "voxel_x"}},
      {'y', {"y", "lat", "latitude", "northing", "row", "rows", "height", "j", "voxel_y"}},
      {'z', {"z", "lev", "level", "depth", "altitude", "alt", "plane", "slice", "k", "voxel_z"}},
      {'t', {"t", "time", "frame"}},
      {'c', {"c", "channel", "band", "channels"}}};
  const std::string plain = lower(name);
  for (const auto& [letter, names] : letters)
    if (!plain.empty() && std::find(names.begin(), names.end(), plain) != names.end())
      return letter;
  return '?';
}

void set_place_from_coordinates(DeclaredPlace& place, std::size_t axis, const std::string& file,
                                const std::string& name, std::vector<double> coordinates,
                                std::uint64_t voxels, const VolumeOptions& options) {
  if (coordinates.size() == voxels + 1) {
    for (std::size_t i = 0; i < voxels; ++i)
      coordinates[i] = (coordinates[i] + coordinates[i + 1]) / 2;
    coordinates.pop_back();
  }
  if (coordinates.size() != voxels || voxels < 2) return;
  const auto steps = static_cast<double>(coordinates.size() - 1);
  const double step = (coordinates.back() - coordinates.front()) / steps;
  constexpr double share = 1e-2;  // tolerated rounding, as a share of a step
  for (std::size_t i = 0; i < coordinates.size() && !options.spacing_mm; ++i)
    if (!(std::fabs(coordinates.front() + static_cast<double>(i) * step - coordinates[i]) <=
          share * std::fabs(step)))
      fail(file,
           "the coordinates of the axis " + shown(name) + " are uneven, from " +
               short_number(coordinates.front()) + " to " + short_number(coordinates.back()),
           "resample the volume to even steps, or give their distances with --spacing");
  if (step == 0) return;
  place.spacing[axis] = step;
  place.origin[axis] = coordinates.front();
}

std::unique_ptr<VolumeReader> array_volume(VolumeInfo info, ByteStream stream,
                                           const ArrayLayout& layout, bool is_big_endian) {
  const std::filesystem::path file = stream.file();
  const std::vector<std::uint64_t> strides = strides_of(layout.sizes);
  const std::size_t slowest = layout.slowest();
  BlockLayout blocks;
  for (std::size_t i = 0; i < 3; ++i) {
    if (layout.axes[i]) blocks.strides[i] = strides[*layout.axes[i]];
    if (layout.axes[2] && layout.axes[i] == slowest) blocks.block_axis = i;
  }
  std::uint64_t skipped = 0, frames = 1;
  for (std::size_t axis = 0; axis < layout.sizes.size(); ++axis) {
    (axis < slowest ? skipped : blocks.first) += layout.first[axis] * strides[axis];
    if (axis < slowest) frames *= layout.sizes[axis];
  }
  const std::uint64_t in_all = strides[slowest] * layout.sizes[slowest];
  const auto frame = static_cast<std::uint32_t>(skipped / in_all);
  const std::uint64_t in_block = layout.axes[2] ? strides[slowest] : in_all;
  const bool is_plain = blocks.block_axis == 2 && blocks.strides[0] == 1 &&
                        blocks.strides[1] == info.dims[0] && frames == info.frames &&
                        in_block == std::uint64_t{info.dims[0]} * info.dims[1];
  if (is_plain)
    return std::make_unique<SliceStream>(std::move(info), std::move(stream), is_big_endian, frame);
  // Columns include all channels if the channel axis is faster than the volume.
  const std::uint64_t columns = layout.sizes.back();
  if (columns > UINT32_MAX || in_block / columns > UINT32_MAX || frames > UINT32_MAX)
    fail(file, "the array has " + std::to_string(in_block) + " samples per slice",
         "give an array with smaller slices");
  VolumeInfo block_info = info;
  block_info.dims = {static_cast<std::uint32_t>(columns),
                     static_cast<std::uint32_t>(in_block / columns), info.dims[blocks.block_axis]};
  block_info.frames = frames;
  return turned(
      std::move(info),
      std::make_unique<SliceStream>(std::move(block_info), std::move(stream), is_big_endian, frame),
      blocks, file);
}

}  // namespace discmc::command
