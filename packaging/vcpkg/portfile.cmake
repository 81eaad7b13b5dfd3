# A port for vcpkg, to lie beside others of an overlay: vcpkg install handle-tunnel-loops --overlay-ports=packaging.
vcpkg_download_distfile(archive
  URLS "https://example.org/handle_tunnel_loops/handle-tunnel-loops-${VERSION}-source.tar.gz"
  FILENAME "handle-tunnel-loops-${VERSION}-source.tar.gz"
  SHA512 00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${archive}")

vcpkg_check_features(OUT_FEATURE_OPTIONS features
  FEATURES
    tool HTL_BUILD_TOOL
  INVERTED_FEATURES
    tbb CMAKE_DISABLE_FIND_PACKAGE_TBB)

vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${features} -DHTL_CUDA=OFF -DHTL_PYTHON=OFF
    -DHTL_BUILD_TESTS=OFF -DHTL_BUILD_EXAMPLES=OFF -DHTL_BUILD_BENCHMARKS=OFF
    -DCMAKE_DISABLE_FIND_PACKAGE_Doxygen=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Handle_tunnel_loops CONFIG_PATH lib/cmake/Handle_tunnel_loops)
vcpkg_fixup_pkgconfig()
if("tool" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES htloops AUTO_CLEAN)
endif()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/packaging/NOTICES")
