# Configures, builds and runs the consumer project in WORK_DIR; USE says how it finds the package, and
# USES whether that is tried once or in all ways.
include("${CMAKE_CURRENT_LIST_DIR}/program_of_readme.cmake")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")

htl_write_program_of_readme("${WORK_DIR}/main.cpp")

set(configure "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/project"
  -G "${GENERATOR}" -DCMAKE_BUILD_TYPE=${CONFIG} "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DPROGRAM=${WORK_DIR}/main.cpp"
  "-DMESH=${PACKAGE_DIR}/examples/Handle_tunnel_loops/data/triple_torus.off")

# Configuring fails, and what it prints contains all the words in their order.
function(fails_with words)
  execute_process(COMMAND ${configure} ${ARGN}
    COMMAND_ECHO STDOUT RESULT_VARIABLE result OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  # CMake breaks lines where it likes.
  string(REGEX REPLACE "[ \n]+" " " printed "${printed}")
  string(FIND "${printed}" "${words}" position)
  if(result EQUAL 0 OR position EQUAL -1)
    message(FATAL_ERROR "Expected \"${words}\" and an error (${result}), not:\n${printed}")
  endif()
endfunction()

if(USES STREQUAL "few") # it is about what is found: nothing is to be fast
  list(APPEND configure "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG")
endif()

if(USE STREQUAL "find_package")
  set(prefix "${WORK_DIR}/prefix")
  run("${CMAKE_COMMAND}" --install "${PACKAGE_BUILD_DIR}" --prefix "${prefix}" --config ${CONFIG})
  set(where "-DCMAKE_PREFIX_PATH=${prefix}")

  if(USES STREQUAL "all")
    # Without TBB, with the headers in a folder of the user's choice.
    set(prefix "${WORK_DIR}/prefix_without_TBB")
    run("${CMAKE_COMMAND}" -S "${PACKAGE_DIR}" -B "${WORK_DIR}/build_without_TBB" -G "${GENERATOR}"
      "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG"
      -DCMAKE_INSTALL_INCLUDEDIR=include/chosen -DHTL_THREADS=STD
      -DHTL_BUILD_TOOL=OFF -DHTL_BUILD_TESTS=OFF -DHTL_BUILD_EXAMPLES=OFF -DHTL_BUILD_BENCHMARKS=OFF
      -DHTL_CUDA=OFF)
    run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build_without_TBB" --config ${CONFIG})
    run("${CMAKE_COMMAND}" --install "${WORK_DIR}/build_without_TBB" --prefix "${prefix}" --config ${CONFIG})
    set(without -B "${WORK_DIR}/build_with_std_threads" "-DCMAKE_PREFIX_PATH=${prefix}")
    run(${configure} ${without})

    fails_with("the package was built without CUDA" ${without} -DCOMPONENTS=CUDA)
    fails_with("the package was built without TBB" ${without} -DCOMPONENTS=TBB)
    fails_with("there is no component Cuda, only TBB and CUDA" ${without} -DCOMPONENTS=Cuda)
  endif()
else()
  set(where "-DHANDLE_TUNNEL_LOOPS_DIR=${PACKAGE_DIR}")
endif()

set(all_found_before "CGAL TBB Threads" "")
if(USES STREQUAL "all")
  list(PREPEND all_found_before "CGAL TBB" "CGAL Threads" "TBB Threads" CGAL TBB Threads)
endif()
# The project may have found any of the libraries before; the last one, nothing.
foreach(found_before IN LISTS all_found_before)
  run(${configure} -B "${WORK_DIR}/build" ${where} "-DFOUND_BEFORE=${found_before}")
endforeach()
if(USE STREQUAL "find_package" OR USES STREQUAL "all") # else all of the library would be compiled for this
  run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config ${CONFIG} --target run_consumer)
endif()
