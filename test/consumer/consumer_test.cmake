# Configures, builds and runs the consumer project in WORK_DIR; USE says how it finds the package.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${WORK_DIR}")

# The first C++ block of the README. Semicolons and brackets would upset CMake's lists, so the
# text is cut by position.
file(READ "${PACKAGE_DIR}/README.md" program)
string(FIND "${program}" "```cpp\n" begin)
math(EXPR begin "${begin} + 7")
string(SUBSTRING "${program}" ${begin} -1 program)
string(FIND "${program}" "```" end)
string(SUBSTRING "${program}" 0 ${end} program)
file(WRITE "${WORK_DIR}/main.cpp" "${program}")

if(USE STREQUAL "find_package")
  set(prefix "${WORK_DIR}/prefix")
  run("${CMAKE_COMMAND}" --install "${PACKAGE_BUILD_DIR}" --prefix "${prefix}" --config ${CONFIG})
  set(where "-DCMAKE_PREFIX_PATH=${prefix}")
else()
  set(where "-DHANDLE_TUNNEL_LOOPS_DIR=${PACKAGE_DIR}")
endif()

run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/project" -B "${WORK_DIR}/build"
  -G "${GENERATOR}" -DCMAKE_BUILD_TYPE=${CONFIG} "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" ${where}
  "-DPROGRAM=${WORK_DIR}/main.cpp"
  "-DMESH=${PACKAGE_DIR}/examples/Handle_tunnel_loops/data/triple_torus.off")
run("${CMAKE_COMMAND}" --build "${WORK_DIR}/build" --config ${CONFIG} --target run_consumer)
