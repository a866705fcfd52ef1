#include "mask_volume.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cropped_volume.hpp"
#include "shrunk_volume.hpp"
#include "volumes/format_list.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_filter.hpp"
#include "volumes/volume_offset.hpp"

namespace discmc::command {
namespace {

// 1 where the value is another number than 0.
class Mask final : public VolumeFilter {
 public:
  explicit Mask(std::unique_ptr<VolumeReader> volume)
      : VolumeFilter(std::move(volume)), slice_(info().slice_bytes()) {
    own_info().type = SampleType::u8;
    own_info().slope = 1;
    own_info().intercept = 0;
  }

  void read_slice(void* samples) override {
    const VolumeInfo& of = volume().info();
    volume().read_slice(slice_.data());
    with_sample_type(of.type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* const first = reinterpret_cast<const Sample*>(slice_.data());
      std::transform(first, first + slice_.size() / sizeof(Sample),
                     static_cast<std::uint8_t*>(samples), [&of](Sample sample) {
                       const double value = of.slope * static_cast<double>(sample) + of.intercept;
                       return static_cast<std::uint8_t>(value < 0 || value > 0 ? 1 : 0);
                     });
    });
  }

 private:
  std::vector<std::uint8_t> slice_;
};

// A mask whose axes are put in the order and direction of another volume.
class TurnedMask final : public VolumeFilter {
 public:
  TurnedMask(std::filesystem::path file, std::unique_ptr<VolumeReader> mask, const AxesMatch& match)
      : VolumeFilter(std::move(mask)),
        file_(std::move(file)),
        is_slice_by_slice_(match[2].axis == 2 && !match[2].is_reversed) {
    const VolumeInfo& of = volume().info();
    const VolumePlacement from = of.placement.value_or(along_coordinates(of.spacing_mm));
    const std::array<std::ptrdiff_t, 3> steps = {1, static_cast<std::ptrdiff_t>(of.dims[0]),
                                                 static_cast<std::ptrdiff_t>(of.slice_bytes())};
    VolumePlacement to = from;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [axis, is_reversed] = match[i];
      const double sign = is_reversed ? -1 : 1;
      const std::uint32_t last = of.dims[axis] - 1;
      own_info().dims[i] = of.dims[axis];
      own_info().spacing_mm[i] = sign * of.spacing_mm[axis];
      steps_[i] = is_reversed ? -steps[axis] : steps[axis];
      if (is_reversed) first_ += last * steps[axis];
      for (std::size_t j = 0; j < 3; ++j) {
        to.axes_mm[i][j] = sign * from.axes_mm[axis][j];
        if (is_reversed) to.origin_mm[j] += last * from.axes_mm[axis][j];
      }
    }
    own_info().placement = to;
    add_note("the axes are turned to those of the volume");
  }

  void read_slice(void* samples) override {
    require_slice_left(file_, next_, info().dims[2]);
    if (is_slice_by_slice_ || next_ == 0) read_mask();
    auto* out = static_cast<std::uint8_t*>(samples);
    const std::ptrdiff_t slice = first_ + (is_slice_by_slice_ ? 0 : next_ * steps_[2]);
    for (std::uint32_t y = 0; y < info().dims[1]; ++y)
      for (std::uint32_t x = 0; x < info().dims[0]; ++x)
        *out++ = slices_[static_cast<std::size_t>(slice + y * steps_[1] + x * steps_[0])];
    ++next_;
  }

  // Some slices of the volume are in no slice of the mask alone.
  void skip_slice() override {
    std::vector<std::uint8_t> dropped(info().slice_bytes());
    read_slice(dropped.data());
  }

 private:
  void read_mask() {
    const VolumeInfo& of = volume().info();
    const std::uint32_t count = is_slice_by_slice_ ? 1 : of.dims[2];
    for (std::uint32_t z = 0; z < count; ++z) {
      slices_.resize(of.slice_bytes() * (z + 1));  // no more than has come
      volume().read_slice(&slices_[of.slice_bytes() * z]);
    }
  }

  std::filesystem::path file_;
  bool is_slice_by_slice_;
  std::vector<std::uint8_t> slices_;       // of the mask: one, or all
  std::array<std::ptrdiff_t, 3> steps_{};  // in it, from a voxel to the next along x, y and z
  std::ptrdiff_t first_ = 0;               // voxel (0, 0, 0)
  std::uint32_t next_ = 0;
};

class MaskedLabels final : public VolumeFilter {
 public:
  MaskedLabels(std::unique_ptr<VolumeReader> volume, std::unique_ptr<VolumeReader> mask)
      : VolumeFilter(std::move(volume)), mask_(std::move(mask)), on_(mask_->info().slice_bytes()) {}

  void read_slice(void* samples) override {
    volume().read_slice(samples);
    mask_->read_slice(on_.data());
    with_whole_type(info().type, [&](auto typed) {
      auto* sample = static_cast<decltype(typed)*>(samples);
      for (const std::uint8_t is_on : on_) {
        if (is_on == 0) *sample = 0;
        ++sample;
      }
    });
  }

  void skip_slice() override {
    volume().skip_slice();
    mask_->skip_slice();
  }

 private:
  std::unique_ptr<VolumeReader> mask_;
  std::vector<std::uint8_t> on_;
};

// Those of a volume that has times or channels, too.
std::string axes_of_space(std::string axes) {
  const auto is_other = [](char letter) { return letter == 't' || letter == 'c'; };
  axes.erase(std::remove_if(axes.begin(), axes.end(), is_other), axes.end());
  return axes;
}

}  // namespace

std::unique_ptr<VolumeReader> masked(std::unique_ptr<VolumeReader> labels,
                                     std::unique_ptr<VolumeReader> mask) {
  return std::make_unique<MaskedLabels>(std::move(labels), std::move(mask));
}

std::unique_ptr<VolumeReader> open_mask(const std::filesystem::path& file,
                                        const VolumeOptions& options, const VolumeInfo& volume) {
  VolumeOptions of_all;
  of_all.spacing_mm = options.spacing_mm;
  of_all.allow_gaps = options.allow_gaps;
  // The options are those of the volume: none describes the mask.
  of_all.frame = 0;
  of_all.channel = 0;
  if (names_no_axes(file)) of_all.axes = axes_of_space(options.axes);
  auto mask = open_volume(file, of_all);
  if (mask->info().frames > 1)
    fail(file, "the mask holds " + std::to_string(mask->info().frames) + " volumes",
         "store the mask in a file of its own");
  if (mask->info().channels > 1)
    fail(file, "the mask holds " + std::to_string(mask->info().channels) + " channels",
         "store the mask in a file of its own");
  mask = std::make_unique<Mask>(std::move(mask));
  const AxesMatch match = matching_axes(volume, mask->info());
  if (!is_same(match)) mask = std::make_unique<TurnedMask>(file, std::move(mask), match);
  const auto whole = volume.whole_dims.value_or(volume.dims);
  if (mask->info().dims != whole)
    fail(file,
         "the mask has " + extents(mask->info().dims) + " voxels, and the volume " + extents(whole),
         "give a mask with a voxel for each voxel of the volume");
  if (options.crop) mask = cropped(file, std::move(mask), *options.crop);
  if (options.shrink > 1)
    mask = shrunk(file, std::move(mask), options.shrink, BlockValue::most_frequent);
  if (!is_same(match) && offset_mm(mask->info(), volume) > 0)
    fail(file, "the axes of the mask differ from those of the volume, and its voxels lie elsewhere",
         "resample the mask on the grid of the volume");
  return mask;
}

}  // namespace discmc::command
