// volume FILE: writes a volume for a board, of the size in the board's scan.hpp.
//
// The volume is a body with a winding tunnel, and some slices of noise in its middle. The smooth
// surface is sent as whole regions. In the noise, little memory causes loose fragments.
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <vector>

#include <scan.hpp>

namespace {

constexpr std::int64_t width = scan::limits.width, height = scan::limits.height;
constexpr std::int64_t depth = scan::depth;

constexpr bool is_noisy(std::int64_t z) {
  return z > depth * 2 / 5 && z < depth / 2;
}

// One voxel in 32, by Knuth's multiplicative hash of its number.
constexpr bool is_speck(std::int64_t number) {
  return static_cast<std::uint32_t>(number) * std::uint32_t{2654435769} >> 27 == 0;
}

constexpr std::int64_t square(std::int64_t value) {
  return value * value;
}

// u, v and w range from -1000 to 1000 across the volume.
constexpr bool is_on(std::int64_t x, std::int64_t y, std::int64_t z) {
  const std::int64_t u = 2000 * x / width - 1000;
  const std::int64_t v = 2000 * y / height - 1000;
  const std::int64_t w = 2000 * z / depth - 1000;
  const bool is_in_body = square(u) + square(v) + square(w) / 2 < square(900);
  const bool is_in_tunnel = square(u - w / 2) + square(v + w / 3) < square(250);
  return is_in_body && !is_in_tunnel;
}

// At the threshold, slightly above it, or slightly below it.
constexpr scan::Sample sample_at(std::int64_t x, std::int64_t y, std::int64_t z) {
  const bool on = is_on(x, y, z) != (is_noisy(z) && is_speck((z * height + y) * width + x));
  const std::int64_t step = (x + y + z) % 3;
  return static_cast<scan::Sample>(on ? scan::threshold + step : scan::threshold - 1 - step);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: volume FILE\n", stderr);
    return 2;
  }
  std::vector<scan::Sample> samples;
  samples.reserve(static_cast<std::size_t>(width * height * depth));
  for (std::int64_t z = 0; z < depth; ++z)
    for (std::int64_t y = 0; y < height; ++y)
      for (std::int64_t x = 0; x < width; ++x) samples.push_back(sample_at(x, y, z));
  std::ofstream file(arguments[1], std::ios::binary);
  file.write(reinterpret_cast<const char*>(samples.data()),
             static_cast<std::streamsize>(samples.size() * sizeof(scan::Sample)));
  file.close();
  if (!file) {
    std::fprintf(stderr, "cannot write %s\n", arguments[1]);
    return 1;
  }
}
