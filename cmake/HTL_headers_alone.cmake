# The targets headers_alone_1 and so on: one source file per header that includes nothing else, so
# that each header proves to include what it uses. Built by the tests of the same names, not by
# default; headers_alone is all of them.
file(GLOB_RECURSE _htl_headers
  RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}/include" "${CMAKE_CURRENT_SOURCE_DIR}/include/*.h")

set(_htl_groups 4)
set(_htl_number 0)
foreach(header IN LISTS _htl_headers)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp")
  file(GENERATE OUTPUT "${source}" CONTENT "#include <${header}>\n")
  math(EXPR group "${_htl_number} % ${_htl_groups} + 1")
  list(APPEND _htl_sources_${group} "${source}")
  math(EXPR _htl_number "${_htl_number} + 1")
endforeach()

add_custom_target(headers_alone)
foreach(group RANGE 1 ${_htl_groups})
  set(name headers_alone_${group})
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${_htl_sources_${group}})
  target_link_libraries(${name} PRIVATE
    Handle_tunnel_loops $<TARGET_NAME_IF_EXISTS:CGAL::Eigen3_support> htl_build_options)
  # What is compiled once has headers of its own: the others need not include these.
  target_compile_definitions(${name} PRIVATE CGAL_LINKED_WITH_HTL_CORE)
  # Templates are only parsed: optimising would cost time and find nothing.
  target_compile_options(${name} PRIVATE $<$<NOT:$<BOOL:${MSVC}>>:-O0;-g0>)
  add_dependencies(headers_alone ${name})
  add_test(NAME ${name}
    COMMAND "${CMAKE_COMMAND}" --build "${CMAKE_BINARY_DIR}" --config $<CONFIG> --target ${name})
  set_tests_properties(${name} PROPERTIES
    LABELS package TIMEOUT 600 RESOURCE_LOCK build_folder)
  unset(_htl_sources_${group})
endforeach()
unset(_htl_headers)
unset(_htl_groups)
unset(_htl_number)
