#include "mask_volume.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cropped_volume.hpp"
#include "shrunk_volume.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::command {
namespace {

// 1 where the value is another number than 0.
class Mask final : public VolumeReader {
 public:
  explicit Mask(std::unique_ptr<VolumeReader> volume)
      : volume_(std::move(volume)), info_(volume_->info()), slice_(info_.slice_bytes()) {
    info_.type = SampleType::u8;
    info_.slope = 1;
    info_.intercept = 0;
  }

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    const VolumeInfo& of = volume_->info();
    volume_->read_slice(slice_.data());
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
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
  std::vector<std::uint8_t> slice_;
};

class MaskedLabels final : public VolumeReader {
 public:
  MaskedLabels(std::unique_ptr<VolumeReader> volume, std::unique_ptr<VolumeReader> mask)
      : volume_(std::move(volume)), mask_(std::move(mask)), on_(mask_->info().slice_bytes()) {}

  const VolumeInfo& info() const override { return volume_->info(); }

  void read_slice(void* samples) override {
    volume_->read_slice(samples);
    mask_->read_slice(on_.data());
    with_whole_type(info().type, [&](auto typed) {
      auto* sample = static_cast<decltype(typed)*>(samples);
      for (const std::uint8_t is_on : on_) {
        if (is_on == 0) *sample = 0;
        ++sample;
      }
    });
  }

 private:
  std::unique_ptr<VolumeReader> volume_;
  std::unique_ptr<VolumeReader> mask_;
  std::vector<std::uint8_t> on_;
};

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
  // The options are those of the volume: none tells what is in a mask.
  of_all.frame = 0;
  auto mask = open_volume(file, of_all);
  if (mask->info().frames > 1)
    fail(file, "the mask holds " + std::to_string(mask->info().frames) + " volumes",
         "store the one to take in a file of its own");
  const auto whole = volume.whole_dims.value_or(volume.dims);
  if (mask->info().dims != whole)
    fail(file,
         "the mask has " + extents(mask->info().dims) + " voxels, and the volume " + extents(whole),
         "give a mask with a voxel for each of the volume's");
  if (options.crop) mask = cropped(file, std::move(mask), *options.crop);
  mask = std::make_unique<Mask>(std::move(mask));
  if (options.shrink > 1)
    mask = shrunk(file, std::move(mask), options.shrink, BlockValue::most_frequent);
  return mask;
}

}  // namespace discmc::command
