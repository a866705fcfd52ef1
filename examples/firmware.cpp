// A scanner's firmware, complete: rows of samples in, the merged surface out of a UART.
#include <stdio.h>
#include <discmc/discmc.hpp>

using namespace discmc;
constexpr int32_t size = 48;  // voxels per row, rows per slice, slices
constexpr int32_t threshold = 192;
constexpr Limits limits{size, size};
// RAM without the stack: 7.8 KiB. A smaller arena, from 1.5 KiB on, makes the stream longer.
static uint8_t memory[Extractor16::minimum_bytes(limits) + 5 * 1024];
static Extractor16 extractor;
static Encoder encoder;

// Replace by your driver: this one accepts up to 16 bytes, and is busy at every other call.
static size_t uart_write(void*, const uint8_t* bytes, size_t count) {
  static unsigned calls = 0;
  return ++calls % 2 == 0 ? fwrite(bytes, 1, count < 16 ? count : 16, stdout) : 0;
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) {  // of a ball, densest in its middle
  const Vertex v{2 * x - size + 1, 2 * y - size + 1, 2 * z - size + 1};
  return static_cast<uint8_t>(255 - 85 * dot_product(v, v) / ((size - 1) * (size - 1)));
}

static bool succeeds(Status status) {
  while (status == Status::suspended) status = extractor.resume();  // the UART is busy: sleep here
  if (status != Status::ok) fputs(to_string(status), stderr);
  return status == Status::ok;
}

int main() {
  bool good = succeeds(encoder.start({size /* slices */}, {nullptr, uart_write})) &&
              succeeds(extractor.start(limits, threshold, memory_of(memory), make_sink(encoder)));
  for (int32_t i = 0; good && i < size * size; ++i) {
    uint8_t row[size];
    for (int32_t x = 0; x < size; ++x) row[x] = sample_at(x, i % size, i / size);
    good = succeeds(extractor.push(row, size).status);
  }
  return good && succeeds(extractor.finish()) ? 0 : 1;
}
