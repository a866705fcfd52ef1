# BBC micro:bit: nRF51822, Cortex-M0, 16 KB of RAM.
set(discmc_board_processor "-mcpu=cortex-m0 -mthumb")
set(discmc_board_uart nrf51)
set(discmc_board_machine qemu-system-arm -M microbit)
