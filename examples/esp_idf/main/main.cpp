// Sends the surface of a ball over UART 0. On the PC, with the command of discmc:
//   stty -F /dev/ttyUSB0 raw -echo 115200
//   discmc decode /dev/ttyUSB0 -o ball.stl
#include <driver/uart.h>
#include <discmc/discmc.hpp>

using namespace discmc;
constexpr int32_t size = 48;  // voxels per row, rows per slice, slices
constexpr int32_t threshold = 192;
constexpr Limits limits{size, size};

// RAM without the stack: 7.8 KiB.
static uint8_t memory[Extractor16::minimum_bytes(limits) + 5 * 1024];
static Extractor16 extractor;
static Encoder encoder;

static size_t write_to_uart(void*, const uint8_t* bytes, size_t count) {
  const int written = uart_write_bytes(UART_NUM_0, bytes, count);  // waits for room
  return written < 0 ? 0 : static_cast<size_t>(written);
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) {  // replace by your sensor
  const Vertex v{2 * x - size + 1, 2 * y - size + 1, 2 * z - size + 1};
  return static_cast<uint8_t>(255 - 85 * dot_product(v, v) / ((size - 1) * (size - 1)));
}

// It is silent but for the stream: sdkconfig.defaults turns log and boot messages off.
extern "C" void app_main() {
  bool good =
      uart_driver_install(UART_NUM_0, 256, 0, 0, nullptr, 0) == ESP_OK &&
      encoder.start({size}, {nullptr, write_to_uart}) == Status::ok &&
      extractor.start(limits, threshold, memory_of(memory), make_sink(encoder)) == Status::ok;
  for (int32_t i = 0; good && i < size * size; ++i) {
    uint8_t row[size];
    for (int32_t x = 0; x < size; ++x) row[x] = sample_at(x, i % size, i / size);
    good = extractor.push(row, size).status == Status::ok;
  }
  if (good) good = extractor.finish() == Status::ok;
}
