# Arm MPS2 with the image AN386: Cortex-M4.
set(discmc_board_processor "-mcpu=cortex-m4 -mthumb -mfloat-abi=soft")
set(discmc_board_uart cmsdk)
set(discmc_board_machine qemu-system-arm -M mps2-an386)
