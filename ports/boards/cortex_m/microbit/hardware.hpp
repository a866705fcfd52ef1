// Addresses and numbers of the nRF51822 on a BBC micro:bit.
#pragma once

#include <stdint.h>

namespace hardware {

constexpr uintptr_t uart = 0x40002000;
constexpr uint32_t uart_interrupt = 2;
constexpr uint32_t uart_pin = 24;
constexpr uint32_t uart_baud_rate = 0x01D7E000;  // 115200

}  // namespace hardware
