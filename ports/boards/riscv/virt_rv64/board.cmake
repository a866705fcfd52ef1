# QEMU's machine virt with a 64-bit core; everything else is as with 32 bits.
set(discmc_board_processor "-march=rv64imac -mabi=lp64 -misa-spec=2.2 -mcmodel=medany")
set(discmc_board_uart ns16550)
set(discmc_board_machine qemu-system-riscv64 -M virt -bios none)
