// Encodes samples of 8 bits from standard input as a stream of slices with fractions, for
// compare.py. The arguments: width, height, border (0 closed, 1 open), levels, the slices from one
// key slice to the next, thresholds.
#include <discmc/fraction_slice_encoder.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

uint32_t number(const char* text) {
  return static_cast<uint32_t>(std::strtoul(text, nullptr, 10));
}

size_t write(void*, const uint8_t* bytes, size_t count) {
  return std::fwrite(bytes, 1, count, stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 7) return 2;
  discmc::SliceEncoderConfig config{};
  config.limits = {number(argv[1]), number(argv[2]),
                   number(argv[3]) != 0 ? discmc::Border::open : discmc::Border::closed};
  config.levels = static_cast<uint8_t>(number(argv[4]));
  config.key_slice_interval = number(argv[5]);
  config.surface_count = static_cast<uint8_t>(argc - 6);
  for (int i = 6; i < argc; ++i) config.thresholds[i - 6] = static_cast<int32_t>(number(argv[i]));

  using Encoder = discmc::FractionSliceEncoder<uint8_t>;
  std::vector<uint8_t> memory(Encoder::minimum_bytes(config));
  std::vector<uint8_t> row(config.limits.width);
  discmc::ByteOutput output{};
  output.write = write;
  Encoder encoder;
  if (encoder.start(config, {memory.data(), memory.size()}, output) != discmc::Status::ok) return 1;
  while (std::fread(row.data(), 1, row.size(), stdin) == row.size())
    if (encoder.push(row.data(), config.limits.width).status != discmc::Status::ok) return 1;
  return encoder.finish() == discmc::Status::ok ? 0 : 1;
}
