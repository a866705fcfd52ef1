# GCC for the RISC-V of DISCMC_BOARD: cmake --toolchain <this file> -DDISCMC_BOARD=virt_rv32
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv)
set(CMAKE_CXX_COMPILER riscv64-unknown-elf-g++)
include(${CMAKE_CURRENT_LIST_DIR}/../bare_metal.cmake)
