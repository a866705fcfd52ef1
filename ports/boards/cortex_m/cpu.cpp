// Start-up, interrupts and faults of a Cortex-M, from M0 to M33.
#include <stddef.h>
#include <stdint.h>

#include "board.hpp"
#include "memory_image.hpp"
#include "port.hpp"

extern "C" {
void application() __asm__("main");  // C++ forbids calls of main
void start();
void on_fault();
void fault();
void on_request();
void on_interrupt();
}

namespace {

constexpr uintptr_t nvic_enable = 0xE000E100;
constexpr uintptr_t interrupt_control = 0xE000ED04;
constexpr uint32_t set_pendsv = uint32_t{1} << 28;

struct Vectors {
  using Handler = void (*)();
  const uintptr_t* stack;
  Handler exceptions[15];
  Handler interrupts[64];
};

// Exception n has index n - 1: 1 is the reset; 11 and above are system calls.
constexpr Vectors vectors_of_all() {
  Vectors vectors{stack_end, {}, {}};
  for (Vectors::Handler& exception : vectors.exceptions) exception = on_fault;
  vectors.exceptions[0] = start;
  vectors.exceptions[13] = on_request;  // PendSV
  for (Vectors::Handler& interrupt : vectors.interrupts) interrupt = on_interrupt;
  return vectors;
}

[[gnu::section(".vectors"), gnu::used]] constexpr Vectors vectors = vectors_of_all();

volatile bool was_interrupted = false;

}  // namespace

void start() {
  const uintptr_t* stack_pointer;
  __asm__ volatile("mov %0, sp" : "=r"(stack_pointer));
  memory_image::paint_stack(stack_pointer);
  memory_image::initialise();
  application();
}

// The stack may be the cause, so the handler runs on a fresh one.
[[gnu::naked]] void on_fault() {
  __asm__ volatile(
      "ldr r0, =stack_end \n"
      "mov sp, r0         \n"
      "bl fault           \n"
      ".ltorg");
}

[[gnu::used]] void fault() {
  board::fault();
}

void on_request() {
  was_interrupted = true;
  source::on_request();
}

void on_interrupt() {
  was_interrupted = true;
  uart::on_interrupt();
  source::on_interrupt();
}

void cpu::request_rows() {
  register_at(interrupt_control) = set_pendsv;
}

void cpu::enable_interrupt(uint32_t number) {
  register_at(nvic_enable + number / 32 * 4) = uint32_t{1} << number % 32;
}

// Interrupts are off, so that none arrives between the test and the sleep. A pending interrupt ends
// the sleep nevertheless.
void board::wait() {
  __asm__ volatile("cpsid i" ::: "memory");
  if (!was_interrupted) __asm__ volatile("wfi" ::: "memory");
  was_interrupted = false;
  __asm__ volatile("cpsie i" ::: "memory");
}

uintptr_t cpu::ask_debugger(uintptr_t operation, const void* arguments) {
  register uintptr_t r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = arguments;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}
