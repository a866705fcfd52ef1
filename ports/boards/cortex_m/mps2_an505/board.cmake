# Arm MPS2 with the image AN505: Cortex-M33, secure state.
set(discmc_board_processor "-mcpu=cortex-m33 -mthumb -mfloat-abi=soft")
set(discmc_board_uart cmsdk)
set(discmc_board_machine qemu-system-arm -M mps2-an505)
