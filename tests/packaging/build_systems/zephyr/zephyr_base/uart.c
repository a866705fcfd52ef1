/* The UART of the emulated board, as the console. */
#include <sdk.h>
#include <zephyr/drivers/uart.h>

const struct device zephyr_console = {"uart0"};

void uart_poll_out(const struct device* uart, unsigned char byte) {
  (void)uart;
  sdk_write(&byte, 1);
}
