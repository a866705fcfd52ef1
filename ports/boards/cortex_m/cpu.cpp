// Start-up, interrupts and faults of a Cortex-M, from M0 to M33.
#include <stddef.h>
#include <stdint.h>

#include "board.hpp"
#include "port.hpp"

extern "C" {
// From sections.ld.
extern uint32_t stack_begin[], stack_end[];
extern uint32_t data_begin[], data_end[];
extern const uint32_t data_load[];
extern uint32_t bss_begin[], bss_end[];

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

constexpr uint32_t paint = 0xA5C3A5C3;

struct Vectors {
  using Handler = void (*)();
  const uint32_t* stack;
  Handler exceptions[15];
  Handler interrupts[64];
};

// Exceptions by their numbers less one: 1 is the reset, 11 and above are calls of the system.
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
  // Below the stack pointer: what is still painted at the end was never reached.
  uint32_t* stack_pointer;
  __asm__ volatile("mov %0, sp" : "=r"(stack_pointer));
  for (uint32_t* word = stack_begin; word < stack_pointer; ++word) *word = paint;
  const uint32_t* from = data_load;
  for (uint32_t* to = data_begin; to < data_end;) *to++ = *from++;
  for (uint32_t* to = bss_begin; to < bss_end;) *to++ = 0;
  application();
}

// The stack may be what is at fault, so the rest happens on a fresh one.
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

// With interrupts off none comes between the look and the sleep; a pending one ends it all the
// same.
void board::wait() {
  __asm__ volatile("cpsid i" ::: "memory");
  if (!was_interrupted) __asm__ volatile("wfi" ::: "memory");
  was_interrupted = false;
  __asm__ volatile("cpsie i" ::: "memory");
}

size_t cpu::stack_used() {
  const uint32_t* word = stack_begin;
  while (word < stack_end && *word == paint) ++word;
  return static_cast<size_t>(stack_end - word) * sizeof *word;
}

size_t cpu::stack_bytes() {
  return static_cast<size_t>(stack_end - stack_begin) * sizeof *stack_begin;
}

uintptr_t cpu::ask_debugger(uintptr_t operation, const void* arguments) {
  register uintptr_t r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = arguments;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}
