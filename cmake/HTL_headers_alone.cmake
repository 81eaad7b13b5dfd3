# The target headers_alone: one source file per header that includes nothing else, so that each
# header proves to include what it uses. Built by the test of the same name, not by default.
file(GLOB_RECURSE _htl_headers
  RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}/include" "${CMAKE_CURRENT_SOURCE_DIR}/include/*.h")

set(_htl_sources)
foreach(header IN LISTS _htl_headers)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/headers_alone/${header}.cpp")
  file(GENERATE OUTPUT "${source}" CONTENT "#include <${header}>\n")
  list(APPEND _htl_sources "${source}")
endforeach()

add_library(headers_alone OBJECT EXCLUDE_FROM_ALL ${_htl_sources})
target_link_libraries(headers_alone PRIVATE
  Handle_tunnel_loops $<TARGET_NAME_IF_EXISTS:CGAL::Eigen3_support> htl_build_options)
# Templates are only parsed: optimising would cost time and find nothing.
target_compile_options(headers_alone PRIVATE $<$<NOT:$<BOOL:${MSVC}>>:-O0;-g0>)

add_test(NAME headers_alone
  COMMAND "${CMAKE_COMMAND}" --build "${CMAKE_BINARY_DIR}" --config $<CONFIG>
    --target headers_alone)
set_tests_properties(headers_alone PROPERTIES LABELS package TIMEOUT 600 RESOURCE_LOCK build_folder)
unset(_htl_headers)
unset(_htl_sources)
