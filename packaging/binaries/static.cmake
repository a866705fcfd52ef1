# Included after each project(): find_library() finds static libraries alone.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
