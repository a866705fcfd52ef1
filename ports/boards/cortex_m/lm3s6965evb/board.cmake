# Stellaris LM3S6965 evaluation board: Cortex-M3, 64 KB of RAM.
set(discmc_board_processor "-mcpu=cortex-m3 -mthumb")
set(discmc_board_uart pl011)
set(discmc_board_machine qemu-system-arm -M lm3s6965evb)
