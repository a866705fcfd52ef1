/* As much of ESP-IDF's driver/uart.h as the example uses. */
#pragma once

#include <stddef.h>

typedef int esp_err_t;
typedef int uart_port_t;
typedef void* QueueHandle_t;
#define ESP_OK 0
#define UART_NUM_0 0

#ifdef __cplusplus
extern "C" {
#endif
esp_err_t uart_driver_install(uart_port_t port, int rx_buffer_size, int tx_buffer_size, int queue_size,
                              QueueHandle_t* queue, int interrupt_flags);
int uart_write_bytes(uart_port_t port, const void* bytes, size_t count);
#ifdef __cplusplus
}
#endif
