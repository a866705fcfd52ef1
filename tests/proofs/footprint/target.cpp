// Runs the counted work on a board of ports/boards/. It uses the board's start-up code and console;
// UART and source of rows are empty.
#include <port.hpp>

#include "marks.hpp"

void uart::start() {}
bool uart::send(uint8_t) {
  return false;
}
bool uart::is_idle() {
  return true;
}
void uart::on_interrupt() {}

void source::start() {}
void source::on_request() {}
void source::on_interrupt() {}

// The bodies differ, so that the linker does not fold them into one.
[[gnu::noinline]] void count_on() {
  __asm__ volatile("");
}
[[gnu::noinline]] void count_off() {
  __asm__ volatile("nop");
}
[[gnu::noinline]] void count_report() {
  __asm__ volatile("nop; nop");
}
