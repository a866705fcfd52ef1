// The interface between the scanner application (examples/scanner.cpp) and a board.
//
// The board fills rows of the application's ring, as a DMA controller would, and reports each row
// from its interrupt. The application empties the rows in its main loop, and gives the stream to
// the UART. The application calls `board`; the board's interrupts call `rows`. docs/porting.md is
// the guide.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace board {

/// Starts the UART and the source of rows. The first row may arrive at once.
void start();

/// Notifies the source that a row of the ring is free again.
void row_is_free();

/// Sleeps until an interrupt has come since the last call; returning early is harmless.
void wait();

/// Gives bytes of the stream to the UART, as many as it has room for, and returns their number. If
/// it accepts fewer than all, an interrupt follows when there is room again.
size_t uart_write(void* context, const uint8_t* bytes, size_t count);

/// Prints a figure with its name, for example in a debugger.
void report(const char* name, uint32_t value);

/// Ends the program, after the last byte has left. `succeeded`: the result of the scan.
[[noreturn]] void stop(bool succeeded);

}  // namespace board

// Call these from interrupts that do not interrupt each other.
namespace rows {

/// Returns the row to fill next; null while all are full: a row that arrives now is lost.
void* free_row();

/// Reports that the last row returned now contains row `number` of the scan, counted over all
/// slices from 0. Numbers rise; omitted numbers are lost rows.
void row_is_full(uint32_t number);

/// Reports that no row follows: the scan had `count` rows, or was abandoned after that many.
void end_of_scan(uint32_t count, bool broken_off);

}  // namespace rows
