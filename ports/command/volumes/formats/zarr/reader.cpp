// Zarr, and images of OME-Zarr, chunk by chunk.
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "chunks.hpp"
#include "image.hpp"
#include "text/words.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"

namespace discmc::command {
namespace {

// Holds as many slices as chunks are deep, so that each chunk is unpacked once.
class ZarrVolume final : public NumberedSlices {
 public:
  ZarrVolume(std::filesystem::path folder, VolumeInfo info, ZarrChunks chunks, ArrayLayout layout)
      : NumberedSlices(std::move(folder), std::move(info)),
        chunks_(std::move(chunks)),
        layout_(std::move(layout)) {
    constexpr std::uint64_t max_bytes = std::uint64_t{1} << 30;
    depth_ = std::clamp<std::uint64_t>(max_bytes / this->info().slice_bytes(), 1, chunk_size(2));
    const ZarrDescription& array = chunks_.array();
    std::uint64_t stride = 1;
    for (auto axis = array.order.rbegin(); axis != array.order.rend(); ++axis) {
      begin_ += layout_.first[*axis] % array.chunk[*axis] * stride;
      for (std::size_t i = 0; i < 3; ++i)
        if (layout_.axes[i] == *axis) strides_[i] = stride;
      stride *= array.chunk[*axis];
    }
  }

 private:
  void read(std::uint32_t slice, void* samples) override {
    if (slice < first_ || slice >= first_ + count_) read_slices(slice);
    const std::uint64_t bytes = info().slice_bytes();
    std::memcpy(samples, &slices_[(slice - first_) * bytes], bytes);
  }

  // Reads slices from `first` to the end of its chunks.
  void read_slices(std::uint64_t first) {
    const std::uint64_t deep = chunk_size(2);
    first_ = first;
    count_ = std::min({depth_, deep - first % deep, info().dims[2] - first});
    slices_.resize(count_ * info().slice_bytes());
    PerAxis chunk(layout_.sizes.size());
    for (std::size_t axis = 0; axis < chunk.size(); ++axis)
      chunk[axis] = layout_.first[axis] / chunks_.array().chunk[axis];
    if (layout_.axes[2]) chunk[*layout_.axes[2]] = first_ / deep;
    std::uint64_t& column = chunk[*layout_.axes[0]];
    std::uint64_t& row = chunk[*layout_.axes[1]];
    for (row = 0; row * chunk_size(1) < info().dims[1]; ++row)
      for (column = 0; column * chunk_size(0) < info().dims[0]; ++column)
        copy_chunk(chunks_.read(chunk), column * chunk_size(0), row * chunk_size(1));
  }

  // Returns the extent of a chunk along x, y or z.
  std::uint64_t chunk_size(std::size_t i) const {
    return layout_.axes[i] ? chunks_.array().chunk[*layout_.axes[i]] : 1;
  }

  // Copies a chunk into the slices, as far as the slices reach. x, y: its position.
  void copy_chunk(const std::optional<ChunkBytes>& samples, std::uint64_t x, std::uint64_t y) {
    const std::size_t size = sample_bytes(info().type);
    const std::uint64_t columns = std::min(chunk_size(0), info().dims[0] - x);
    const std::uint64_t rows = std::min(chunk_size(1), info().dims[1] - y);
    for (std::uint64_t z = 0; z < count_; ++z)
      for (std::uint64_t row = 0; row < rows; ++row) {
        const std::uint64_t offset = ((z * info().dims[1] + y + row) * info().dims[0] + x) * size;
        if (samples)
          copy_row(*samples, first_ % chunk_size(2) + z, row, columns, &slices_[offset]);
        else
          for (std::uint64_t i = 0; i < columns; ++i)
            std::memcpy(&slices_[offset + i * size], chunks_.array().fill.data(), size);
      }
  }

  // z, y: position in the chunk.
  void copy_row(const ChunkBytes& samples, std::uint64_t z, std::uint64_t y, std::uint64_t columns,
                unsigned char* to) const {
    with_sample_type(info().type, [&](auto sample) {
      constexpr std::size_t size = sizeof sample;
      const unsigned char* from = &samples[(begin_ + z * strides_[2] + y * strides_[1]) * size];
      if (strides_[0] == 1) {
        std::memcpy(to, from, columns * size);
        return;
      }
      for (std::uint64_t i = 0; i < columns; ++i)
        std::memcpy(to + i * size, from + i * strides_[0] * size, size);
    });
  }

  ZarrChunks chunks_;
  ArrayLayout layout_;
  // Offset of the frame and the channel in a chunk, and distances of neighbours along x, y and z.
  std::uint64_t begin_ = 0;
  std::array<std::uint64_t, 3> strides_{};
  std::uint64_t depth_ = 1;
  std::uint64_t first_ = 0;  // of the slices in memory
  std::uint64_t count_ = 0;
  std::vector<unsigned char> slices_;
};

// Every chunk costs an access, even if it does not exist.
void require_few_chunks(const std::filesystem::path& folder, const VolumeInfo& info,
                        const PerAxis& chunk, const ArrayLayout& layout) {
  constexpr std::uint64_t max_chunks = std::uint64_t{1} << 20;
  std::uint64_t chunks = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::uint64_t size = chunk[*layout.axes[i]];
    chunks *= (info.dims[i] + size - 1) / size;
  }
  if (chunks > max_chunks)
    fail(folder, "a slice needs " + std::to_string(chunks) + " chunks",
         "write it again with larger ones");
}

// Small files may declare large slices, and uniform chunks need little space.
void require_possible(const std::filesystem::path& folder, const VolumeInfo& info) {
  constexpr std::uint64_t max_of_a_byte = 65536;
  std::uint64_t bytes = 0;
  std::error_code error;
  using Iterator = std::filesystem::recursive_directory_iterator;
  for (Iterator entry(folder, error); !error && entry != Iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) bytes += entry->file_size(ignored);
    if (info.slice_bytes() / max_of_a_byte <= bytes) return;
  }
  fail(folder,
       "a slice of " + std::to_string(info.slice_bytes()) + " bytes cannot be in files of " +
           std::to_string(bytes),
       "copy the whole folder");
}

DeclaredPlace place_of(const ZarrImage& image, const std::filesystem::path& folder,
                       const ArrayLayout& layout, const VolumeOptions& options) {
  DeclaredPlace place;
  place.set_unit("mm");
  for (std::size_t i = 0; i < 3; ++i) {
    if (!layout.axes[i] || image.axes.empty()) continue;  // an image without z
    const ZarrAxis& axis = image.axes[*layout.axes[i]];
    if (!image.has_scale && axis.coordinates.empty()) continue;
    if (image.has_scale) {
      place.spacing[i] = axis.scale;
      place.origin[i] = axis.origin;
    }
    set_place_from_coordinates(place, i, folder, axis.name, axis.coordinates,
                               layout.sizes[*layout.axes[i]], options);
    place.axis_units[i] = place.space_units[i] = axis.unit;
  }
  return place;
}

std::string letters_of(const ZarrImage& image) {
  std::string letters;
  for (const ZarrAxis& axis : image.axes) letters += axis.letter;
  return letters;
}

}  // namespace

std::unique_ptr<VolumeReader> open_zarr(const std::filesystem::path& path,
                                        const VolumeOptions& options) {
  std::error_code ignored;
  std::filesystem::path folder = path.lexically_normal();
  if (!folder.has_filename() || !std::filesystem::is_directory(folder, ignored))
    folder = folder.parent_path();
  ZarrImage image = read_zarr_image(folder, options);
  VolumeInfo info;
  info.type = image.array.type;
  info.labels = std::move(image.labels);
  info.format = image.is_ome ? "OME-Zarr" : "Zarr";
  if (options.holds_labels && image.is_ome && is_zarr(folder / "labels"))
    note(info, "these are the samples of the image; its labels lie in " +
                   without_control((folder / "labels").string()));
  if (!image.level.empty()) info.format += ", " + image.level;
  const ArrayShape shape{image.array.sizes, letters_of(image), image.channels};
  const ArrayLayout layout = find_volume_axes(info, folder, shape, options);
  set_place(info, place_of(image, folder, layout, options), options);
  require_few_chunks(folder, info, image.array.chunk, layout);
  require_possible(image.array.folder, info);
  const std::optional<double> fill = set_values(info, folder, image.values);
  std::unique_ptr<VolumeReader> volume = std::make_unique<ZarrVolume>(
      folder, std::move(info), ZarrChunks(std::move(image.array)), layout);
  if (!fill || options.holds_labels) return volume;
  return without_fill(std::move(volume), *fill);
}

}  // namespace discmc::command
