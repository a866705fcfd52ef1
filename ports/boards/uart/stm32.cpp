// The USART of the STM32F1, F2 and F4.
#include <hardware.hpp>

#include "port.hpp"

namespace {

constexpr uintptr_t status = hardware::uart;
constexpr uintptr_t data = hardware::uart + 0x04;
constexpr uintptr_t divider = hardware::uart + 0x08;
constexpr uintptr_t control = hardware::uart + 0x0C;

constexpr uint32_t all_is_sent = 1 << 6;            // of the status
constexpr uint32_t has_room = 1 << 7;               // of the status
constexpr uint32_t send_enable = 1 << 13 | 1 << 3;  // of the control
constexpr uint32_t room_interrupt = 1 << 7;         // of the control

}  // namespace

void uart::start() {
  register_at(divider) = hardware::uart_divider;
  register_at(control) = send_enable;
  cpu::enable_interrupt(hardware::uart_interrupt);
}

bool uart::send(uint8_t byte) {
  if (!(register_at(status) & has_room)) {
    register_at(control) = send_enable | room_interrupt;
    return false;
  }
  register_at(data) = byte;
  return true;
}

bool uart::is_idle() {
  return (register_at(status) & all_is_sent) != 0;
}

// The interrupt persists while there is room, so one is enough.
void uart::on_interrupt() {
  register_at(control) = send_enable;
}
