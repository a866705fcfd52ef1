# discmc as a component of ESP-IDF: CMakeLists.txt includes this before its project(), because
# ESP-IDF first reads a component in script mode, where there is none.
get_filename_component(discmc_lib ${CMAKE_CURRENT_LIST_DIR}/../lib ABSOLUTE)
file(GLOB_RECURSE discmc_sources ${discmc_lib}/discmc/*.cpp)
idf_component_register(SRCS ${discmc_sources} INCLUDE_DIRS ${discmc_lib})
