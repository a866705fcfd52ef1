// Addresses and numbers of the MPS2 with AN500.
#pragma once

#include <stdint.h>

namespace hardware {

constexpr uintptr_t uart = 0x40004000;  // UART0
constexpr uint32_t uart_send_interrupt = 1;
constexpr uint32_t uart_divider = 25000000 / 115200;

}  // namespace hardware
