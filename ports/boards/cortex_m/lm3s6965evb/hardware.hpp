// Addresses and numbers of the LM3S6965.
#pragma once

#include <stdint.h>

namespace hardware {

constexpr uintptr_t uart = 0x4000C000;  // UART0
constexpr uint32_t uart_interrupt = 5;
constexpr uint32_t uart_divider_64ths = 4 * 50000000 / 115200;  // 16 clocks a bit

}  // namespace hardware
