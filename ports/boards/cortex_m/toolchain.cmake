# Arm's GCC for the Cortex-M of DISCMC_BOARD: cmake --toolchain <this file> -DDISCMC_BOARD=microbit
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
include(${CMAKE_CURRENT_LIST_DIR}/../bare_metal.cmake)
