#include "filters.hpp"

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

class ComponentVolume final : public VolumeFilter {
 public:
  ComponentVolume(std::unique_ptr<VolumeReader> all, VolumeInfo info, std::uint32_t first,
                  std::uint32_t count)
      : VolumeFilter(std::move(all)),
        first_(first),
        count_(count),
        slice_(volume().info().slice_bytes()) {
    own_info() = std::move(info);
  }

  void read_slice(void* samples) override {
    volume().read_slice(slice_.data());
    with_sample_type(info().type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* from = reinterpret_cast<const Sample*>(slice_.data()) + first_;
      auto* to = static_cast<Sample*>(samples);
      for (std::size_t left = info().slice_bytes() / sizeof(Sample); left > 0;
           --left, from += count_)
        *to++ = *from;
    });
  }

 private:
  std::uint32_t first_, count_;
  std::vector<std::uint8_t> slice_;
};

}  // namespace

std::unique_ptr<VolumeReader> component(std::unique_ptr<VolumeReader> all, VolumeInfo info,
                                        std::uint32_t first, std::uint32_t count) {
  return std::make_unique<ComponentVolume>(std::move(all), std::move(info), first, count);
}

VolumeInfo of_all_components(const std::string& file, VolumeInfo info, std::uint64_t count,
                             const std::string& remedy) {
  constexpr std::uint64_t max_number = std::numeric_limits<std::uint32_t>::max();
  if (count > max_number / info.dims[0])
    fail(file, std::to_string(count) + " samples per voxel make the rows too long", remedy);
  info.dims[0] *= static_cast<std::uint32_t>(count);
  info.channels = 1;
  return info;
}

std::unique_ptr<VolumeReader> channel_of(
    const std::string& file, VolumeInfo info, std::optional<std::uint32_t> channel,
    const std::function<std::unique_ptr<VolumeReader>(VolumeInfo all)>& open) {
  if (info.channels == 1) return open(std::move(info));
  const std::uint64_t count = info.channels;
  auto all = open(of_all_components(file, info, count));
  info.notes = all->info().notes;
  return component(std::move(all), std::move(info), channel.value_or(0),
                   static_cast<std::uint32_t>(count));
}

}  // namespace discmc::command
