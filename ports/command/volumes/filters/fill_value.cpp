#include "filters.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "text/number_text.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

class WithoutFill final : public VolumeFilter {
 public:
  WithoutFill(std::unique_ptr<VolumeReader> volume, double fill)
      : VolumeFilter(std::move(volume)), fill_(fill), slice_(info().slice_bytes()) {
    const bool is_wide = sample_bytes(info().type) > 2 && info().type != SampleType::f32;
    own_info().type = is_wide ? SampleType::f64 : SampleType::f32;
    own_info().slope = 1;
    own_info().intercept = 0;
    add_note("the fill value " + short_number(fill) + " is outside of every surface");
  }

  void read_slice(void* samples) override {
    const VolumeInfo& from = volume().info();
    volume().read_slice(slice_.data());
    with_sample_type(from.type, [&](auto stored) {
      const std::size_t count = slice_.size() / sizeof stored;
      for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&stored, &slice_[i * sizeof stored], sizeof stored);
        const auto sample = static_cast<double>(stored);
        const bool is_fill = !(sample < fill_ || sample > fill_);
        const double value = is_fill ? std::numeric_limits<double>::quiet_NaN()
                                     : from.slope * sample + from.intercept;
        if (info().type == SampleType::f64)
          static_cast<double*>(samples)[i] = value;
        else
          static_cast<float*>(samples)[i] = static_cast<float>(value);
      }
    });
  }

 private:
  double fill_;
  std::vector<std::uint8_t> slice_;
};

}  // namespace

std::unique_ptr<VolumeReader> without_fill(std::unique_ptr<VolumeReader> volume, double fill) {
  if (std::isnan(fill)) return volume;  // NaN is outside in any case
  return std::make_unique<WithoutFill>(std::move(volume), fill);
}

}  // namespace discmc::command
