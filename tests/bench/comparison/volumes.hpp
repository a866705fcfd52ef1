// The volumes of the benchmark: generated ones, and those of a folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace discmc::bench {

/// x runs fastest, then y, then z.
using Samples = std::variant<std::vector<uint8_t>, std::vector<uint16_t>, std::vector<int16_t>>;

/// A volume in memory and the threshold of its surface. A voxel is on if its sample is >= the
/// threshold.
struct Volume {
  std::string name;
  uint32_t width, height, depth;
  int32_t threshold;
  Samples samples;

  size_t voxels() const { return size_t{width} * height * depth; }
};

/// A ball with smooth samples around its surface; its radius is 120 in 256 voxels.
Volume ball(uint32_t extent);

/// The same with noise of up to 10 in each sample.
Volume noisy_ball(uint32_t extent);

/// Triply periodic, smooth, and curved everywhere, with periods of 32 voxels.
Volume gyroid(uint32_t extent);

/// Random samples, each the sum of the 5x5x5 samples around it: bumps and holes of the smallest
/// scale in scans. Only integers, so it is equal on every machine.
Volume smooth_noise(uint32_t extent);

/// A checkerboard: the maximum number of active cells, and nothing to merge.
Volume checkerboard(uint32_t extent);

/// No voxel is on. Sample: uint8_t or uint16_t.
template <class Sample>
Volume empty(uint32_t extent) {
  const std::string name =
      "empty " + std::to_string(extent) + "^3, " + std::to_string(8 * sizeof(Sample)) + " bits";
  return {name, extent, extent, extent, 128, std::vector<Sample>(size_t{extent} * extent * extent)};
}

/// 1 for an on voxel, else 0.
std::vector<uint8_t> voxels_on(const Volume& volume);

/// Cells with on and off voxels at their corners.
uint64_t active_cells(const Volume& volume);

/// The volume of a file, named after it, with a threshold of 0. Throws command::VolumeError if it
/// cannot be read.
Volume read_volume(const std::filesystem::path& file);

/// Every volume of a folder with a JSON file, {"file": "head.nrrd", "iso": [500]}, at each of its
/// thresholds. Throws command::VolumeError if one cannot be read.
std::vector<Volume> volumes_in(const std::filesystem::path& folder);

}  // namespace discmc::bench
