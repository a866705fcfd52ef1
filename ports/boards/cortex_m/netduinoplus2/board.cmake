# Netduino Plus 2: STM32F405, Cortex-M4, 128 KB of RAM, and 64 KB beside it that are not used.
set(discmc_board_processor "-mcpu=cortex-m4 -mthumb -mfloat-abi=soft")
set(discmc_board_uart stm32)
set(discmc_board_machine qemu-system-arm -M netduinoplus2)
