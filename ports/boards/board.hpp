// What the scanner application (examples/scanner.cpp) and a board ask of each other.
//
// The board fills rows of the application's ring, as a DMA controller would, and says so from its
// interrupt; the application empties them in its main loop and gives the stream to the UART. The
// application calls `board`, the board's interrupts call `rows`. README.md tells how a port is
// made.
#ifndef DISCMC_BOARDS_BOARD_HPP
#define DISCMC_BOARDS_BOARD_HPP

#include <stddef.h>
#include <stdint.h>

namespace board {

/// Starts the UART and the source of rows. The first row may come at once.
void start();

/// Tells the source that a row of the ring is free again.
void row_is_free();

/// Sleeps until an interrupt has come since the last call; returning early is harmless.
void wait();

/// Gives bytes of the stream to the UART: as many as it has room for. Returns their number. After
/// fewer than all, an interrupt comes when there is room again.
size_t uart_write(void* context, const uint8_t* bytes, size_t count);

/// Tells whoever is listening, a debugger, a figure by its name.
void report(const char* name, uint32_t value);

/// Ends the program, after the last byte has left. `succeeded` tells how it went.
[[noreturn]] void stop(bool succeeded);

}  // namespace board

// To be called from interrupts that do not interrupt each other.
namespace rows {

/// The row to fill next; null while all are full: a row that comes now is lost.
void* free_row();

/// The row given last holds row `number` of the scan, counted over all slices from 0. Numbers
/// rise; those left out are rows that were lost.
void row_is_full(uint32_t number);

/// No row follows: the scan had `count` rows, or was broken off after so many.
void end_of_scan(uint32_t count, bool broken_off);

}  // namespace rows

#endif
