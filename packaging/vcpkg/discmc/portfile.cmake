# An overlay port: it builds the discmc that it lies in, a checkout or an unpacked release.
#   vcpkg install discmc --overlay-ports=discmc/packaging/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_linkage(ONLY_STATIC_LIBRARY)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DDISCMC_BUILD_COMMAND=OFF
    -DDISCMC_BUILD_EXAMPLES=OFF
    -DDISCMC_BUILD_TESTS=OFF
    -DDISCMC_BUILD_FUZZ=OFF
    -DDISCMC_BUILD_MESH=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/discmc)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
