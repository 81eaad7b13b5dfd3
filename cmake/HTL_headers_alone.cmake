# The targets headers_in_any_order, headers_alone_public and headers_alone_internal, built by the tests of
# the same names, not by default. The first includes all public headers in their order, and in reverse: so of
# any two each comes before the other once. The others have one source file per header that includes nothing
# else, so that each header proves to include what it uses: they have the label "long", and headers_alone is both.
file(GLOB_RECURSE _htl_headers
  RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}/include" "${CMAKE_CURRENT_SOURCE_DIR}/include/*.h")
set(_htl_internal_headers ${_htl_headers})
list(FILTER _htl_headers EXCLUDE REGEX "/internal/")
list(FILTER _htl_internal_headers INCLUDE REGEX "/internal/")

# Writes a source file that includes the headers.
function(_htl_write_includes source)
  list(TRANSFORM ARGN REPLACE "(.+)" "#include <\\1>\n" OUTPUT_VARIABLE content)
  list(JOIN content "" content)
  file(GENERATE OUTPUT "${source}" CONTENT "${content}")
endfunction()

function(_htl_add_header_test name)
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${ARGN})
  target_link_libraries(${name} PRIVATE
    Handle_tunnel_loops $<TARGET_NAME_IF_EXISTS:CGAL::Eigen3_support> htl_build_options)
  # What is compiled once has headers of its own: the others need not include these.
  # Templates are only parsed: optimising would cost time and find nothing.
  target_compile_options(${name} PRIVATE $<$<NOT:$<BOOL:${MSVC}>>:-O0;-g0>)
  add_test(NAME ${name}
    COMMAND "${CMAKE_COMMAND}" --build "${CMAKE_BINARY_DIR}" --config $<CONFIG> --target ${name})
  set_tests_properties(${name} PROPERTIES
    LABELS package TIMEOUT 900 RESOURCE_LOCK build_folder)
endfunction()

add_custom_target(headers_alone)
function(_htl_add_headers_alone name)
  set(sources)
  foreach(header IN LISTS ARGN)
    set(source "${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp")
    _htl_write_includes("${source}" ${header})
    list(APPEND sources "${source}")
  endforeach()
  _htl_add_header_test(${name} ${sources})
  set_tests_properties(${name} PROPERTIES LABELS "package;long")
  add_dependencies(headers_alone ${name})
endfunction()

set(_htl_orders "${CMAKE_CURRENT_BINARY_DIR}/headers_in_any_order")
_htl_write_includes("${_htl_orders}/forwards.cpp" ${_htl_headers})
list(REVERSE _htl_headers)
_htl_write_includes("${_htl_orders}/backwards.cpp" ${_htl_headers})
_htl_add_header_test(headers_in_any_order "${_htl_orders}/forwards.cpp" "${_htl_orders}/backwards.cpp")
_htl_add_headers_alone(headers_alone_public ${_htl_headers})
_htl_add_headers_alone(headers_alone_internal ${_htl_internal_headers})
# Programs may include windows.h first.
if(NOT MSVC)
  foreach(_htl_target IN ITEMS headers_in_any_order headers_alone_public)
    target_compile_options(${_htl_target} PRIVATE
      -include "${CMAKE_CURRENT_SOURCE_DIR}/test/Handle_tunnel_loops/include/macros_of_windows.h")
  endforeach()
endif()
# Parsing these again for each of hundreds of headers took more than all else that is compiled. What
# programs include are the public headers, for which nothing is prepared.
target_precompile_headers(headers_alone_internal PRIVATE
  <CGAL/Exact_predicates_inexact_constructions_kernel.h>
  <CGAL/Exact_rational.h>
  <CGAL/Polygon_mesh_processing/refine.h>
  <CGAL/Polygon_mesh_processing/triangulate_hole.h>
  <CGAL/Surface_mesh.h>
  <CGAL/boost/graph/Euler_operations.h>
  <CGAL/boost/graph/helpers.h>
  <CGAL/boost/graph/named_params_helper.h>
  <boost/graph/adjacency_list.hpp>)
unset(_htl_headers)
unset(_htl_internal_headers)
unset(_htl_orders)
