// The UART of Arm's Cortex-M System Design Kit (CMSDK APB UART).
#include <hardware.hpp>

#include "port.hpp"

namespace {

constexpr uintptr_t data = hardware::uart;
constexpr uintptr_t state = hardware::uart + 0x04;
constexpr uintptr_t control = hardware::uart + 0x08;
constexpr uintptr_t interrupts = hardware::uart + 0x0C;
constexpr uintptr_t divider = hardware::uart + 0x10;

constexpr uint32_t is_full = 1 << 0;         // of the state
constexpr uint32_t send_enable = 1 << 0;     // of the control
constexpr uint32_t send_interrupt = 1 << 2;  // of the control
constexpr uint32_t has_sent = 1 << 0;        // of the interrupts

}  // namespace

void uart::start() {
  register_at(divider) = hardware::uart_divider;
  register_at(control) = send_enable;
  cpu::enable_interrupt(hardware::uart_send_interrupt);
}

bool uart::send(uint8_t byte) {
  // This order misses no interrupt if the preceding byte leaves now.
  if (register_at(state) & is_full) {
    register_at(control) = send_enable | send_interrupt;
    if (register_at(state) & is_full) return false;
  }
  register_at(data) = byte;
  return true;
}

// The last byte is in the shift register, which has no status.
bool uart::is_idle() {
  return (register_at(state) & is_full) == 0;
}

void uart::on_interrupt() {
  if (!(register_at(interrupts) & has_sent)) return;
  register_at(control) = send_enable;
  register_at(interrupts) = has_sent;
}
