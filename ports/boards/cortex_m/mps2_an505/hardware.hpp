// Addresses and numbers of the MPS2 with AN505.
#pragma once

#include <stdint.h>

namespace hardware {

constexpr uintptr_t uart = 0x50200000;  // UART0 in the secure world
constexpr uint32_t uart_send_interrupt = 33;
constexpr uint32_t uart_divider = 20000000 / 115200;

}  // namespace hardware
