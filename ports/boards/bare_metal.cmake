# Shared by the toolchain files: no operating system, no C library, small code. The options of the board's processor
# apply to the library as well.
set(DISCMC_BOARD "" CACHE STRING "The board to build firmware for: a folder with a board.cmake")
file(GLOB discmc_board_dir ${CMAKE_CURRENT_LIST_DIR}/*/${DISCMC_BOARD}/board.cmake)
if(NOT DISCMC_BOARD OR NOT discmc_board_dir)
  message(FATAL_ERROR "no board '${DISCMC_BOARD}'; give -DDISCMC_BOARD= the name of a folder in ports/boards/cortex_m or ports/boards/riscv")
endif()
get_filename_component(discmc_board_dir ${discmc_board_dir} DIRECTORY)
include(${discmc_board_dir}/board.cmake)

# CMake tries the compiler with small projects of its own, which read this file too.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES DISCMC_BOARD)

set(CMAKE_BUILD_TYPE MinSizeRel CACHE STRING "MinSizeRel is -Os")
set(CMAKE_CXX_FLAGS_INIT "${discmc_board_processor} -g -ffreestanding -fno-exceptions -fno-rtti \
-fno-threadsafe-statics -fno-asynchronous-unwind-tables -ffunction-sections -fdata-sections")

# A program is run by emulating the board. The debugger's part is QEMU's: see semihosting.hpp.
set(CMAKE_CROSSCOMPILING_EMULATOR ${discmc_board_machine} -display none -monitor none
  -serial file:stream.dmc -semihosting-config enable=on,target=native -kernel)
