// Start-up, interrupts and faults of a RISC-V with a CLINT and a PLIC, 32 or 64 bits, machine mode.
#include <stddef.h>
#include <stdint.h>
#include <hardware.hpp>

#include "board.hpp"
#include "memory_image.hpp"
#include "port.hpp"

extern "C" {
void application() __asm__("main");  // C++ forbids calls of main
void entry();
void start();
void on_trap();
void on_interrupt();
void fault();
}

namespace {

constexpr uintptr_t plic_priorities = hardware::interrupt_controller;
constexpr uintptr_t plic_enable = hardware::interrupt_controller + 0x2000;
constexpr uintptr_t plic_threshold = hardware::interrupt_controller + 0x200000;
constexpr uintptr_t plic_claim = hardware::interrupt_controller + 0x200004;

constexpr uintptr_t interrupts_on = 1 << 3;  // of mstatus
constexpr uintptr_t software = 1 << 3;       // of mie
constexpr uintptr_t external = 1 << 11;      // of mie
constexpr uintptr_t software_cause = 3;      // of mcause, in its low byte

// pmpcfg0 and pmpaddr0 forbid all accesses to 4096 bytes, in machine mode, too.
constexpr uintptr_t locked_range = 0x98;
constexpr uintptr_t range_of_4096 = 0x1FF;
constexpr uintptr_t guard_bytes = 4096;

bool was_interrupted = false;

// Forbids accesses below the stack, because RAM below it would hide an overflow.
void guard_stack() {
  const uintptr_t guard = reinterpret_cast<uintptr_t>(stack_begin) - guard_bytes;
  __asm__ volatile("csrw pmpaddr0, %0; csrw pmpcfg0, %1" ::"r"(guard >> 2 | range_of_4096),
                   "r"(locked_range));
}

}  // namespace

// The first instruction of the program sets the stack.
[[gnu::naked, gnu::section(".entry")]] void entry() {
  __asm__ volatile("la sp, stack_end; j start");
}

[[gnu::used]] void start() {
  const uintptr_t* stack_pointer;
  __asm__ volatile("mv %0, sp" : "=r"(stack_pointer));
  memory_image::paint_stack(stack_pointer);
  guard_stack();
  memory_image::initialise();

  register_at(plic_threshold) = 0;
  __asm__ volatile("csrw mtvec, %0" ::"r"(on_trap));
  __asm__ volatile("csrw mie, %0" ::"r"(software | external));
  __asm__ volatile("csrs mstatus, %0" ::"r"(interrupts_on));
  application();
}

// The sign bit of the cause marks an interrupt. All else is a fault. The stack may be its cause, so
// the handler runs on a fresh one.
[[gnu::naked, gnu::aligned(4)]] void on_trap() {
  __asm__ volatile(
      "csrw mscratch, t0  \n"
      "csrr t0, mcause    \n"
      "bgez t0, 1f        \n"
      "csrr t0, mscratch  \n"
      "j on_interrupt     \n"
      "1:                 \n"
      "la sp, stack_end   \n"
      "j fault");
}

[[gnu::used]] void fault() {
  board::fault();
}

[[gnu::interrupt, gnu::used]] void on_interrupt() {
  was_interrupted = true;
  uintptr_t cause;
  __asm__ volatile("csrr %0, mcause" : "=r"(cause));
  if ((cause & 0xFF) == software_cause) {
    register_at(hardware::software_interrupt) = 0;
    source::on_request();
  } else {
    const uint32_t number = register_at(plic_claim);
    uart::on_interrupt();
    source::on_interrupt();
    register_at(plic_claim) = number;
  }
}

void cpu::request_rows() {
  register_at(hardware::software_interrupt) = 1;
}

void cpu::enable_interrupt(uint32_t number) {
  register_at(plic_priorities + 4 * number) = 1;
  register_at(plic_enable + number / 32 * 4) |= uint32_t{1} << number % 32;
}

// Interrupts are off, so that none arrives between the test and the sleep. A pending interrupt ends
// the sleep nevertheless.
void board::wait() {
  __asm__ volatile("csrc mstatus, %0" ::"r"(interrupts_on) : "memory");
  if (!was_interrupted) __asm__ volatile("wfi" ::: "memory");
  was_interrupted = false;
  __asm__ volatile("csrs mstatus, %0" ::"r"(interrupts_on) : "memory");
}

// The debugger detects the request by the three instructions, which must be uncompressed and on one
// page.
[[gnu::noinline]] uintptr_t cpu::ask_debugger(uintptr_t operation, const void* arguments) {
  register uintptr_t a0 __asm__("a0") = operation;
  register const void* a1 __asm__("a1") = arguments;
  __asm__ volatile(
      ".balign 16          \n"
      ".option push        \n"
      ".option norvc       \n"
      "slli x0, x0, 0x1f   \n"
      "ebreak              \n"
      "srai x0, x0, 7      \n"
      ".option pop"
      : "+r"(a0)
      : "r"(a1)
      : "memory");
  return a0;
}
