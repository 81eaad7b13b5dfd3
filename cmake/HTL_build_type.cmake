# Release unless the user says otherwise: an unoptimised build is some ten times slower.
get_property(_htl_is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT _htl_is_multi_config AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
  message(STATUS "Build type: Release, as none was given")
endif()
unset(_htl_is_multi_config)

# A debug build is a choice, not an oversight.
set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
