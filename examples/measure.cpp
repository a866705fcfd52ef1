// Firmware that measures the library on your board: cycles per row, voxel and active cell.
//
// It scans a built-in phantom, as regions and as slices, and sends a figure per line by the UART.
// The page docs/porting.md explains the figures and the conditions. Build it as
// ports/boards/README.md builds scanner.cpp. The counter is that of the processor: DWT on
// Cortex-M3, M4, M7 and M33, SysTick on M0 and M0+, mcycle on RISC-V.
#include <board.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/slice_encoder.hpp>

#include "measure_clock.hpp"

using namespace discmc;

namespace {

constexpr Limits limits{48, 48};
constexpr uint32_t depth = 48;
constexpr int32_t threshold = 192;

alignas(4) uint8_t memory[6 * 1024];
Extractor16 extractor;
Encoder encoder;
SliceEncoder slice_encoder;
uint8_t row[limits.width];

// A sample of a ball, densest in its middle; or of nothing.
void make_row(bool is_ball, uint32_t number) {
  const auto size = static_cast<int32_t>(depth);
  const auto y = static_cast<int32_t>(number % limits.height);
  const auto z = static_cast<int32_t>(number / limits.height);
  for (int32_t x = 0; x < size; ++x) {
    const Vertex v{2 * x - size + 1, 2 * y - size + 1, 2 * z - size + 1};
    row[x] = is_ball ? static_cast<uint8_t>(255 - dot_product(v, v) / 26) : 0;
  }
}

size_t accept_all(void*, const uint8_t*, size_t count) {
  return count;
}

// ---- what the UART sends ----

void send(const char* text) {
  for (; *text != '\0'; ++text)
    while (board::uart_write(nullptr, reinterpret_cast<const uint8_t*>(text), 1) == 0)
      board::wait();
}

void send(const char* name, uint32_t value) {
  char digits[11];
  char* text = digits + sizeof digits;
  *--text = '\0';
  do *--text = static_cast<char>('0' + value % 10);
  while ((value /= 10) > 0);
  send(name);
  send(" ");
  send(text);
  send("\n");
}

// ---- scans ----

struct Measured {
  uint32_t all = 0;   // cycles
  uint32_t most = 0;  // of a row
};

// The measured time excludes the making of rows, and includes finish().
template <class Scanner>
bool scan(Scanner& scanner, bool is_ball, Measured& measured) {
  for (uint32_t number = 0; number <= limits.height * depth; ++number) {
    const bool is_last = number == limits.height * depth;
    if (!is_last) make_row(is_ball, number);
    const uint32_t before = measure_clock::now();
    const Status status = is_last ? scanner.finish() : scanner.push(row, limits.width).status;
    const uint32_t taken = measure_clock::since(before);
    if (status != Status::ok) return false;
    measured.all += taken;
    if (taken > measured.most) measured.most = taken;
  }
  return true;
}

bool scan_regions(bool is_ball, Measured& measured) {
  return encoder.start({depth}, {nullptr, accept_all}) == Status::ok &&
         extractor.start(limits, threshold, memory_of(memory), make_sink(encoder)) == Status::ok &&
         scan(extractor, is_ball, measured);
}

bool scan_slices(bool is_ball, Measured& measured) {
  return slice_encoder.start({limits, {threshold}}, memory_of(memory), {nullptr, accept_all}) ==
             Status::ok &&
         scan(slice_encoder, is_ball, measured);
}

}  // namespace

int main() {
  board::start();
  measure_clock::start();
  Measured empty, regions, sliced;
  const bool succeeded =
      scan_regions(false, empty) && scan_regions(true, regions) && scan_slices(true, sliced);
  if (succeeded) {
    constexpr uint32_t rows = limits.height * depth;
    const auto cells = static_cast<uint32_t>(extractor.statistics().cells);
    send("counter_bits", measure_clock::bits);
    send("cycles_per_empty_row", empty.all / rows);
    send("hundredths_per_empty_voxel", empty.all / (rows * limits.width / 100));
    send("cycles_per_active_cell", (regions.all - empty.all) / cells);
    send("cycles_per_row_regions", regions.all / rows);
    send("cycles_longest_row_regions", regions.most);
    send("cycles_per_row_slices", sliced.all / rows);
    send("cycles_longest_row_slices", sliced.most);
    send("end", 0);
  }
  board::stop(succeeded);
}
