# QEMU's machine virt with a 32-bit core. With the older ISA specification GCC 12 finds the right libgcc and still
# supports the instructions for control registers.
set(discmc_board_processor "-march=rv32imac -mabi=ilp32 -misa-spec=2.2 -mcmodel=medany")
set(discmc_board_uart ns16550)
set(discmc_board_machine qemu-system-riscv32 -M virt -bios none)
