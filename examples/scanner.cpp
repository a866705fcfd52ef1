// A scanner's firmware on any board: rows come in by interrupt, the surface leaves by the UART.
//
// What differs between boards is behind ports/board.hpp; what is scanned is said in the board's
// scan.hpp. ports/README.md tells how to build it, and how to bring it to a board of your own.
#include <board.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <scan.hpp>

using namespace discmc;

namespace {

struct Row {
  uint32_t number;
  scan::Sample samples[scan::limits.width];
};

// Two halves of a buffer: the interrupt fills them in turn, the main loop empties them in the same
// order. Each side writes a counter of its own and reads the other's, which is all that one
// producer and one consumer need, and loads and stores are all that every processor can do.
Row halves[2];
uint32_t filled = 0;   // written by the interrupt
uint32_t emptied = 0;  // written by the main loop

// The end of the scan, written by the interrupt; the counts are valid once `ended` is set.
bool ended = false;
bool broken_off = false;
uint32_t row_count = 0;

// What was written before a release is seen by whoever acquires what it wrote.
template <class T>
T acquire(const T& variable) {
  return __atomic_load_n(&variable, __ATOMIC_ACQUIRE);
}
template <class T>
void release(T& variable, T value) {
  __atomic_store_n(&variable, value, __ATOMIC_RELEASE);
}

}  // namespace

void* rows::free_half() {
  return filled - acquire(emptied) < 2 ? halves[filled % 2].samples : nullptr;
}

void rows::half_is_full(uint32_t number) {
  halves[filled % 2].number = number;
  release(filled, filled + 1);
}

void rows::end_of_scan(uint32_t count, bool was_broken_off) {
  row_count = count;
  broken_off = was_broken_off;
  release(ended, true);
}

namespace {

uint8_t arena[scan::arena_bytes];
static_assert(sizeof arena >= minimum_bytes<uint16_t>(scan::limits), "see arena_bytes in scan.hpp");
// Known at compile time, so that the firmware need not carry the code that works them out.
constexpr Capacities capacities = default_capacities<uint16_t>(scan::limits, sizeof arena);
Extractor16 extractor;
Encoder encoder;
uint32_t next_row = 0;

// Sees a call to the library through. While the UART is busy there is nothing else to do: rows that
// come meanwhile go to the halves, by interrupt.
bool succeeds(Status status) {
  while (status == Status::more) {
    board::wait();
    status = extractor.resume();
  }
  return status == Status::ok;
}

// Ends the frame that a reset has cut off, so that the header behind it is read.
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
                                  sink_to(encoder)));
}

// Stands in for rows that were lost, up to the one with this number.
bool skip_to(uint32_t number) {
  while (next_row < number) {
    if (!succeeds(extractor.skip_row(Substitute::previous_row).status)) return false;
    ++next_row;
  }
  return true;
}

bool take(const Row& row) {
  if (!skip_to(row.number)) return false;
  const Status status = extractor.push(row.samples, scan::limits.width).status;
  ++next_row;
  release(emptied, emptied + 1);  // before the UART is waited for: the next row needs the half
  board::half_is_free();
  return succeeds(status);
}

bool take_all_rows() {
  for (;;) {
    const bool was_last = acquire(ended);  // before the halves: a row may come in between
    if (acquire(filled) != emptied) {
      if (!take(halves[emptied % 2])) return false;
    } else if (was_last) {
      return skip_to(row_count);
    } else {
      board::wait();
    }
  }
}

// A scan that ends within a slice, or was broken off, still leaves a closed surface behind.
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
  board::start();
  const bool succeeded = start() && take_all_rows() && end();
  report();
  board::stop(succeeded);
}
