# The target htl_build_options: flags for what this project itself compiles; never for its users. And how long
# a test may take with them.
add_library(htl_build_options INTERFACE)

if(MSVC)
  target_compile_options(htl_build_options INTERFACE /W4 $<$<BOOL:${HTL_WARNINGS_AS_ERRORS}>:/WX>)
else()
  # Without multiply-adds, what is generated and drawn is the same on all machines. The formulas of
  # the headers see to that themselves: users need not say it.
  target_compile_options(htl_build_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -ffp-contract=off
    $<$<BOOL:${HTL_WARNINGS_AS_ERRORS}>:-Werror>
    $<$<BOOL:${HTL_NATIVE}>:-march=native>)
endif()

if(HTL_BUILD_FUZZERS) # coverage, of everything that is linked
  target_compile_options(htl_build_options INTERFACE -fsanitize=fuzzer-no-link)
  target_link_options(htl_build_options INTERFACE -fsanitize=fuzzer-no-link)
  # No fuzzer finds the checksum of a file.
  target_compile_definitions(htl_build_options INTERFACE FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION)
endif()
set(HTL_TEST_TIME_LIMIT 600) # seconds
if(HTL_SANITIZE)
  set(HTL_TEST_TIME_LIMIT 3600)
  target_compile_options(htl_build_options INTERFACE
    -fsanitize=${HTL_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(htl_build_options INTERFACE -fsanitize=${HTL_SANITIZE})
  if(HTL_SANITIZE STREQUAL "thread")
    target_include_directories(htl_build_options BEFORE INTERFACE
      "${CMAKE_CURRENT_SOURCE_DIR}/scripts/checks/tsan")
  endif()
endif()
