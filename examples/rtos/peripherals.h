// The drivers that rtos_task.cpp asks for: a scanner's sensor and a UART, both with DMA.
#ifndef DISCMC_RTOS_PERIPHERALS_H
#define DISCMC_RTOS_PERIPHERALS_H

#include <stddef.h>
#include <stdint.h>

constexpr uint32_t sensor_pixels = 48;

/// Begins to read a row of the scan; when it is there, on_row_read() is called from an interrupt.
void read_row(uint8_t* samples, uint32_t number);

/// Begins to send; when the last byte has left, on_bytes_sent() is called from an interrupt.
void send_bytes(const uint8_t* bytes, size_t count);

extern "C" void on_row_read();
extern "C" void on_bytes_sent();

#endif
