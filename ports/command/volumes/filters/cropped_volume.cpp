#include "cropped_volume.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "volumes/volume_format.hpp"

namespace discmc::command {
namespace {

class CroppedVolume final : public VolumeReader {
 public:
  /// info: of the part, which begins at the voxel `first`.
  CroppedVolume(std::filesystem::path file, std::unique_ptr<VolumeReader> volume, VolumeInfo info,
                const std::array<std::uint32_t, 3>& first)
      : file_(std::move(file)),
        volume_(std::move(volume)),
        info_(std::move(info)),
        first_(first),
        slice_(volume_->info().slice_bytes()) {}

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    const std::uint32_t end = first_[2] + info_.dims[2];
    if (next_ == end)
      fail(file_, "all " + std::to_string(info_.dims[2]) + " slices of the part have been read",
           "open the volume again");
    for (; next_ < first_[2]; ++next_) volume_->skip_slice();
    volume_->read_slice(slice_.data());
    ++next_;

    const std::size_t size = sample_bytes(info_.type);
    const std::size_t stride = size * volume_->info().dims[0];
    const std::uint8_t* row = slice_.data() + first_[1] * stride + first_[0] * size;
    auto* out = static_cast<std::uint8_t*>(samples);
    for (std::uint32_t y = 0; y < info_.dims[1]; ++y, row += stride)
      out = std::copy_n(row, size * info_.dims[0], out);
  }

 private:
  std::filesystem::path file_;
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
  std::array<std::uint32_t, 3> first_;
  std::uint32_t next_ = 0;  // slice of the volume
  std::vector<std::uint8_t> slice_;
};

[[noreturn]] void fail_outside(const std::filesystem::path& file, const VolumeInfo& info,
                               const VoxelRange& range, std::size_t axis) {
  fail(file,
       "--crop asks for the voxels " + std::to_string(range.first) + ".." +
           (range.last ? std::to_string(*range.last) : "") + " along " + "xyz"[axis] +
           ", but the volume has " + extents(info.dims),
       "give a part of 0.." + std::to_string(info.dims[axis] - 1));
}

}  // namespace

std::unique_ptr<VolumeReader> cropped(const std::filesystem::path& file,
                                      std::unique_ptr<VolumeReader> volume, const Crop& crop) {
  VolumeInfo info = volume->info();
  std::array<std::uint32_t, 3> first{}, dims{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t last = crop[axis].last.value_or(info.dims[axis] - 1);
    first[axis] = crop[axis].first;
    if (first[axis] > last || last >= info.dims[axis]) fail_outside(file, info, crop[axis], axis);
    dims[axis] = last - first[axis] + 1;
  }
  std::array<double, 3> at{};
  std::copy(first.begin(), first.end(), at.begin());
  set_part(info, file, dims, at, 1);
  return std::make_unique<CroppedVolume>(file, std::move(volume), std::move(info), first);
}

}  // namespace discmc::command
