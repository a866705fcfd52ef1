// Writes a volume of any size to standard output, as u8 samples. The volume is a ball full of
// tunnels (a gyroid) with noise, like a foam in a micro-CT. scripts/tools/bench-large uses it.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

constexpr float period = 85.3F;  // period of the tunnels, in voxels: 6 of them along 512
constexpr float solid = 120, contrast = 40, outside = 80;
constexpr float ball = 0.9F;  // radius of the ball; 1 is half the extent

// The terms of the samples that depend on one coordinate.
struct Wave {
  explicit Wave(std::uint32_t extent) {
    for (std::uint32_t i = 0; i < extent; ++i) {
      const float angle = 6.2831853F * static_cast<float>(i) / period;
      sine.push_back(std::sin(angle));
      cosine.push_back(std::cos(angle));
      const float place = 2 * static_cast<float>(i) / static_cast<float>(extent) - 1;
      square.push_back(place * place);
    }
  }
  std::vector<float> sine, cosine, square;
};

// The sum of four numbers of -8 to 7, nearly normal with sigma 9.2, divided by four.
class Noise {
 public:
  float next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const auto bits = static_cast<std::uint32_t>(state_ >> 40);
    const std::uint32_t sum = (bits & 15) + (bits >> 4 & 15) + (bits >> 8 & 15) + (bits >> 12 & 15);
    return (static_cast<float>(sum) - 30) / 4;
  }

 private:
  std::uint64_t state_ = 1;
};

bool write_volume(const Wave& x, const Wave& y, const Wave& z) {
  Noise noise;
  std::vector<std::uint8_t> row(x.sine.size());
  for (std::size_t k = 0; k < z.sine.size(); ++k)
    for (std::size_t j = 0; j < y.sine.size(); ++j) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        const float wave =
            x.sine[i] * y.cosine[j] + y.sine[j] * z.cosine[k] + z.sine[k] * x.cosine[i];
        const bool is_outside = x.square[i] + y.square[j] + z.square[k] > ball * ball;
        const float sample = solid + contrast * wave - (is_outside ? outside : 0) + noise.next();
        row[i] = static_cast<std::uint8_t>(sample < 0 ? 0 : sample > 255 ? 255 : sample);
      }
      if (std::fwrite(row.data(), 1, row.size(), stdout) != row.size()) return false;
    }
  return std::fflush(stdout) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<Wave> waves;
  for (int i = 1; i < argc; ++i) {
    const long extent = std::strtol(argv[i], nullptr, 10);
    if (extent > 0 && extent <= 65536) waves.emplace_back(static_cast<std::uint32_t>(extent));
  }
  if (argc != 4 || waves.size() != 3) {
    std::fputs("usage: bench_gyroid WIDTH HEIGHT DEPTH > FILE.raw\n", stderr);
    return 2;
  }
  return write_volume(waves[0], waves[1], waves[2]) ? 0 : 1;
}
