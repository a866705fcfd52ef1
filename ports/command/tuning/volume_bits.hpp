// A thresholded volume in memory: read once, scanned as often as needed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

#include "extraction/extraction.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Memory: an eighth of a byte per voxel.
class VolumeBits {
 public:
  /// Reads the volume to its end. options: the selection, the border, the filter, the mask and the
  /// progress count. Throws like extract().
  VolumeBits(VolumeReader& volume, const ExtractionOptions& options);

  const Limits& limits() const { return limits_; }
  std::uint32_t slices() const { return header_.depth; }
  /// Returns the header of a stream of this volume.
  const StreamHeader& header() const { return header_; }
  /// Returns the size of a sample on the device: 1 or 2. Units: bytes.
  std::uint32_t sample_bytes() const { return sample_bytes_; }
  /// Whether the file's samples are floating point, which no device has.
  bool is_floating() const { return is_floating_; }
  /// Returns the number of voxels that are on in the first `slices` slices.
  std::uint64_t on(std::uint32_t slices) const { return on_[slices]; }
  bool is_full() const { return is_full_; }

  /// Returns a row in the form of Extractor::push_bits(). Rows are counted over all slices.
  const std::uint8_t* row(std::size_t number) const { return bits_.data() + number * row_bytes_; }

 private:
  Limits limits_;
  StreamHeader header_;
  std::uint32_t sample_bytes_;
  bool is_floating_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> bits_;
  std::vector<std::uint64_t> on_{0};
  bool is_full_ = false;
};

}  // namespace discmc::command
