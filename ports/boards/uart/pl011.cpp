// Arm's PrimeCell UART (PL011).
#include <hardware.hpp>

#include "port.hpp"

namespace {

constexpr uintptr_t data = hardware::uart;
constexpr uintptr_t flags = hardware::uart + 0x18;
constexpr uintptr_t divider_whole = hardware::uart + 0x24;
constexpr uintptr_t divider_64ths = hardware::uart + 0x28;
constexpr uintptr_t line_control = hardware::uart + 0x2C;
constexpr uintptr_t control = hardware::uart + 0x30;
constexpr uintptr_t interrupts = hardware::uart + 0x38;
constexpr uintptr_t clear_interrupts = hardware::uart + 0x44;

constexpr uint32_t is_busy = 1 << 3;               // of the flags
constexpr uint32_t is_full = 1 << 5;               // of the flags
constexpr uint32_t fifo_enable = 1 << 4;           // of the line control
constexpr uint32_t eight_bits = 3 << 5;            // of the line control
constexpr uint32_t send_enable = 1 << 8 | 1 << 0;  // of the control
constexpr uint32_t room_interrupt = 1 << 5;

}  // namespace

void uart::start() {
  register_at(divider_whole) = hardware::uart_divider_64ths / 64;
  register_at(divider_64ths) = hardware::uart_divider_64ths % 64;
  register_at(line_control) = eight_bits | fifo_enable;
  register_at(control) = send_enable;
  cpu::enable_interrupt(hardware::uart_interrupt);
}

bool uart::send(uint8_t byte) {
  // This order misses no interrupt if room becomes available now.
  if (register_at(flags) & is_full) {
    register_at(clear_interrupts) = room_interrupt;
    register_at(interrupts) = room_interrupt;
    if (register_at(flags) & is_full) return false;
  }
  register_at(data) = byte;
  return true;
}

bool uart::is_idle() {
  return (register_at(flags) & is_busy) == 0;
}

void uart::on_interrupt() {
  register_at(interrupts) = 0;
}
