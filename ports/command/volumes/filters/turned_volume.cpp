#include "filters.hpp"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

using Bytes = std::vector<unsigned char>;

// Samples in a plane: rows, and the distances between rows and between samples.
struct Plane {
  std::uint64_t rows, columns;
  std::uint64_t row_stride, column_stride;
};

template <class Sample>
void copy_plane(const unsigned char* from, const Plane& plane, unsigned char* to) {
  for (std::uint64_t row = 0; row < plane.rows; ++row)
    for (std::uint64_t column = 0; column < plane.columns; ++column, to += sizeof(Sample))
      std::memcpy(to,
                  from + sizeof(Sample) * (row * plane.row_stride + column * plane.column_stride),
                  sizeof(Sample));
}

class TurnedVolume final : public VolumeFilter {
 public:
  TurnedVolume(VolumeInfo info, std::unique_ptr<VolumeReader> blocks, const BlockLayout& layout,
               std::filesystem::path file)
      : VolumeFilter(std::move(blocks)),
        layout_(layout),
        file_(std::move(file)),
        block_(volume().info().slice_bytes()) {
    info.format = volume().info().format;
    own_info() = std::move(info);
  }

  void read_slice(void* samples) override {
    require_slice_left(file_, next_, info().dims[2]);
    auto* out = static_cast<unsigned char*>(samples);
    if (layout_.block_axis == 2)
      read_plane(1, 0, out);
    else
      copy_slice(out);
    ++next_;
  }

  void skip_slice() override {
    require_slice_left(file_, next_, info().dims[2]);
    if (layout_.block_axis == 2) volume().skip_slice();
    ++next_;
  }

 private:
  // Reads the next block and copies the volume's samples in it, in rows along an axis.
  void read_plane(std::size_t row_axis, std::size_t column_axis, unsigned char* out) {
    volume().read_slice(block_.data());
    const Plane plane{info().dims[row_axis], info().dims[column_axis], layout_.strides[row_axis],
                      layout_.strides[column_axis]};
    with_sample_type(info().type, [&](auto sample) {
      copy_plane<decltype(sample)>(block_.data() + sizeof sample * layout_.first, plane, out);
    });
  }

  // Reads all blocks, in rows along z.
  void read_planes() {
    const std::size_t other_axis = 1 - layout_.block_axis;
    const std::uint64_t bytes =
        std::uint64_t{info().dims[2]} * info().dims[other_axis] * sample_bytes(info().type);
    while (planes_.size() < info().dims[layout_.block_axis]) {
      planes_.emplace_back(bytes);
      read_plane(2, other_axis, planes_.back().data());
    }
    Bytes().swap(block_);
  }

  void copy_slice(unsigned char* out) {
    if (planes_.empty()) read_planes();
    const std::uint64_t row_bytes = planes_.front().size() / info().dims[2];
    if (layout_.block_axis == 1) {
      for (const Bytes& plane : planes_)
        out = std::copy_n(&plane[next_ * row_bytes], row_bytes, out);
      return;
    }
    with_sample_type(info().type, [&](auto sample) {
      for (std::size_t x = 0; x < planes_.size(); ++x) {
        const unsigned char* column = &planes_[x][next_ * row_bytes];
        for (std::uint64_t y = 0; y < info().dims[1]; ++y, column += sizeof sample)
          std::memcpy(out + sizeof sample * (y * planes_.size() + x), column, sizeof sample);
      }
    });
  }

  BlockLayout layout_;
  std::filesystem::path file_;
  Bytes block_;
  std::vector<Bytes> planes_;
  std::uint32_t next_ = 0;
};

class VolumeTurnedTo final : public VolumeFilter {
 public:
  VolumeTurnedTo(const AxesMatch& match, std::unique_ptr<VolumeReader> reader,
                 std::filesystem::path file)
      : VolumeFilter(std::move(reader)),
        file_(std::move(file)),
        is_slice_by_slice_(match[2].axis == 2 && !match[2].is_reversed) {
    const VolumeInfo& from = volume().info();
    const VolumePlacement place = from.placement.value_or(along_coordinates(from.spacing_mm));
    const std::array<std::ptrdiff_t, 3> steps = {
        1, static_cast<std::ptrdiff_t>(from.dims[0]),
        static_cast<std::ptrdiff_t>(std::uint64_t{from.dims[0]} * from.dims[1])};
    VolumePlacement turned_place = place;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [axis, is_reversed] = match[i];
      const double sign = is_reversed ? -1 : 1;
      const std::uint32_t last = from.dims[axis] - 1;
      own_info().dims[i] = from.dims[axis];
      own_info().spacing_mm[i] = sign * from.spacing_mm[axis];
      steps_[i] = is_reversed ? -steps[axis] : steps[axis];
      if (is_reversed) first_ += last * steps[axis];
      for (std::size_t j = 0; j < 3; ++j) {
        turned_place.axes_mm[i][j] = sign * place.axes_mm[axis][j];
        if (is_reversed) turned_place.origin_mm[j] += last * place.axes_mm[axis][j];
      }
    }
    // Slice-by-slice reading never uses the step between slices.
    if (is_slice_by_slice_) steps_[2] = 0;
    own_info().placement = turned_place;
    add_note("the axes are turned to those of the other volume");
  }

  void read_slice(void* samples) override {
    require_slice_left(file_, next_, info().dims[2]);
    if (is_slice_by_slice_ || next_ == 0) read_slices();
    auto* out = static_cast<unsigned char*>(samples);
    const std::size_t size = sample_bytes(info().type);
    const std::ptrdiff_t slice = first_ + next_ * steps_[2];
    for (std::uint32_t y = 0; y < info().dims[1]; ++y)
      for (std::uint32_t x = 0; x < info().dims[0]; ++x, out += size)
        std::memcpy(
            out, &slices_[static_cast<std::size_t>(slice + y * steps_[1] + x * steps_[0]) * size],
            size);
    ++next_;
  }

  // A turned slice may consist of parts of many stored slices, so none can be skipped.
  void skip_slice() override {
    Bytes dropped(info().slice_bytes());
    read_slice(dropped.data());
  }

 private:
  void read_slices() {
    const VolumeInfo& stored = volume().info();
    const std::uint32_t count = is_slice_by_slice_ ? 1 : stored.dims[2];
    for (std::uint32_t z = 0; z < count; ++z) {
      slices_.resize(stored.slice_bytes() * (z + 1));  // grows with the slices that arrive
      volume().read_slice(&slices_[stored.slice_bytes() * z]);
    }
  }

  std::filesystem::path file_;
  bool is_slice_by_slice_;
  Bytes slices_;                           // as stored: one slice, or all
  std::array<std::ptrdiff_t, 3> steps_{};  // between neighbours along x, y and z in slices_
  std::ptrdiff_t first_ = 0;               // index of voxel (0, 0, 0)
  std::uint32_t next_ = 0;
};

}  // namespace

std::unique_ptr<VolumeReader> turned_to(const AxesMatch& match,
                                        std::unique_ptr<VolumeReader> volume,
                                        const std::filesystem::path& file) {
  return std::make_unique<VolumeTurnedTo>(match, std::move(volume), file);
}

std::unique_ptr<VolumeReader> turned(VolumeInfo info, std::unique_ptr<VolumeReader> blocks,
                                     const BlockLayout& layout, const std::filesystem::path& file) {
  return std::make_unique<TurnedVolume>(std::move(info), std::move(blocks), layout, file);
}

}  // namespace discmc::command
