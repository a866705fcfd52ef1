// The UART NS16550A and its many descendants, with registers a byte apart.
#include <hardware.hpp>

#include "port.hpp"

namespace {

constexpr uintptr_t data = hardware::uart;
constexpr uintptr_t interrupts = hardware::uart + 1;
constexpr uintptr_t fifo_control = hardware::uart + 2;
constexpr uintptr_t line_control = hardware::uart + 3;
constexpr uintptr_t line_status = hardware::uart + 5;

constexpr uint8_t empty_interrupt = 1 << 1;
constexpr uint8_t fifo_enable = 1 << 0;
constexpr uint8_t eight_bits = 3 << 0;     // of the line control
constexpr uint8_t fifo_is_empty = 1 << 5;  // of the line status
constexpr uint8_t all_is_sent = 1 << 6;    // of the line status
constexpr uint8_t fifo_bytes = 16;

uint8_t room = 0;  // upper bound of the bytes in the FIFO

}  // namespace

void uart::start() {
  register_at<uint8_t>(line_control) = eight_bits;
  register_at<uint8_t>(fifo_control) = fifo_enable;
  cpu::enable_interrupt(hardware::uart_interrupt);
}

bool uart::send(uint8_t byte) {
  if (room == 0) {
    if (!(register_at<uint8_t>(line_status) & fifo_is_empty)) {
      register_at<uint8_t>(interrupts) = empty_interrupt;
      return false;
    }
    room = fifo_bytes;
  }
  register_at<uint8_t>(data) = byte;
  --room;
  return true;
}

bool uart::is_idle() {
  return (register_at<uint8_t>(line_status) & all_is_sent) != 0;
}

// The interrupt persists while the FIFO is empty, so one is enough.
void uart::on_interrupt() {
  register_at<uint8_t>(interrupts) = 0;
}
