# The first pass over a component, in script mode: cmake -DESP_PLATFORM=1 -DCOMPONENT_DIR=...
# -DOUTPUT=... -P requirements.cmake
macro(idf_component_register)
  cmake_parse_arguments(arg "" "" "SRCS;INCLUDE_DIRS;REQUIRES;PRIV_REQUIRES" ${ARGN})
  set(component_requires ${arg_REQUIRES} ${arg_PRIV_REQUIRES})
  set(component_registered TRUE)
  return()
endmacro()

function(read_component)
  include(${COMPONENT_DIR}/CMakeLists.txt)
  set(component_requires ${component_requires} PARENT_SCOPE)
  set(component_registered ${component_registered} PARENT_SCOPE)
endfunction()

read_component()
if(NOT component_registered)
  message(FATAL_ERROR "${COMPONENT_DIR} did not register")
endif()
file(WRITE ${OUTPUT} "set(component_requires ${component_requires})\n")
