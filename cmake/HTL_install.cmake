# Install rules: the library, the tool, its manual, and what find_package(Handle_tunnel_loops) reads.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(_htl_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Handle_tunnel_loops")

install(DIRECTORY include/CGAL DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.h")
if(TARGET htloops)
  install(TARGETS htloops RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
  install(FILES "${CMAKE_BINARY_DIR}/share/htloops.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" OPTIONAL)
  install(FILES "${CMAKE_BINARY_DIR}/share/htloops"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" OPTIONAL)
  install(FILES "${CMAKE_BINARY_DIR}/share/htloops.fish"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" OPTIONAL)
  install(FILES "${CMAKE_BINARY_DIR}/share/_htloops"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" OPTIONAL)
endif()
install(FILES LICENSE README.md CHANGES.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES packaging/NOTICES CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY examples/Handle_tunnel_loops/ DESTINATION "${CMAKE_INSTALL_DOCDIR}/examples" COMPONENT doc)
install(DIRECTORY doc/Handle_tunnel_loops/schemas DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT doc)
install(DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/doc/html" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT doc OPTIONAL) # where Doxygen is

install(TARGETS Handle_tunnel_loops EXPORT Handle_tunnel_loopsTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT Handle_tunnel_loopsTargets
  NAMESPACE Handle_tunnel_loops:: DESTINATION "${_htl_config_dir}")

if(TARGET Handle_tunnel_loops_cuda)
  set_target_properties(Handle_tunnel_loops_cuda PROPERTIES EXPORT_NAME cuda)
  install(TARGETS Handle_tunnel_loops_cuda htl_device htl_cuda EXPORT Handle_tunnel_loopsCudaTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
  install(EXPORT Handle_tunnel_loopsCudaTargets
    NAMESPACE Handle_tunnel_loops:: DESTINATION "${_htl_config_dir}")
endif()

configure_package_config_file(cmake/Handle_tunnel_loopsConfig.cmake.in
  Handle_tunnel_loopsConfig.cmake INSTALL_DESTINATION "${_htl_config_dir}")
write_basic_package_version_file(Handle_tunnel_loopsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/Handle_tunnel_loopsConfig.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/Handle_tunnel_loopsConfigVersion.cmake"
  DESTINATION "${_htl_config_dir}")
include(HTL_pkg_config)
unset(_htl_config_dir)
