// All rows of a volume, because a scanner repeats its scan after a reset.
#pragma once

#include <cstdint>
#include <vector>

#include "volumes/volume.hpp"

namespace discmc::simulator {

class Rows {
 public:
  /// Reads the volume to its end. Throws VolumeError.
  explicit Rows(command::VolumeReader& volume);

  const command::VolumeInfo& info() const { return info_; }
  std::uint32_t count() const { return info_.dims[1] * info_.dims[2]; }
  /// Units: bytes per row.
  std::size_t bytes() const { return info_.dims[0] * meshing::sample_bytes(info_.type); }
  const std::uint8_t* row(std::uint32_t number) const { return &samples_[number * bytes()]; }

 private:
  command::VolumeInfo info_;
  std::vector<std::uint8_t> samples_;
};

}  // namespace discmc::simulator
