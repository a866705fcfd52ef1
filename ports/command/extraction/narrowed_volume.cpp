#include "narrowed_volume.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "selection.hpp"
#include "volumes/volume_filter.hpp"

namespace discmc::command {
namespace {

class NarrowedVolume final : public VolumeFilter {
 public:
  NarrowedVolume(std::unique_ptr<VolumeReader> volume, const SampleBounds& bounds, double iso)
      : VolumeFilter(std::move(volume)), slice_(info().slice_bytes()) {
    with_sample_type(info().type, [&](auto type) {
      using Sample = decltype(type);
      const Sample low = selected_samples<Sample>(info(), {iso}).low;
      const auto zero = static_cast<double>(low);
      const double most = std::max(bounds.greatest - zero, zero - bounds.least);
      const double scale = most > 0 ? greatest / most : 1;
      narrow_ = [low, zero, scale](const void* wide, std::int16_t* narrow, std::size_t count) {
        const auto* sample = static_cast<const Sample*>(wide);
        for (std::size_t i = 0; i < count; ++i)
          narrow[i] = counted(static_cast<double>(sample[i]), sample[i] >= low, zero, scale);
      };
    });
    own_info().type = SampleType::i16;
    own_info().slope = 1;
    own_info().intercept = 0;
  }

  void read_slice(void* samples) override {
    volume().read_slice(slice_.data());
    narrow_(slice_.data(), static_cast<std::int16_t*>(samples),
            std::size_t{info().dims[0]} * info().dims[1]);
  }

 private:
  static constexpr double greatest = std::numeric_limits<std::int16_t>::max();

  static std::int16_t counted(double sample, bool is_on, double zero, double scale) {
    const double distance = std::isnan(sample) ? -1 : std::round((sample - zero) * scale);
    return static_cast<std::int16_t>(is_on ? std::clamp(distance, 0.0, greatest)
                                           : std::clamp(distance, -greatest, -1.0));
  }

  std::vector<std::uint8_t> slice_;
  std::function<void(const void*, std::int16_t*, std::size_t)> narrow_;
};

}  // namespace

std::unique_ptr<VolumeReader> narrowed(std::unique_ptr<VolumeReader> volume,
                                       const SampleBounds& bounds, double iso) {
  return std::make_unique<NarrowedVolume>(std::move(volume), bounds, iso);
}

}  // namespace discmc::command
