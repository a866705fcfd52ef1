# STM32VLDISCOVERY: STM32F100, Cortex-M3, 8 KB of RAM.
set(discmc_board_processor "-mcpu=cortex-m3 -mthumb")
set(discmc_board_uart stm32)
set(discmc_board_machine qemu-system-arm -M stm32vldiscovery)
