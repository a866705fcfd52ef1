// Encodes a scan as slices, and counts the work of each row.
#pragma once

#include <algorithm>
#include <discmc/fraction_slice_encoder.hpp>
#include <stdexcept>
#include <vector>

#include "oracle/slice_config.hpp"
#include "oracle/volume.hpp"
#include "proofs/work/bound.hpp"
#include "proofs/work/counted_scan.hpp"

namespace discmc::work {

struct SliceWork {
  uint64_t max_blocks = 0;  ///< blocks of a push
  double max_of_bound = 0;  ///< maximum of work divided by bound
};

/// Encodes a volume row by row, as several identical surfaces. levels: 0 for a SliceEncoder.
/// Errors: throws on any error of the encoder.
template <class AnyEncoder>
SliceWork encode_slices(const reference::BitVolume& volume, uint32_t key_slice_interval,
                        uint8_t surfaces, uint8_t levels) {
  StreamHeader header{volume.width, volume.height, volume.depth, {}, {1}, Border::closed};
  header.surface_count = surfaces;
  std::fill_n(header.thresholds + 1, surfaces - 1, 1);
  SliceEncoderConfig config = test::slice_config(header, key_slice_interval);
  config.levels = levels;
  std::vector<uint8_t> memory(AnyEncoder::minimum_bytes(config));
  AnyEncoder encoder;
  const ByteOutput nowhere{nullptr, [](void*, const uint8_t*, size_t count) { return count; }};
  if (encoder.start(config, {memory.data(), memory.size()}, nowhere) != Status::ok)
    throw std::runtime_error("slices do not start");
  const uint64_t bound = slice_row_bound(volume.width, surfaces, levels != 0);
  SliceWork work;
  for (size_t voxel = 0; voxel < volume.voxels(); voxel += volume.width) {
    const uint64_t before = blocks;
    const Status status = encoder.push(volume.on.data() + voxel, volume.width).status;
    work.max_blocks = std::max(work.max_blocks, blocks - before);
    if (status != Status::ok) throw std::runtime_error(to_string(status));
  }
  work.max_of_bound = static_cast<double>(work.max_blocks) / static_cast<double>(bound);
  return work;
}

}  // namespace discmc::work
