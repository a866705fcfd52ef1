# A stand-in for Zephyr's CMake package. Like Zephyr:
#   - find_package(Zephyr) comes before project(), names the compilers and makes the target app
#   - a module is a folder with zephyr/module.yml, which names the folders of its CMakeLists.txt and Kconfig
#   - Kconfig reads prj.conf; an assignment without effect ends the build
#   - zephyr_library_named() begins a library that the functions zephyr_library_*() add to; all are
#     linked whole into zephyr.elf, and all see zephyr_interface's include directories
set(ZEPHYR_BASE ${CMAKE_CURRENT_LIST_DIR})
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_C_FLAGS_INIT @${BOARD_SDK}/compile)
set(CMAKE_CXX_FLAGS_INIT @${BOARD_SDK}/compile)
project(Zephyr-Kernel LANGUAGES C CXX)

# The value after `key:` in a module's module.yml.
function(module_value module key result)
  file(STRINGS ${module}/zephyr/module.yml line REGEX "^ *${key}: ")
  string(REGEX REPLACE "^ *${key}: *" "" value "${line}")
  if(NOT value)
    message(FATAL_ERROR "${module}/zephyr/module.yml has no ${key}")
  endif()
  set(${result} ${value} PARENT_SCOPE)
endfunction()

module_value(${ZEPHYR_EXTRA_MODULES} kconfig module_kconfig)
module_value(${ZEPHYR_EXTRA_MODULES} cmake module_cmake)

# Each CONFIG_ that is on becomes a variable.
execute_process(COMMAND /usr/bin/python3 ${ZEPHYR_BASE}/kconfig.py ${ZEPHYR_EXTRA_MODULES}/${module_kconfig}
    ${CMAKE_SOURCE_DIR}/prj.conf ${CMAKE_BINARY_DIR}/.config
  COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${CMAKE_BINARY_DIR}/.config settings REGEX "^CONFIG_")
foreach(setting IN LISTS settings)
  string(REGEX MATCH "^(CONFIG_[A-Z0-9_]+)=(.*)$" setting "${setting}")
  set(${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
endforeach()

add_library(zephyr_interface INTERFACE)
target_include_directories(zephyr_interface INTERFACE ${ZEPHYR_BASE}/include)
target_compile_options(zephyr_interface INTERFACE -Wall -Wextra
  $<$<COMPILE_LANGUAGE:CXX>:-fno-rtti $<$<BOOL:${CONFIG_STD_CPP17}>:-std=c++17>>)

function(zephyr_include_directories)
  target_include_directories(zephyr_interface INTERFACE ${ARGN})
endfunction()

macro(zephyr_library_named name)
  set(ZEPHYR_CURRENT_LIBRARY ${name})
  add_library(${name} STATIC)
  target_link_libraries(${name} PUBLIC zephyr_interface)
  set_property(GLOBAL APPEND PROPERTY ZEPHYR_LIBS ${name})
endmacro()

function(zephyr_library_sources)
  target_sources(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()

function(zephyr_library_compile_options)
  target_compile_options(${ZEPHYR_CURRENT_LIBRARY} PRIVATE ${ARGN})
endfunction()

add_library(app STATIC)
target_link_libraries(app PUBLIC zephyr_interface)
set_property(GLOBAL APPEND PROPERTY ZEPHYR_LIBS app)
add_subdirectory(${ZEPHYR_EXTRA_MODULES}/${module_cmake} modules/discmc)

get_property(libraries GLOBAL PROPERTY ZEPHYR_LIBS)
add_executable(zephyr.elf ${ZEPHYR_BASE}/uart.c)
target_include_directories(zephyr.elf PRIVATE ${ZEPHYR_BASE}/include)
target_link_options(zephyr.elf PRIVATE @${BOARD_SDK}/link)
target_link_libraries(zephyr.elf PRIVATE -Wl,--whole-archive ${libraries} -Wl,--no-whole-archive
  ${BOARD_SDK}/sdk.o gcc)
