// A scanner's firmware for any board: rows arrive by interrupt, the surface leaves by the UART.
//
// The interface ports/boards/board.hpp separates it from the board; the board's scan.hpp describes
// the scan. How to build it is in ports/boards/README.md, and how to bring it to a board of your
// own in docs/porting.md.
#include <board.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/front/row_ring.hpp>
#include <scan.hpp>

using namespace discmc;

namespace {

// The interrupt fills rows, the main loop empties them. More of them help with bursts.
constexpr uint32_t rows_held = 2;
constexpr uint32_t row_bytes = scan::limits.width * sizeof(scan::Sample);
uint8_t row_memory[RowRing::bytes_for(row_bytes, rows_held)];
RowRing ring;
bool broken_off = false;  // valid once the ring has ended

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

namespace {

uint8_t arena[scan::arena_bytes];
static_assert(sizeof arena >= Extractor16::minimum_bytes(scan::limits),
              "see arena_bytes in scan.hpp");
// Constant expressions, so that the firmware does not contain the code that computes them.
constexpr Capacities capacities = Extractor16::default_capacities(scan::limits, sizeof arena);
Extractor16 extractor;
Encoder encoder;

// Completes a call to the library. While the UART is busy there is nothing else to do: rows that
// arrive meanwhile go to the ring, by interrupt.
bool succeeds(Status status) {
  while (status == Status::suspended) {
    board::wait();
    status = extractor.resume();
  }
  return status == Status::ok;
}

// Ends a frame that a reset has cut off, so that the receiver reads the header behind it.
void end_frame() {
  constexpr uint8_t frame_end = 0;
  while (board::uart_write(nullptr, &frame_end, 1) == 0) board::wait();
}

bool start() {
  end_frame();
  const int32_t(&spacing)[3] = scan::spacing_nm;
  const StreamLabel label{scan::depth, {spacing[0], spacing[1], spacing[2]}};
  return succeeds(encoder.start(label, {nullptr, board::uart_write})) &&
         succeeds(extractor.start(scan::limits, capacities, scan::threshold, memory_of(arena),
                                  make_sink(encoder)));
}

bool scan_row() {
  const auto* const samples = static_cast<const scan::Sample*>(ring.row());
  const Status status = extractor.push(samples, scan::limits.width).status;
  ring.pop();  // before waiting for the UART: the next row needs the room
  board::row_is_free();
  return succeeds(status);
}

// Replaces a lost row.
bool skip_row() {
  ring.pop();
  return succeeds(extractor.skip_row(Substitute::previous_row).status);
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

// A scan that ends within a slice, or was abandoned, still leaves a closed surface.
bool end() {
  const bool is_whole = !broken_off && extractor.rows() == 0;
  return succeeds(is_whole ? extractor.finish() : extractor.abandon()) && is_whole;
}

void report() {
  const Statistics total = extractor.statistics();
  board::report("arena_used", static_cast<uint32_t>(extractor.bytes_used()));
  board::report("arena_bytes", sizeof arena);
  board::report("slices", extractor.slices());
  board::report("regions", static_cast<uint32_t>(total.regions));
  board::report("fragments", static_cast<uint32_t>(total.fragments));
  board::report("skipped_rows", static_cast<uint32_t>(total.skipped_rows));
  board::report("stream_bytes", static_cast<uint32_t>(encoder.bytes()));
}

}  // namespace

int main() {
  const bool has_room = ring.start(row_bytes, rows_held, memory_of(row_memory)) == Status::ok;
  board::start();
  const bool succeeded = has_room && start() && scan_all_rows() && end();
  report();
  board::stop(succeeded);
}
