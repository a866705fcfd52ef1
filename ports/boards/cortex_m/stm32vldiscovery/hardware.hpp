// Addresses and numbers of the STM32F100.
#pragma once

#include <stdint.h>

namespace hardware {

constexpr uintptr_t uart = 0x40013800;  // USART1
constexpr uint32_t uart_interrupt = 37;
constexpr uint32_t uart_divider = 24000000 / 115200;

}  // namespace hardware
