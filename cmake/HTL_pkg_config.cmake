# What pkg-config tells. There is no such file of CGAL, so what it needs is told here.

# What of a property is told in plain words.
function(htl_plain_values variable target property)
  get_target_property(values ${target} ${property})
  list(FILTER values EXCLUDE REGEX "[$]<|NOTFOUND")
  set(${variable} "${values}" PARENT_SCOPE)
endfunction()

function(htl_definitions_of target variable)
  htl_plain_values(values ${target} INTERFACE_COMPILE_DEFINITIONS)
  list(TRANSFORM values PREPEND " -D")
  string(JOIN "" flags ${values})
  set(${variable} "${flags}" PARENT_SCOPE)
endfunction()

# Those that the compiler does not look through by itself.
function(htl_folders_of target variable)
  htl_plain_values(values ${target} INTERFACE_INCLUDE_DIRECTORIES)
  list(REMOVE_ITEM values ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES})
  list(TRANSFORM values REPLACE "(.+)" " -I\"\\1\"")
  string(JOIN "" flags ${values})
  set(${variable} "${flags}" PARENT_SCOPE)
endfunction()

# Libraries that have a file for pkg-config themselves.
function(htl_packages_of target variable)
  htl_plain_values(values ${target} INTERFACE_LINK_LIBRARIES)
  set(names)
  foreach(value IN LISTS values)
    if(value MATCHES "/(lib)?(gmpxx|gmp|mpfr)[.][^/]*$")
      list(APPEND names ${CMAKE_MATCH_2})
    endif()
  endforeach()
  string(JOIN " " names ${names})
  set(${variable} "${names}" PARENT_SCOPE)
endfunction()

htl_definitions_of(CGAL::CGAL HTL_PC_DEFINITIONS)
htl_folders_of(CGAL::CGAL HTL_PC_FOLDERS)
htl_packages_of(CGAL::CGAL HTL_PC_PACKAGES)
htl_definitions_of(Handle_tunnel_loops _htl_own)
string(APPEND HTL_PC_DEFINITIONS "${_htl_own}")
htl_plain_values(HTL_PC_LINK_OPTIONS Handle_tunnel_loops INTERFACE_LINK_OPTIONS)
string(JOIN " " HTL_PC_LINK_OPTIONS ${HTL_PC_LINK_OPTIONS})
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

configure_file(cmake/handle_tunnel_loops.pc.in handle_tunnel_loops.pc @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/handle_tunnel_loops.pc"
  DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
unset(_htl_own)
