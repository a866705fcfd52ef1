#include "filters.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

class CroppedVolume final : public VolumeFilter {
 public:
  /// info: of the part, which begins at the voxel `first`.
  CroppedVolume(std::filesystem::path file, std::unique_ptr<VolumeReader> volume, VolumeInfo info,
                const std::array<std::uint32_t, 3>& first)
      : VolumeFilter(std::move(volume)),
        file_(std::move(file)),
        first_(first),
        slice_(this->info().slice_bytes()) {
    own_info() = std::move(info);
  }

  void read_slice(void* samples) override {
    go_to_next();
    volume().read_slice(slice_.data());
    const std::size_t size = sample_bytes(info().type);
    const std::size_t stride = size * volume().info().dims[0];
    const std::uint8_t* row = slice_.data() + first_[1] * stride + first_[0] * size;
    auto* out = static_cast<std::uint8_t*>(samples);
    for (std::uint32_t y = 0; y < info().dims[1]; ++y, row += stride)
      out = std::copy_n(row, size * info().dims[0], out);
  }

  void skip_slice() override {
    go_to_next();
    volume().skip_slice();
  }

 private:
  void go_to_next() {
    if (next_ == first_[2] + info().dims[2])
      fail(file_, "all " + std::to_string(info().dims[2]) + " slices of the part have been read",
           "open the volume again");
    for (; next_ < first_[2]; ++next_) volume().skip_slice();
    ++next_;
  }

  std::filesystem::path file_;
  std::array<std::uint32_t, 3> first_;
  std::uint32_t next_ = 0;  // next slice of `volume`
  std::vector<std::uint8_t> slice_;
};

[[noreturn]] void fail_outside(const std::filesystem::path& file, const VolumeInfo& info,
                               const VoxelRange& range, std::size_t axis) {
  fail(file,
       "--crop selects the voxels " + std::to_string(range.first) + ".." +
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
