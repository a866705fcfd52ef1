# discmc_set_firmware_flags(TARGET): compiles a target for small flash, whatever the build type, and
# discmc, too, if the project builds it. An executable also drops what it does not use.
function(discmc_set_firmware_flags target)
  set(targets ${target})
  if(TARGET discmc)
    list(APPEND targets discmc)
  endif()
  foreach(each IN LISTS targets)
    target_compile_options(${each} PRIVATE -Os -ffunction-sections -fdata-sections
      $<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions> $<$<COMPILE_LANGUAGE:CXX>:-fno-rtti>)
  endforeach()
  target_link_options(${target} PRIVATE LINKER:--gc-sections)
endfunction()
