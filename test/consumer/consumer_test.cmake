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
  set(libraries core)

  if(USES STREQUAL "all")
    # The headers alone, in a folder of the user's choice.
    set(prefix "${WORK_DIR}/prefix_of_headers")
    run("${CMAKE_COMMAND}" -S "${PACKAGE_DIR}" -B "${WORK_DIR}/build_of_headers" -G "${GENERATOR}"
      "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" -DCMAKE_INSTALL_INCLUDEDIR=include/chosen
      -DHTL_BUILD_TOOL=OFF -DHTL_BUILD_TESTS=OFF -DHTL_BUILD_EXAMPLES=OFF -DHTL_BUILD_BENCHMARKS=OFF
      -DHTL_CORE=OFF -DHTL_CUDA=OFF)
    run("${CMAKE_COMMAND}" --install "${WORK_DIR}/build_of_headers" --prefix "${prefix}")
    set(headers -B "${WORK_DIR}/build_with_headers" "-DCMAKE_PREFIX_PATH=${prefix}")
    run(${configure} ${headers})

    fails_with("the package was built without CUDA" ${headers} -DCOMPONENTS=CUDA)
    fails_with("the component CORE was not installed" ${headers} -DCOMPONENTS=CORE)
    fails_with("there is no component Cuda, only TBB, CUDA and CORE" ${headers} -DCOMPONENTS=Cuda)
    fails_with("TBB, which was not found"
      ${headers} -DCOMPONENTS=TBB -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON)
  endif()
else()
  set(where "-DHANDLE_TUNNEL_LOOPS_DIR=${PACKAGE_DIR}")
  set(libraries Handle_tunnel_loops)
  if(USES STREQUAL "few") # all headers without what is compiled once take a minute
    file(WRITE "${WORK_DIR}/main.cpp" "#include <CGAL/Handle_tunnel_loops/exceptions.h>\n"
      "int main() { return CGAL::Handle_tunnel_loops::Interrupted_exception().what()[0] == '\\0' ? 1 : 0; }\n")
  endif()
endif()

set(all_found_before "CGAL TBB Threads" "")
if(USES STREQUAL "all")
  list(PREPEND all_found_before "CGAL TBB" "CGAL Threads" "TBB Threads" CGAL TBB Threads)
  set(libraries Handle_tunnel_loops core)
endif()
# The project may have found any of the libraries before; the last one, nothing.
foreach(found_before IN LISTS all_found_before)
  run(${configure} -B "${WORK_DIR}/build" ${where} "-DFOUND_BEFORE=${found_before}")
endforeach()
foreach(library IN LISTS libraries)
  run(${configure} -B "${WORK_DIR}/build" ${where} -DLIBRARY=${library})
  run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config ${CONFIG} --target run_consumer)
endforeach()
