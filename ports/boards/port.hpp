// What the parts of a port ask of each other: the processor, the UART's driver, the source of rows
// and, where there is one, the debugger. The application knows none of this; it knows board.hpp.
#ifndef DISCMC_BOARDS_PORT_HPP
#define DISCMC_BOARDS_PORT_HPP

#include <stddef.h>
#include <stdint.h>

/// The processor: cortex_m/cpu.cpp or riscv/cpu.cpp.
namespace cpu {

/// Has source::on_request() called from an interrupt, as soon as that can be.
void request_rows();

/// Lets a peripheral interrupt. Each one calls uart::on_interrupt() and source::on_interrupt(),
/// which look for what has happened in their own registers.
void enable_interrupt(uint32_t number);

/// The deepest that the stack has been so far, and the most it may be.
size_t stack_used();
size_t stack_bytes();

/// A request to the debugger, in its own words: see semihosting.hpp.
uintptr_t ask_debugger(uintptr_t operation, const void* arguments);

}  // namespace cpu

namespace board {

/// The processor has faulted. Called on a fresh stack, as the old one may be what is at fault.
[[noreturn]] void fault();

}  // namespace board

/// The UART by which the stream leaves: one driver a kind of UART, in uart/.
namespace uart {

void start();

/// Sends a byte. False: there is no room, and an interrupt will come when there is.
bool send(uint8_t byte);

/// Nothing is on its way out.
bool is_idle();

void on_interrupt();

}  // namespace uart

/// Where the rows come from: rows/file.cpp, or a driver of your own. It calls `rows` (board.hpp),
/// and only from its two interrupts; it is also what defines board::row_is_free().
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

#endif
