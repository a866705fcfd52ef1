# Readers whose libraries are slow to start are in modules, which the command loads when it first needs
# them (first_use.cpp). Other programs link these readers as they link the rest of a library.
set(modules_folder ${CMAKE_CURRENT_LIST_DIR})

# discmc_in_module(library NAME READER function LIBRARIES libraries... [INCLUDE folders...] SOURCES files...)
# adds files to a library, and makes a module of the same objects.
function(discmc_in_module library name)
  cmake_parse_arguments(PARSE_ARGV 2 with "" "READER" "LIBRARIES;INCLUDE;SOURCES")
  string(TOLOWER discmc_${name} module)
  add_library(${module}_objects OBJECT ${with_SOURCES})
  set_target_properties(${module}_objects PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
  foreach(property IN ITEMS COMPILE_DEFINITIONS COMPILE_FEATURES INCLUDE_DIRECTORIES LINK_LIBRARIES)
    set_property(TARGET ${module}_objects PROPERTY ${property} $<TARGET_PROPERTY:${library},${property}>)
  endforeach()
  target_include_directories(${module}_objects SYSTEM PRIVATE ${with_INCLUDE})
  target_sources(${library} PRIVATE $<TARGET_OBJECTS:${module}_objects>)
  target_link_libraries(${library} PRIVATE ${with_LIBRARIES})

  # What is neither in the objects nor in the libraries is in the program.
  add_library(${module} MODULE EXCLUDE_FROM_ALL ${modules_folder}/entry.cpp $<TARGET_OBJECTS:${module}_objects>)
  set_target_properties(${module} PROPERTIES
    PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/modules)
  target_compile_definitions(${module} PRIVATE DISCMC_MODULE=${module} DISCMC_READER=${with_READER})
  target_include_directories(${module} PRIVATE $<TARGET_PROPERTY:${library},INCLUDE_DIRECTORIES>)
  target_link_libraries(${module} PRIVATE ${with_LIBRARIES})
  set_property(GLOBAL APPEND PROPERTY DISCMC_MODULES ${name})
endfunction()

# The program loads modules, and links their readers only if it is static.
function(discmc_load_modules program)
  if(CMAKE_EXE_LINKER_FLAGS MATCHES "(^| )-static( |$)")
    return()
  endif()
  file(RELATIVE_PATH folder ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/discmc)
  set_target_properties(${program} PROPERTIES
    ENABLE_EXPORTS ON BUILD_RPATH "$ORIGIN/modules" INSTALL_RPATH "$ORIGIN/${folder}")
  target_sources(${program} PRIVATE ${modules_folder}/first_use.cpp)
  target_link_libraries(${program} PRIVATE ${CMAKE_DL_LIBS})
  target_link_options(${program} PRIVATE LINKER:--as-needed)
  get_property(names GLOBAL PROPERTY DISCMC_MODULES)
  foreach(name IN LISTS names)
    string(TOLOWER discmc_${name} module)
    set_property(SOURCE ${modules_folder}/first_use.cpp APPEND PROPERTY
      COMPILE_DEFINITIONS DISCMC_MODULE_${name}="${module}")
    add_dependencies(${program} ${module})
    install(TARGETS ${module}
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/discmc COMPONENT discmc_command)
  endforeach()
endfunction()
