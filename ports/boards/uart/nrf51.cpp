// The UART of Nordic's nRF51.
#include <hardware.hpp>

#include "port.hpp"

namespace {

constexpr uintptr_t start_sending = hardware::uart + 0x008;
constexpr uintptr_t has_sent = hardware::uart + 0x11C;
constexpr uintptr_t set_interrupts = hardware::uart + 0x304;
constexpr uintptr_t clear_interrupts = hardware::uart + 0x308;
constexpr uintptr_t enable = hardware::uart + 0x500;
constexpr uintptr_t pin = hardware::uart + 0x50C;
constexpr uintptr_t data = hardware::uart + 0x51C;
constexpr uintptr_t baud_rate = hardware::uart + 0x524;

constexpr uint32_t enabled = 4;
constexpr uint32_t sent_interrupt = 1 << 7;

// No register shows that the UART is free. A byte is being sent from its write to its event.
bool is_sending = false;

}  // namespace

void uart::start() {
  register_at(pin) = hardware::uart_pin;
  register_at(baud_rate) = hardware::uart_baud_rate;
  register_at(enable) = enabled;
  register_at(start_sending) = 1;
  cpu::enable_interrupt(hardware::uart_interrupt);
}

bool uart::send(uint8_t byte) {
  if (!is_idle()) {
    register_at(set_interrupts) = sent_interrupt;
    return false;
  }
  register_at(has_sent) = 0;
  register_at(data) = byte;
  is_sending = true;
  return true;
}

bool uart::is_idle() {
  return !is_sending || register_at(has_sent) != 0;
}

// The interrupt persists while the event is set, so one is enough.
void uart::on_interrupt() {
  register_at(clear_interrupts) = sent_interrupt;
}
