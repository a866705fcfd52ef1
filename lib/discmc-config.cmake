# The library has no dependency to look for, so its target is the whole package.
include(${CMAKE_CURRENT_LIST_DIR}/discmc-targets.cmake)

# It is written in C++ but needs nothing of C++'s run-time library: who links it may speak any
# language, and a program in C is linked as C.
get_target_property(discmc_configurations discmc::discmc IMPORTED_CONFIGURATIONS)
foreach(discmc_configuration IN LISTS discmc_configurations)
  set_property(TARGET discmc::discmc PROPERTY
    IMPORTED_LINK_INTERFACE_LANGUAGES_${discmc_configuration} "")
endforeach()
unset(discmc_configurations)
unset(discmc_configuration)
