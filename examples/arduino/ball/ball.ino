// Sends the surface of a ball over the serial port. On the PC, with the command of discmc:
//   stty -F /dev/ttyACM0 raw -echo 115200
//   discmc decode /dev/ttyACM0 -o ball.stl
#include <discmc.hpp>

using namespace discmc;
constexpr int32_t size = 48;  // voxels per row, rows per slice, slices
constexpr int32_t threshold = 192;
constexpr Limits limits{size, size};

// RAM without the stack: 7.8 KiB.
static uint8_t memory[Extractor16::minimum_bytes(limits) + 5 * 1024];
static Extractor16 extractor;
static Encoder encoder;

size_t write_to_serial(void*, const uint8_t* bytes, size_t count) {
  return Serial.write(bytes, count);  // waits for room
}

uint8_t sample_at(int32_t x, int32_t y, int32_t z) {  // replace by your sensor
  const Vertex v{2 * x - size + 1, 2 * y - size + 1, 2 * z - size + 1};
  return static_cast<uint8_t>(255 - 85 * dot_product(v, v) / ((size - 1) * (size - 1)));
}

bool scan() {
  bool good = encoder.start({size}, {nullptr, write_to_serial}) == Status::ok &&
              extractor.start(limits, threshold, memory_of(memory), make_sink(encoder)) == Status::ok;
  for (int32_t i = 0; good && i < size * size; ++i) {
    uint8_t row[size];
    for (int32_t x = 0; x < size; ++x) row[x] = sample_at(x, i % size, i / size);
    good = extractor.push(row, size).status == Status::ok;
  }
  return good && extractor.finish() == Status::ok;
}

void setup() {
  Serial.begin(115200);
  while (!Serial) {  // until the PC opens the port
  }
  pinMode(LED_BUILTIN, OUTPUT);
  digitalWrite(LED_BUILTIN, scan() ? HIGH : LOW);
}

void loop() {}
