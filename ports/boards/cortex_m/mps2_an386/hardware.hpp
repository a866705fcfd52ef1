// Addresses and numbers of the MPS2 with AN386.
#pragma once

#include <stdint.h>

namespace hardware {

constexpr uintptr_t uart = 0x40004000;  // UART0
constexpr uint32_t uart_send_interrupt = 1;
constexpr uint32_t uart_divider = 25000000 / 115200;

constexpr uintptr_t rows_uart = 0x40005000;  // UART1, of the same kind
constexpr uint32_t rows_receive_interrupt = 2;
constexpr uint32_t rows_send_interrupt = 3;

}  // namespace hardware
