# GCC for RISC-V, with the options that board/make has written to BOARD_SDK.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES BOARD_SDK)
set(CMAKE_C_FLAGS_INIT @${BOARD_SDK}/compile)
set(CMAKE_CXX_FLAGS_INIT @${BOARD_SDK}/compile)
