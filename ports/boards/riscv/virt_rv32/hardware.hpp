// Addresses and numbers of QEMU's machine virt.
#pragma once

#include <stdint.h>

namespace hardware {

constexpr uintptr_t software_interrupt = 0x02000000;    // of the CLINT
constexpr uintptr_t interrupt_controller = 0x0C000000;  // the PLIC

constexpr uintptr_t uart = 0x10000000;
constexpr uint32_t uart_interrupt = 10;

}  // namespace hardware
