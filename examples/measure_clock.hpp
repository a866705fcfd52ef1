// A counter of processor cycles, for measure.cpp.
#pragma once

#include <stdint.h>

namespace measure_clock {

inline volatile uint32_t& register_at(uintptr_t address) {
  return *reinterpret_cast<volatile uint32_t*>(address);
}

#if defined(__riscv)

constexpr uint32_t bits = 32;
inline void start() {}
inline uint32_t now() {
  uintptr_t cycles;
  __asm__ volatile("csrr %0, mcycle" : "=r"(cycles)::"memory");
  return static_cast<uint32_t>(cycles);
}
inline uint32_t since(uint32_t before) {
  return now() - before;
}

#elif defined(__ARM_ARCH_6M__) || defined(DISCMC_MEASURE_BY_SYSTICK)

// SysTick counts down, 24 bits: no row may take longer.
constexpr uint32_t bits = 24;
constexpr uint32_t most = (uint32_t{1} << bits) - 1;
inline void start() {
  constexpr uint32_t by_processor = 4, enable = 1;
  register_at(0xE000E014) = most;
  register_at(0xE000E018) = 0;
  register_at(0xE000E010) = by_processor | enable;
}
inline uint32_t now() {
  return register_at(0xE000E018);
}
inline uint32_t since(uint32_t before) {
  return (before - now()) & most;
}

#else

constexpr uint32_t bits = 32;
inline void start() {
  constexpr uint32_t trace_enable = uint32_t{1} << 24, enable = 1;
  register_at(0xE000EDFC) = register_at(0xE000EDFC) | trace_enable;  // DEMCR
  register_at(0xE0001FB0) = 0xC5ACCE55;  // the lock of the DWT: some Cortex-M7 have one
  register_at(0xE0001004) = 0;           // CYCCNT
  register_at(0xE0001000) = register_at(0xE0001000) | enable;
}
inline uint32_t now() {
  return register_at(0xE0001004);
}
inline uint32_t since(uint32_t before) {
  return now() - before;
}

#endif

}  // namespace measure_clock
