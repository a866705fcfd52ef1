#include "volumes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace discmc::bench {

namespace {

std::string extents(uint32_t extent) {
  return " " + std::to_string(extent) + "^3";
}

// A cube whose samples are sample(x, y, z).
template <class Function>
Volume cube(const char* name, uint32_t extent, int32_t threshold, Function sample) {
  std::vector<uint8_t> samples;
  samples.reserve(size_t{extent} * extent * extent);
  for (uint32_t z = 0; z < extent; ++z)
    for (uint32_t y = 0; y < extent; ++y)
      for (uint32_t x = 0; x < extent; ++x) samples.push_back(sample(x, y, z));
  return {name + extents(extent), extent, extent, extent, threshold, std::move(samples)};
}

uint8_t clamped(double sample) {
  return static_cast<uint8_t>(std::clamp(sample, 0.0, 255.0));
}

// Replaces each sample by the sum of the five samples around it along one axis. The volume is
// periodic. distance: between neighbours along the axis. Units: samples.
void add_neighbours(std::vector<uint16_t>& samples, size_t distance, size_t extent) {
  const std::vector<uint16_t> old = samples;
  for (size_t i = 0; i < samples.size(); ++i) {
    const size_t along = i / distance % extent;
    const size_t first = i - along * distance;
    unsigned sum = 0;
    for (size_t step = 0; step < 5; ++step)
      sum += old[first + (along + extent + step - 2) % extent * distance];
    samples[i] = static_cast<uint16_t>(sum);
  }
}

}  // namespace

Volume ball(uint32_t extent) {
  const double centre = (extent - 1) / 2.0;
  const double radius = extent * 120 / 256.0;
  return cube("ball", extent, 128, [=](uint32_t x, uint32_t y, uint32_t z) {
    return clamped(128 + 16 * (radius - std::hypot(x - centre, y - centre, z - centre)));
  });
}

Volume noisy_ball(uint32_t extent) {
  Volume volume = ball(extent);
  volume.name = "noisy " + volume.name;
  std::mt19937 random;
  for (uint8_t& sample : std::get<std::vector<uint8_t>>(volume.samples))
    sample = clamped(sample + static_cast<int>(random() % 21) - 10);
  return volume;
}

Volume gyroid(uint32_t extent) {
  constexpr double turn = 2 * 3.14159265358979 / 32;
  return cube("gyroid", extent, 128, [](uint32_t x, uint32_t y, uint32_t z) {
    const double sum = std::sin(turn * x) * std::cos(turn * y) +
                       std::sin(turn * y) * std::cos(turn * z) +
                       std::sin(turn * z) * std::cos(turn * x);
    return clamped(128 + 80 * sum);
  });
}

Volume smooth_noise(uint32_t extent) {
  const size_t row = extent, slice = row * row;
  std::mt19937 random;  // equal numbers from every standard library
  std::vector<uint16_t> samples(slice * extent);
  for (uint16_t& sample : samples) sample = static_cast<uint16_t>(random() & 0xFF);
  for (const size_t distance : {size_t{1}, row, slice}) add_neighbours(samples, distance, extent);
  constexpr int32_t threshold = 5 * 5 * 5 * 255 / 2;
  return {"smooth noise" + extents(extent), extent, extent, extent, threshold, std::move(samples)};
}

Volume checkerboard(uint32_t extent) {
  return cube("checkerboard", extent, 128, [](uint32_t x, uint32_t y, uint32_t z) {
    return static_cast<uint8_t>((x + y + z) % 2 == 0 ? 255 : 0);
  });
}

std::vector<uint8_t> voxels_on(const Volume& volume) {
  std::vector<uint8_t> on;
  on.reserve(volume.voxels());
  std::visit(
      [&](const auto& samples) {
        for (const int32_t sample : samples) on.push_back(sample >= volume.threshold ? 1 : 0);
      },
      volume.samples);
  return on;
}

uint64_t active_cells(const Volume& volume) {
  const std::vector<uint8_t> on = voxels_on(volume);
  const size_t row = volume.width, slice = row * volume.height;
  uint64_t active = 0;
  for (size_t z = 0; z + 1 < volume.depth; ++z)
    for (size_t y = 0; y + 1 < volume.height; ++y)
      for (size_t x = 0; x + 1 < volume.width; ++x) {
        const uint8_t* const cell = on.data() + z * slice + y * row + x;
        int sum = 0;
        for (const size_t corner : {size_t{0}, row, slice, slice + row})
          sum += cell[corner] + cell[corner + 1];
        if (sum % 8 != 0) ++active;
      }
  return active;
}

}  // namespace discmc::bench
