# When a wheel is laid out: copies what _htl_program and _htl_module need into lib/ of _htl_package, but for what every
# system that has Python has.
if(CMAKE_HOST_WIN32)
  return() # delvewheel does it, as only a compiler's command line knows where libraries are
endif()
file(GET_RUNTIME_DEPENDENCIES
  EXECUTABLES "${_htl_program}" MODULES "${_htl_module}"
  RESOLVED_DEPENDENCIES_VAR found
  UNRESOLVED_DEPENDENCIES_VAR missing
  PRE_EXCLUDE_REGEXES "^lib(c|m|dl|rt|pthread|stdc[+][+]|gcc_s)[.]so" "^ld-linux" "libpython" "Python[.]framework"
  POST_EXCLUDE_REGEXES "^/usr/lib/lib[^/]*[.]dylib$" "^/System/")
if(missing)
  message(FATAL_ERROR "Libraries that the wheel needs were not found: ${missing}")
endif()
file(MAKE_DIRECTORY "${_htl_package}/lib")
foreach(library IN LISTS found)
  cmake_path(GET library FILENAME name)
  message(STATUS "Carried along: ${library}")
  file(REAL_PATH "${library}" file) # a wheel has no links
  file(COPY_FILE "${file}" "${_htl_package}/lib/${name}" ONLY_IF_DIFFERENT)
endforeach()
