#include "mask_volume.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cropped_volume.hpp"
#include "shrunk_volume.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_filter.hpp"

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

// The sample that stands for 0; nothing where the type has none.
template <class Sample>
std::optional<Sample> zero_of(const VolumeInfo& info) {
  const double exact = -info.intercept / info.slope;
  for (const double stored : {std::round(exact), exact}) {
    // The largest sample of 64 bits is none of double, but the one above it is.
    if (!(stored >= static_cast<double>(std::numeric_limits<Sample>::lowest()) &&
          stored < static_cast<double>(std::numeric_limits<Sample>::max()) + 1))
      continue;
    const auto sample = static_cast<Sample>(stored);
    if (info.slope * static_cast<double>(sample) + info.intercept == 0) return sample;
  }
  return std::nullopt;
}

class MaskedVolume final : public VolumeFilter {
 public:
  MaskedVolume(std::unique_ptr<VolumeReader> volume, std::unique_ptr<VolumeReader> mask)
      : VolumeFilter(std::move(volume)), mask_(std::move(mask)), on_(mask_->info().slice_bytes()) {}

  void read_slice(void* samples) override {
    volume().read_slice(samples);
    mask_->read_slice(on_.data());
    with_sample_type(info().type, [&](auto typed) {
      using Sample = decltype(typed);
      const Sample zero = *zero_of<Sample>(info());
      auto* sample = static_cast<Sample*>(samples);
      for (const std::uint8_t is_on : on_) {
        if (is_on == 0) *sample = zero;
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

}  // namespace

std::unique_ptr<VolumeReader> masked(const std::filesystem::path& file,
                                     std::unique_ptr<VolumeReader> volume,
                                     std::unique_ptr<VolumeReader> mask) {
  const VolumeInfo& info = volume->info();
  with_sample_type(info.type, [&](auto typed) {
    if (!zero_of<decltype(typed)>(info))
      fail(file, "no sample has the value 0, which voxels would get where the mask is 0",
           "leave out --mask, or store the labels as they are");
  });
  return std::make_unique<MaskedVolume>(std::move(volume), std::move(mask));
}

std::unique_ptr<VolumeReader> open_mask(const std::filesystem::path& file,
                                        const VolumeOptions& options, const VolumeInfo& volume) {
  VolumeOptions of_all;
  of_all.spacing_mm = options.spacing_mm;
  of_all.allow_gaps = options.allow_gaps;
  // The options are those of the volume: none tells what is in a mask.
  of_all.frame = 0;
  of_all.channel = 0;
  auto mask = open_volume(file, of_all);
  if (mask->info().frames > 1)
    fail(file, "the mask holds " + std::to_string(mask->info().frames) + " volumes",
         "store the one to take in a file of its own");
  if (mask->info().channels > 1)
    fail(file, "the mask holds " + std::to_string(mask->info().channels) + " channels",
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
