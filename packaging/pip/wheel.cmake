# The layout of a wheel: the tool lies in the package of Python, and beside both what they need and not every
# system has.
set(_htl_package "\${HTL_PYTHON_DIR}/handle_tunnel_loops")
if(APPLE)
  set(_htl_here "@loader_path")
else()
  set(_htl_here "$ORIGIN")
endif()
set_target_properties(htl_python PROPERTIES INSTALL_RPATH "${_htl_here}/lib")
set_target_properties(htloops PROPERTIES INSTALL_RPATH "${_htl_here}/../lib")
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  # What one carried library needs of another is looked for there, too; and MPFR, which CGAL names, is used by nothing.
  foreach(target IN ITEMS htl_python htloops)
    target_link_options(${target} PRIVATE -Wl,--disable-new-dtags -Wl,--as-needed)
  endforeach()
endif()

install(TARGETS htloops RUNTIME DESTINATION "${_htl_package}/bin" COMPONENT python)
install(CODE "set(_htl_package \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${_htl_package}\")
set(_htl_program \"\${_htl_package}/bin/$<TARGET_FILE_NAME:htloops>\")
set(_htl_module \"\${_htl_package}/$<TARGET_FILE_NAME:htl_python>\")" COMPONENT python)
install(SCRIPT "${CMAKE_CURRENT_LIST_DIR}/carry_libraries.cmake" COMPONENT python)
unset(_htl_package)
unset(_htl_here)
