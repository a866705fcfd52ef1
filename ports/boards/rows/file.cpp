// Rows from the file volume.raw, read by the debugger as fast as they are requested, like rows of a
// DMA controller. They have the size and type of scan.hpp, x first, little-endian. Slices beyond
// those of scan.hpp are not read.
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
  if (file < 0) semihosting::print("there is no volume.raw\n");
  cpu::request_rows();
}

void board::row_is_free() {
  cpu::request_rows();
}

void source::on_request() {
  constexpr uint32_t all_rows = scan::limits.height * scan::depth;
  while (!ended) {
    void* row = rows::free_row();
    if (row == nullptr) return;
    const bool is_wanted = file >= 0 && next_row < all_rows;
    const size_t bytes = is_wanted ? semihosting::read(file, row, row_bytes) : 0;
    if (bytes == row_bytes) {
      rows::row_is_full(next_row++);
    } else {
      ended = true;
      rows::end_of_scan(next_row, file < 0 || bytes > 0);  // an incomplete row is ignored
    }
  }
}

void source::on_interrupt() {}
