/* As much of Zephyr's drivers/uart.h as the sample uses. */
#pragma once

#include <zephyr/device.h>

#ifdef __cplusplus
extern "C"
#endif
void uart_poll_out(const struct device* uart, unsigned char byte);
