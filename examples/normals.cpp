// A scanner that makes normals: firmware.cpp once more, with the gradient of the samples in its
// stream, for smooth shading.
#include <stdio.h>
#include <discmc/discmc.hpp>

using namespace discmc;

constexpr int32_t size = 48;  // voxels per row, rows per slice, slices
constexpr int32_t threshold = 192;
constexpr Limits limits{size, size};
constexpr int32_t spacing_nm[] = {500000, 500000, 1000000};

using NormalScan = NormalExtractor16<uint8_t>;  // of the samples' type
static uint8_t memory[NormalScan::minimum_bytes(limits) + 8 * 1024];
static NormalScan extractor;
static Encoder encoder;

static Status begin(const ByteOutput& output) {
  extractor.set_spacing(spacing_nm);
  encoder.encode_normals();
  const Status status = encoder.start({size}, output);
  if (status != Status::ok) return status;
  return extractor.start(limits, threshold, memory_of(memory), make_sink(encoder));
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) {  // of a ball, densest in its middle
  const Vertex v{2 * x - size + 1, 2 * y - size + 1, 4 * z - 2 * size + 2};
  const int32_t fall = dot_product(v, v) / 26;
  return static_cast<uint8_t>(fall < 255 ? 255 - fall : 0);
}

// The output accepts everything: no call is suspended.
static size_t write_all(void*, const uint8_t* bytes, size_t count) {
  return fwrite(bytes, 1, count, stdout);
}

int main() {
  bool good = begin({nullptr, write_all}) == Status::ok;
  for (int32_t i = 0; good && i < size * size; ++i) {
    uint8_t row[size];
    for (int32_t x = 0; x < size; ++x) row[x] = sample_at(x, i % size, i / size);
    good = extractor.push(row, size).status == Status::ok;
  }
  return good && extractor.finish() == Status::ok ? 0 : 1;
}
