#include "narrowed_volume.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "selection.hpp"

namespace discmc::meshing {
namespace {

class NarrowedVolume final : public SliceReader {
 public:
  NarrowedVolume(std::unique_ptr<SliceReader> volume, const SampleBounds& bounds, double iso)
      : volume_(std::move(volume)), info_(volume_->info()), slice_(info_.slice_bytes()) {
    with_sample_type(info_.type, [&](auto type) {
      using Sample = decltype(type);
      const Sample low = selected_samples<Sample>(info_, {iso}).low;
      const auto zero = static_cast<double>(low);
      const double max_deviation = std::max(bounds.greatest - zero, zero - bounds.least);
      const double scale = max_deviation > 0 ? greatest / max_deviation : 1;
      narrow_ = [low, zero, scale](const void* wide, std::int16_t* narrow, std::size_t count) {
        const auto* sample = static_cast<const Sample*>(wide);
        for (std::size_t i = 0; i < count; ++i)
          narrow[i] = counted(static_cast<double>(sample[i]), sample[i] >= low, zero, scale);
      };
    });
    info_.type = SampleType::i16;
    info_.slope = 1;
    info_.intercept = 0;
  }

  const SampleGrid& info() const override { return info_; }
  void read_slice(void* samples) override {
    volume_->read_slice(slice_.data());
    narrow_(slice_.data(), static_cast<std::int16_t*>(samples),
            std::size_t{info_.dims[0]} * info_.dims[1]);
  }

 private:
  static constexpr double greatest = std::numeric_limits<std::int16_t>::max();

  static std::int16_t counted(double sample, bool is_on, double zero, double scale) {
    double distance = std::round((sample - zero) * scale);
    if (std::isnan(distance)) distance = 0;  // for NaN, or an infinite level
    return static_cast<std::int16_t>(is_on ? std::clamp(distance, 0.0, greatest)
                                           : std::clamp(distance, -greatest, -1.0));
  }

  std::unique_ptr<SliceReader> volume_;
  SampleGrid info_;
  std::vector<std::uint8_t> slice_;
  std::function<void(const void*, std::int16_t*, std::size_t)> narrow_;
};

}  // namespace

std::unique_ptr<SliceReader> narrowed(std::unique_ptr<SliceReader> volume,
                                      const SampleBounds& bounds, double iso) {
  return std::make_unique<NarrowedVolume>(std::move(volume), bounds, iso);
}

}  // namespace discmc::meshing
