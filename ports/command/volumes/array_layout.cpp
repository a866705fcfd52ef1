#include "array_layout.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "volume_error.hpp"
#include "volumes/filters/turned_volume.hpp"

namespace discmc::command {
namespace {

constexpr std::string_view space_letters = "xyz";

using Sizes = std::vector<std::int64_t>;

std::string shape_text(const Sizes& sizes) {
  std::string text;
  for (const std::int64_t size : sizes) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text;
}

// So that all samples, and their bytes, can be counted.
void require_countable(const std::filesystem::path& file, const Sizes& sizes) {
  constexpr std::int64_t max_sample_bytes = 8;
  std::int64_t most = std::numeric_limits<std::int64_t>::max() / max_sample_bytes;
  for (const std::int64_t size : sizes) {
    if (size < 1 || size > most)
      fail(file, "the array is " + shape_text(sizes) + ", which no file holds",
           "give an array of three axes");
    most /= size;
  }
}

// Returns the axes that are left when those of size 1 are dropped until there are so many, the last
// ones first.
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

// Those of axes of which nothing is said: the last ones are of the volume, all others of time.
std::string default_letters(std::size_t count) {
  std::string letters(count, 't');
  for (std::size_t i = 0; i < std::min<std::size_t>(count, 3); ++i)
    letters[count - 1 - i] = space_letters[i];
  return letters;
}

std::int64_t product_along(char letter, const Sizes& sizes, const std::vector<std::size_t>& axes,
                           std::string_view letters) {
  std::int64_t product = 1;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (letters[i] == letter) product *= sizes[axes[i]];
  return product;
}

// Of the axes with a letter, the last one counts fastest.
void go_to(ArrayLayout& layout, char letter, std::uint64_t index,
           const std::vector<std::size_t>& axes, std::string_view letters) {
  for (std::size_t i = axes.size(); i-- > 0;) {
    if (letters[i] != letter) continue;
    layout.first[axes[i]] = index % layout.sizes[axes[i]];
    index /= layout.sizes[axes[i]];
  }
}

// From a sample to the next one along each axis. Units: samples.
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

ArrayLayout take_array(VolumeInfo& info, const std::filesystem::path& file, const ArrayShape& shape,
                       const VolumeOptions& options) {
  const std::string shape_shown = shape_text(shape.sizes);
  const std::string& said = options.axes.empty() ? shape.letters : options.axes;
  Sizes sizes = shape.sizes;
  std::string letters = said;
  if (shape.is_first_fastest) {
    std::reverse(sizes.begin(), sizes.end());
    std::reverse(letters.begin(), letters.end());
  }
  if (sizes.size() < 2)
    fail(file, "the data has " + std::to_string(sizes.size()) + " dimensions",
         "give a volume of three");
  require_countable(file, sizes);
  const auto axes = kept_axes(sizes, said.empty() ? 3 : said.size());
  if (said.empty()) letters = default_letters(axes.size());
  if (letters.size() != axes.size())
    fail(file, "the axes are said to be " + shown(said) + ", but the array is " + shape_shown,
         "name each of them with --axes, as in --axes zyx");
  if (axes.size() < sizes.size()) note(info, "axes of size 1 dropped of " + shape_shown);
  const std::int64_t frames = product_along('t', sizes, axes, letters);
  if (said.empty() && frames > 1 && !options.frame)
    fail(file, "the file holds " + std::to_string(frames) + " volumes, and one is read at a time",
         "choose one with --frame N, the first is 0; or say which axis of the array, " +
             shape_shown + ", is which, as in --axes zyxc");

  ArrayLayout layout;
  layout.sizes.assign(sizes.begin(), sizes.end());
  layout.first.assign(sizes.size(), 0);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t found = letters.find(space_letters[i]);
    if (found != std::string::npos) layout.axes[i] = axes[found];
  }
  if (!layout.axes[0] || !layout.axes[1])
    fail(file, "the axes are said to be " + shown(said) + ", without x and y",
         "name them with --axes, as in --axes zyx");
  Sizes dims{sizes[*layout.axes[0]], sizes[*layout.axes[1]]};
  if (layout.axes[2] || frames > 1) dims.push_back(layout.axes[2] ? sizes[*layout.axes[2]] : 1);
  if (frames > 1) dims.push_back(frames);
  set_dims(info, file, dims, options.frame);
  go_to(layout, 't', options.frame.value_or(0), axes, letters);
  set_channels(info, file, static_cast<std::uint64_t>(product_along('c', sizes, axes, letters)),
               options.channel, shape.channels);
  go_to(layout, 'c', options.channel.value_or(0), axes, letters);
  return layout;
}

std::unique_ptr<VolumeReader> array_volume(VolumeInfo info, ByteStream stream,
                                           const ArrayLayout& layout, bool big_endian) {
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
    return std::make_unique<SliceStream>(std::move(info), std::move(stream), big_endian, frame);
  // Those of all channels, where these are faster than the volume.
  const std::uint64_t columns = layout.sizes.back();
  if (columns > UINT32_MAX || in_block / columns > UINT32_MAX || frames > UINT32_MAX)
    fail(file, "the array has " + std::to_string(in_block) + " samples a slice",
         "give a part of it");
  VolumeInfo of_blocks = info;
  of_blocks.dims = {static_cast<std::uint32_t>(columns),
                    static_cast<std::uint32_t>(in_block / columns), info.dims[blocks.block_axis]};
  of_blocks.frames = frames;
  return turned(
      std::move(info),
      std::make_unique<SliceStream>(std::move(of_blocks), std::move(stream), big_endian, frame),
      blocks, file);
}

}  // namespace discmc::command
