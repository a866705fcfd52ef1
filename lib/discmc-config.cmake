# The library has no dependency to look for.
include(${CMAKE_CURRENT_LIST_DIR}/discmc-targets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/discmc-firmware.cmake)

# It is written in C++ but needs nothing of C++'s run-time library. A program in any language links it, and a program in
# C is linked as C.
get_target_property(discmc_configurations discmc::discmc IMPORTED_CONFIGURATIONS)
foreach(discmc_configuration IN LISTS discmc_configurations)
  set_property(TARGET discmc::discmc PROPERTY
    IMPORTED_LINK_INTERFACE_LANGUAGES_${discmc_configuration} "")
endforeach()
unset(discmc_configurations)
unset(discmc_configuration)

# The mesh library, discmc::mesh, if it was installed: find_package(discmc COMPONENTS mesh) requires it.
set(discmc_mesh_FOUND FALSE)
include(${CMAKE_CURRENT_LIST_DIR}/discmc-mesh.cmake OPTIONAL)
foreach(discmc_component IN LISTS discmc_FIND_COMPONENTS)
  if(discmc_FIND_REQUIRED_${discmc_component} AND NOT discmc_${discmc_component}_FOUND)
    set(discmc_FOUND FALSE)
    if(NOT discmc_NOT_FOUND_MESSAGE)
      set(discmc_NOT_FOUND_MESSAGE "component ${discmc_component} is not installed; there is: mesh")
    endif()
  endif()
endforeach()
unset(discmc_component)
