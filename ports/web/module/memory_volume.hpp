// A volume with all samples in memory, for a page.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "volumes/volume_info.hpp"

namespace discmc::web {

class MemoryVolume {
 public:
  explicit MemoryVolume(command::VolumeInfo info)
      : info_(std::move(info)), samples_(info_.slice_bytes() * info_.dims[2]) {}

  const command::VolumeInfo& info() const { return info_; }
  /// Slice after slice, rows of x from y = 0, in native byte order.
  std::uint8_t* samples() { return samples_.data(); }
  const std::uint8_t* slice(std::uint32_t z) const {
    return samples_.data() + info_.slice_bytes() * z;
  }

 private:
  command::VolumeInfo info_;
  std::vector<std::uint8_t> samples_;
};

/// One pass over the volume. Owner: the caller, of the volume.
class MemoryReader final : public command::VolumeReader {
 public:
  explicit MemoryReader(const MemoryVolume& volume) : volume_(volume) {}

  const command::VolumeInfo& info() const override { return volume_.info(); }
  /// Limit: at most one call per slice.
  void read_slice(void* samples) override {
    std::memcpy(samples, volume_.slice(next_++), info().slice_bytes());
  }

 private:
  const MemoryVolume& volume_;
  std::uint32_t next_ = 0;
};

}  // namespace discmc::web
