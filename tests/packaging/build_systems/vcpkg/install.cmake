# A stand-in for `vcpkg install`.
#   cmake -DPORT_DIR=... -DROOT=... -P install.cmake
# Runs the portfile in script mode with the variables in vcpkg's documentation. Implements the helpers and the checks
# after a build, and installs to ROOT/installed/TRIPLET. Both configurations are compiled with -O0, to save time.
cmake_minimum_required(VERSION 3.21)

file(READ ${PORT_DIR}/vcpkg.json manifest)
string(JSON PORT GET ${manifest} name)
set(TARGET_TRIPLET x64-linux)
set(VCPKG_LIBRARY_LINKAGE dynamic)
set(CURRENT_PORT_DIR ${PORT_DIR})
set(CURRENT_BUILDTREES_DIR ${ROOT}/buildtrees/${PORT})
set(CURRENT_PACKAGES_DIR ${ROOT}/packages/${PORT}_${TARGET_TRIPLET})
set(CURRENT_INSTALLED_DIR ${ROOT}/installed/${TARGET_TRIPLET})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# A helper exists if the manifest depends on the port that provides it.
function(needs port)
  string(JSON count LENGTH ${manifest} dependencies)
  math(EXPR last "${count} - 1")
  foreach(i RANGE ${last})
    string(JSON name GET ${manifest} dependencies ${i} name)
    string(JSON host GET ${manifest} dependencies ${i} host)
    if(name STREQUAL port AND host)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "vcpkg.json does not depend on ${port}")
endfunction()

macro(vcpkg_check_linkage kind)
  if("${kind}" STREQUAL "ONLY_STATIC_LIBRARY")
    set(VCPKG_LIBRARY_LINKAGE static)
  endif()
endmacro()

function(vcpkg_cmake_configure)
  needs(vcpkg-cmake)
  cmake_parse_arguments(arg "" "SOURCE_PATH" "OPTIONS;MAYBE_UNUSED_VARIABLES" ${ARGN})
  string(COMPARE EQUAL ${VCPKG_LIBRARY_LINKAGE} dynamic shared)
  foreach(build IN ITEMS dbg:Debug:/debug rel:Release:)
    string(REGEX MATCH "(.*):(.*):(.*)" build ${build})
    set(prefix ${CURRENT_PACKAGES_DIR}${CMAKE_MATCH_3})
    run(${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -G Ninja
      -B ${CURRENT_BUILDTREES_DIR}/${TARGET_TRIPLET}-${CMAKE_MATCH_1}
      -DCMAKE_BUILD_TYPE=${CMAKE_MATCH_2} -DCMAKE_INSTALL_PREFIX=${prefix}
      -DBUILD_SHARED_LIBS=${shared} -DCMAKE_INSTALL_LIBDIR:STRING=lib
      -DCMAKE_CXX_FLAGS_RELEASE=-O0 ${arg_OPTIONS})
  endforeach()
endfunction()

function(vcpkg_cmake_install)
  foreach(build IN ITEMS dbg rel)
    run(${CMAKE_COMMAND} --build ${CURRENT_BUILDTREES_DIR}/${TARGET_TRIPLET}-${build} --target install
      --parallel 2)
  endforeach()
endfunction()

# Moves the config files to share/, with the targets of the debug build beside them. Corrects the
# prefix that they compute from their folder.
function(vcpkg_cmake_config_fixup)
  needs(vcpkg-cmake-config)
  cmake_parse_arguments(arg "" "PACKAGE_NAME;CONFIG_PATH" "" ${ARGN})
  set(share ${CURRENT_PACKAGES_DIR}/share/${PORT})
  set(debug ${CURRENT_PACKAGES_DIR}/debug/${arg_CONFIG_PATH})
  file(GLOB configs ${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}/*)
  file(COPY ${configs} DESTINATION ${share})
  file(GLOB targets ${debug}/*-debug.cmake)
  foreach(file IN LISTS targets)
    file(READ ${file} text)
    string(REPLACE "\${_IMPORT_PREFIX}" "\${_IMPORT_PREFIX}/debug" text "${text}")
    get_filename_component(name ${file} NAME)
    file(WRITE ${share}/${name} "${text}")
  endforeach()
  file(GLOB targets ${share}/*-targets.cmake)
  foreach(file IN LISTS targets)
    file(READ ${file} text)
    set(up "get_filename_component(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\" PATH)")
    string(REGEX REPLACE "get_filename_component\\(_IMPORT_PREFIX[^\n]*\n" "" text "${text}")
    string(REPLACE "# Compute the installation prefix relative to this file.\n"
      "${up}\nget_filename_component(_IMPORT_PREFIX \"\${_IMPORT_PREFIX}/../..\" ABSOLUTE)\n"
      text "${text}")
    file(WRITE ${file} "${text}")
  endforeach()
  foreach(folder IN ITEMS ${CURRENT_PACKAGES_DIR} ${CURRENT_PACKAGES_DIR}/debug)
    get_filename_component(parent ${folder}/${arg_CONFIG_PATH} DIRECTORY)
    file(REMOVE_RECURSE ${parent})
  endforeach()
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(arg "" "" "FILE_LIST" ${ARGN})
  file(INSTALL ${arg_FILE_LIST} DESTINATION ${CURRENT_PACKAGES_DIR}/share/${PORT} RENAME copyright)
endfunction()

function(vcpkg_fixup_pkgconfig)
  foreach(folder IN ITEMS lib debug/lib)
    if(NOT EXISTS ${CURRENT_PACKAGES_DIR}/${folder}/pkgconfig)
      message(FATAL_ERROR "no pkg-config files in ${folder}")
    endif()
  endforeach()
endfunction()

include(${PORT_DIR}/portfile.cmake)

# The checks of vcpkg after a build.
foreach(file IN ITEMS include share/${PORT}/copyright share/${PORT}/${PORT}-config.cmake share/${PORT}/usage)
  if(NOT EXISTS ${CURRENT_PACKAGES_DIR}/${file})
    message(FATAL_ERROR "${PORT} has installed no ${file}")
  endif()
endforeach()
foreach(folder IN ITEMS debug/include debug/share lib/cmake debug/lib/cmake bin)
  if(EXISTS ${CURRENT_PACKAGES_DIR}/${folder})
    message(FATAL_ERROR "${PORT} has installed ${folder}")
  endif()
endforeach()
file(GLOB release ${CURRENT_PACKAGES_DIR}/lib/*.a)
file(GLOB debug ${CURRENT_PACKAGES_DIR}/debug/lib/*.a)
list(LENGTH release releases)
list(LENGTH debug debugs)
if(NOT releases EQUAL debugs OR releases EQUAL 0)
  message(FATAL_ERROR "${releases} libraries in lib, ${debugs} in debug/lib")
endif()
file(GLOB_RECURSE texts ${CURRENT_PACKAGES_DIR}/share/*.cmake)
foreach(file IN LISTS texts)
  file(READ ${file} text)
  string(FIND "${text}" ${ROOT} place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "${file} remembers where it was built")
  endif()
endforeach()

file(MAKE_DIRECTORY ${CURRENT_INSTALLED_DIR})
file(COPY ${CURRENT_PACKAGES_DIR}/ DESTINATION ${CURRENT_INSTALLED_DIR})
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR})
