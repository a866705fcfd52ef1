// The firmware of scanner.cpp with a stream of slices with fractions in place of polygons: the
// receiver makes the interpolated surface. Rows arrive by interrupt, the stream leaves by the UART.
//
// ports/boards/README.md shows how to build it. SCANNER_LEVELS is the number of levels, 2 or 4.
#include <board.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/front/row_ring.hpp>
#include <scan.hpp>

using namespace discmc;

namespace {

using Slices = FractionSliceEncoder<scan::Sample>;

constexpr uint32_t rows_held = 2;
constexpr uint32_t row_bytes = scan::limits.width * sizeof(scan::Sample);
uint8_t row_memory[RowRing::bytes_for(row_bytes, rows_held)];
RowRing ring;
bool broken_off = false;  // valid once the ring has ended

constexpr uint32_t key_slices = 16;  // a page that opens later begins at the next one
constexpr SliceEncoderConfig config{
    scan::limits,
    {scan::threshold},
    key_slices,
    1,
    {scan::depth, {scan::spacing_nm[0], scan::spacing_nm[1], scan::spacing_nm[2]}},
    SCANNER_LEVELS};
uint8_t memory[Slices::minimum_bytes(config)];
Slices slices;

// Completes a call to the library. While the UART is busy, rows that arrive go to the ring.
bool succeeds(Status status) {
  while (status == Status::suspended) {
    board::wait();
    status = slices.resume();
  }
  return status == Status::ok;
}

// A frame that a reset has cut off ends first.
bool start() {
  constexpr uint8_t frame_end = 0;
  while (board::uart_write(nullptr, &frame_end, 1) == 0) board::wait();
  return succeeds(slices.start(config, memory_of(memory), {nullptr, board::uart_write}));
}

bool scan_row() {
  const auto* const samples = static_cast<const scan::Sample*>(ring.row());
  const Status status = slices.push(samples, scan::limits.width).status;
  ring.pop();  // before waiting for the UART: the next row needs the room
  board::row_is_free();
  return succeeds(status);
}

// Replaces a lost row.
bool skip_row() {
  ring.pop();
  return succeeds(slices.skip_row(Substitute::previous_row).status);
}

bool scan_all_rows() {
  for (;;) switch (ring.peek()) {
      case RowRing::Next::ready:
        if (!scan_row()) return false;
        break;
      case RowRing::Next::lost:
        if (!skip_row()) return false;
        break;
      case RowRing::Next::none:
        board::wait();
        break;
      case RowRing::Next::end:
        return true;
    }
}

bool end() {
  const bool is_whole = !broken_off && slices.rows() == 0;
  return succeeds(is_whole ? slices.finish() : slices.abandon()) && is_whole;
}

}  // namespace

void* rows::free_row() {
  return ring.free_row();
}

void rows::row_is_full(uint32_t number) {
  ring.drop(number - ring.produced());
  ring.commit();
}

void rows::end_of_scan(uint32_t count, bool was_broken_off) {
  ring.drop(count - ring.produced());
  broken_off = was_broken_off;
  ring.end();
}

int main() {
  const bool has_room = ring.start(row_bytes, rows_held, memory_of(row_memory)) == Status::ok;
  board::start();
  const bool succeeded = has_room && start() && scan_all_rows() && end();
  board::report("memory_bytes", sizeof memory);
  board::report("slices", slices.slices());
  board::report("stream_bytes", static_cast<uint32_t>(slices.bytes()));
  board::stop(succeeded);
}
