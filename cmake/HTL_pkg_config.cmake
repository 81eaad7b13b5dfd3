# What pkg-config tells: handle_tunnel_loops is the headers, handle_tunnel_loops-core also links what is compiled
# once. There is no such file of CGAL, so what it needs is told here.

# htl_flags_of(<target> <definitions> <folders> <packages>): as the compiler takes them, what comes from
# libraries that have a file for pkg-config, and what the compiler looks through by itself, aside.
function(htl_flags_of target definitions folders packages)
  set(flags)
  get_target_property(values ${target} INTERFACE_COMPILE_DEFINITIONS)
  foreach(value IN LISTS values)
    if(NOT value MATCHES "[$]<|NOTFOUND")
      string(APPEND flags " -D${value}")
    endif()
  endforeach()
  set(${definitions} "${flags}" PARENT_SCOPE)

  set(flags)
  get_target_property(values ${target} INTERFACE_INCLUDE_DIRECTORIES)
  foreach(value IN LISTS values)
    if(NOT value MATCHES "[$]<|NOTFOUND" AND NOT value IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
      string(APPEND flags " -I\"${value}\"")
    endif()
  endforeach()
  set(${folders} "${flags}" PARENT_SCOPE)

  set(names)
  get_target_property(values ${target} INTERFACE_LINK_LIBRARIES)
  foreach(value IN LISTS values)
    if(value MATCHES "/(lib)?(gmpxx|gmp|mpfr)[.][^/]*$")
      list(APPEND names ${CMAKE_MATCH_2})
    endif()
  endforeach()
  list(JOIN names " " names)
  set(${packages} "${names}" PARENT_SCOPE)
endfunction()

htl_flags_of(CGAL::CGAL HTL_PC_DEFINITIONS HTL_PC_FOLDERS HTL_PC_PACKAGES)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(APPEND HTL_PC_DEFINITIONS " -frounding-math")
endif()
if(HTL_HAS_TBB)
  string(APPEND HTL_PC_DEFINITIONS " -DCGAL_LINKED_WITH_TBB -DNOMINMAX")
  string(APPEND HTL_PC_PACKAGES " tbb")
endif()

# Told from where the file lies, as the prefix may be chosen when the package is installed.
set(HTL_PC_PREFIX "${CMAKE_INSTALL_PREFIX}")
if(NOT IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  file(RELATIVE_PATH HTL_PC_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  string(REGEX REPLACE "/$" "" HTL_PC_PREFIX "\${pcfiledir}/${HTL_PC_PREFIX}")
endif()
cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_LIBDIR BASE_DIRECTORY "\${prefix}" OUTPUT_VARIABLE HTL_PC_LIBDIR)
cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_INCLUDEDIR BASE_DIRECTORY "\${prefix}"
  OUTPUT_VARIABLE HTL_PC_INCLUDEDIR)

set(_htl_pc_files handle_tunnel_loops)
if(HTL_CORE)
  list(APPEND _htl_pc_files handle_tunnel_loops-core)
endif()
foreach(name IN LISTS _htl_pc_files)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/${name}.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/${name}.pc" @ONLY)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/${name}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endforeach()
unset(_htl_pc_files)
