#include "component_volume.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace discmc::command {
namespace {

class ComponentVolume final : public VolumeReader {
 public:
  ComponentVolume(std::unique_ptr<VolumeReader> all, VolumeInfo info, std::uint32_t first,
                  std::uint32_t count)
      : all_(std::move(all)),
        info_(std::move(info)),
        first_(first),
        count_(count),
        slice_(all_->info().slice_bytes()) {}

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    all_->read_slice(slice_.data());
    with_sample_type(info_.type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* from = reinterpret_cast<const Sample*>(slice_.data()) + first_;
      auto* to = static_cast<Sample*>(samples);
      for (std::size_t left = info_.slice_bytes() / sizeof(Sample); left > 0; --left, from += count_)
        *to++ = *from;
    });
  }

  void skip_slice() override { all_->skip_slice(); }

 private:
  std::unique_ptr<VolumeReader> all_;
  VolumeInfo info_;
  std::uint32_t first_, count_;
  std::vector<std::uint8_t> slice_;
};

}  // namespace

std::unique_ptr<VolumeReader> component(std::unique_ptr<VolumeReader> all, VolumeInfo info,
                                        std::uint32_t first, std::uint32_t count) {
  return std::make_unique<ComponentVolume>(std::move(all), std::move(info), first, count);
}

}  // namespace discmc::command
