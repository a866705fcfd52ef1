/* The UART of the emulated board. */
#include <driver/uart.h>
#include <sdk.h>

esp_err_t uart_driver_install(uart_port_t port, int rx_buffer_size, int tx_buffer_size, int queue_size,
                              QueueHandle_t* queue, int interrupt_flags) {
  (void)port, (void)tx_buffer_size, (void)queue_size, (void)queue, (void)interrupt_flags;
  return rx_buffer_size > 128 ? ESP_OK : -1; /* it must be more than the hardware's */
}

int uart_write_bytes(uart_port_t port, const void* bytes, size_t count) {
  (void)port;
  sdk_write(bytes, count);
  return (int)count;
}
