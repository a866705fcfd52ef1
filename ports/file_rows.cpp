// Rows from the file volume.raw, read by the debugger: as fast as they are wanted, as if a DMA
// controller brought them. The samples are in the machine's own byte order, little-endian.
#include <scan.hpp>

#include "board.hpp"
#include "port.hpp"
#include "semihosting.hpp"

namespace {

constexpr size_t row_bytes = scan::limits.width * sizeof(scan::Sample);

intptr_t file;
uint32_t next_row = 0;
bool ended = false;

}  // namespace

void source::start() {
  file = semihosting::open_to_read("volume.raw");
  cpu::request_rows();
}

void board::half_is_free() {
  cpu::request_rows();
}

void source::on_request() {
  while (!ended) {
    void* half = rows::free_half();
    if (half == nullptr) return;
    const size_t bytes = file < 0 ? 0 : semihosting::read(file, half, row_bytes);
    if (bytes == row_bytes) {
      rows::half_is_full(next_row++);
    } else {
      ended = true;
      rows::end_of_scan(next_row, file < 0 || bytes > 0);  // a part of a row is no row
    }
  }
}

void source::on_interrupt() {}
