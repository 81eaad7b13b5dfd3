# Finds what the package needs (CGAL) and what it can use. A missing optional library costs its
# feature and one status line. Sets HTL_HAS_<NAME> for each optional library.

# Asked for a version, CGAL accepts only its own major one; so the version is checked here. It
# reports every step even when asked to be quiet.
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
find_package(CGAL QUIET)
unset(CMAKE_MESSAGE_LOG_LEVEL)
if(NOT CGAL_FOUND)
  message(FATAL_ERROR "CGAL was not found; on Debian: apt-get install libcgal-dev")
endif()
if(CGAL_VERSION VERSION_LESS 5.5)
  message(FATAL_ERROR "CGAL ${CGAL_VERSION} was found, 5.5 or later is needed")
endif()
message(STATUS "CGAL: ${CGAL_VERSION}")

# htl_find_optional(<NAME> <package> <what is lost without it>)
# A macro, because CGAL's support files read the variables that find_package() sets.
macro(htl_find_optional name package loss)
  find_package(${package} QUIET)
  set(HTL_HAS_${name} ${${package}_FOUND})
  if(NOT HTL_HAS_${name})
    message(STATUS "${package} not found: ${loss}")
  endif()
endmacro()

htl_find_optional(TBB TBB "everything runs in one thread")
if(HTL_HAS_TBB)
  include(CGAL_TBB_support)
  # A project that includes this one sees the targets only if they are global.
  set_target_properties(TBB::tbb TBB::tbbmalloc CGAL::TBB_support Threads::Threads
    PROPERTIES IMPORTED_GLOBAL TRUE)
endif()

if(HTL_BUILD_TOOL OR HTL_BUILD_TESTS)
  htl_find_optional(EIGEN Eigen3 "the reference solver is neither tested nor in htloops")
endif()
if(HTL_HAS_EIGEN)
  include(CGAL_Eigen3_support)
endif()
if(HTL_BUILD_TOOL)
  htl_find_optional(CLI11 CLI11 "the tool htloops is not built")
  htl_find_optional(JSON nlohmann_json "the tool htloops is not built")
  htl_find_optional(PNG PNG "htloops writes no pictures")
endif()
if(HTL_BUILD_TESTS)
  htl_find_optional(GTEST GTest "the unit tests are not built")
endif()
if(HTL_BUILD_BENCHMARKS)
  htl_find_optional(BENCHMARK benchmark "the benchmark of the stages is not built")
endif()
if(PROJECT_IS_TOP_LEVEL)
  htl_find_optional(DOXYGEN Doxygen "the reference manual is not built")
endif()
