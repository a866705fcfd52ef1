#include "filters.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "volumes/format_list.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"
#include "volumes/volume_offset.hpp"

namespace discmc::command {
namespace {

// Samples are 1 if the value is a number other than 0.
class Mask final : public VolumeFilter {
 public:
  explicit Mask(std::unique_ptr<VolumeReader> volume)
      : VolumeFilter(std::move(volume)), slice_(info().slice_bytes()) {
    own_info().type = SampleType::u8;
    own_info().slope = 1;
    own_info().intercept = 0;
  }

  void read_slice(void* samples) override {
    const VolumeInfo& source = volume().info();
    volume().read_slice(slice_.data());
    with_sample_type(source.type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* const first = reinterpret_cast<const Sample*>(slice_.data());
      std::transform(first, first + slice_.size() / sizeof(Sample),
                     static_cast<std::uint8_t*>(samples), [&source](Sample sample) {
                       const double value =
                           source.slope * static_cast<double>(sample) + source.intercept;
                       return static_cast<std::uint8_t>(value < 0 || value > 0 ? 1 : 0);
                     });
    });
  }

 private:
  std::vector<std::uint8_t> slice_;
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

// Returns the axes without times and channels.
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
  VolumeOptions mask_options;
  mask_options.spacing_mm = options.spacing_mm;
  mask_options.allow_gaps = options.allow_gaps;
  // The frame, channel and layout in the options describe the volume, not the mask.
  mask_options.frame = 0;
  mask_options.channel = 0;
  if (names_no_axes(file)) mask_options.axes = axes_of_space(options.axes);
  auto mask = open_volume(file, mask_options);
  if (mask->info().frames > 1)
    fail(file, "the mask holds " + std::to_string(mask->info().frames) + " volumes",
         "store the mask in a file of its own");
  if (mask->info().channels > 1)
    fail(file, "the mask holds " + std::to_string(mask->info().channels) + " channels",
         "store the mask in a file of its own");
  mask = std::make_unique<Mask>(std::move(mask));
  const AxesMatch match = matching_axes(volume, mask->info());
  if (!is_same(match)) mask = turned_to(match, std::move(mask), file);
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
