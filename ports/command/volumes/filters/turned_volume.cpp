#include "turned_volume.hpp"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "volumes/volume_error.hpp"
#include "volumes/volume_filter.hpp"

namespace discmc::command {
namespace {

using Bytes = std::vector<unsigned char>;

// Samples in a plane: rows of them, and the way from one row and one sample to the next.
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
  // Reads the next block and takes the volume's samples of it, by rows along an axis.
  void read_plane(std::size_t row_axis, std::size_t column_axis, unsigned char* out) {
    volume().read_slice(block_.data());
    const Plane plane{info().dims[row_axis], info().dims[column_axis], layout_.strides[row_axis],
                      layout_.strides[column_axis]};
    with_sample_type(info().type, [&](auto sample) {
      copy_plane<decltype(sample)>(block_.data() + sizeof sample * layout_.first, plane, out);
    });
  }

  // All blocks, by rows along z.
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

}  // namespace

std::unique_ptr<VolumeReader> turned(VolumeInfo info, std::unique_ptr<VolumeReader> blocks,
                                     const BlockLayout& layout, const std::filesystem::path& file) {
  return std::make_unique<TurnedVolume>(std::move(info), std::move(blocks), layout, file);
}

}  // namespace discmc::command
