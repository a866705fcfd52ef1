// A scanner with start-up code of its own, and without a C library.
#include <discmc/discmc.hpp>

using namespace discmc;

namespace {

constexpr Limits limits{64, 64};
volatile uint32_t& sensor = *reinterpret_cast<uint32_t*>(0x40000000);
volatile uint32_t& uart = *reinterpret_cast<uint32_t*>(0x40000004);

uint8_t memory[Extractor16::minimum_bytes(limits) + 8 * 1024];
Extractor16 extractor;
Encoder encoder;

size_t write(void*, const uint8_t* bytes, size_t count) {
  for (size_t i = 0; i < count; ++i) uart = bytes[i];
  return count;
}

}  // namespace

extern "C" void reset() {
  Status status = encoder.start({64}, {nullptr, write});
  if (status == Status::ok)
    status = extractor.start(limits, 128, memory_of(memory), make_sink(encoder));
  for (int row = 0; status == Status::ok && row < 64 * 64; ++row) {
    uint8_t samples[64];
    for (uint8_t& sample : samples) sample = static_cast<uint8_t>(sensor);
    status = extractor.push(samples, 64).status;
  }
  if (status == Status::ok) status = extractor.finish();
  uart = static_cast<uint32_t>(status);
  for (;;) continue;
}

[[gnu::section(".vectors"), gnu::used]] static void (*const vectors[])() = {
    reinterpret_cast<void (*)()>(0x20010000), reset};
