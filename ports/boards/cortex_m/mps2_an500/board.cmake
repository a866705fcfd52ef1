# Arm MPS2 with the image AN500: Cortex-M7.
set(discmc_board_processor "-mcpu=cortex-m7 -mthumb -mfloat-abi=soft")
set(discmc_board_uart cmsdk)
set(discmc_board_machine qemu-system-arm -M mps2-an500)
