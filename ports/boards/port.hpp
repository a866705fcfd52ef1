// The interfaces between the parts of a port: the processor, the UART's driver, the source of rows
// and, if there is one, the debugger. The application uses only board.hpp.
#pragma once

#include <stddef.h>
#include <stdint.h>

/// The processor: cortex_m/cpu.cpp or riscv/cpu.cpp.
namespace cpu {

/// Requests a call of source::on_request() from an interrupt, as soon as possible.
void request_rows();

/// Enables the interrupt of a peripheral. Each one calls uart::on_interrupt() and
/// source::on_interrupt(), which read their own registers for the cause.
void enable_interrupt(uint32_t number);

/// A request to the debugger: see semihosting.hpp.
uintptr_t ask_debugger(uintptr_t operation, const void* arguments);

}  // namespace cpu

namespace board {

/// Handles a fault of the processor. Called on a fresh stack, because the old one may be the cause.
[[noreturn]] void fault();

}  // namespace board

/// The UART for the stream: one driver per kind of UART, in uart/.
namespace uart {

void start();

/// Sends a byte. Returns false if there is no room; an interrupt follows when there is.
bool send(uint8_t byte);

/// Whether everything has left.
bool is_idle();

void on_interrupt();

}  // namespace uart

/// The source of rows: rows/file.cpp, or a driver of your own. It calls `rows` (board.hpp), only
/// from its two interrupts, and defines board::row_is_free().
namespace source {

void start();
void on_request();
void on_interrupt();

}  // namespace source

/// A register of a peripheral.
template <class Width = uint32_t>
volatile Width& register_at(uintptr_t address) {
  return *reinterpret_cast<volatile Width*>(address);
}
