cmake_minimum_required(VERSION 3.21)

# For the scripts that test the tool, which run with cmake -P and so need no shell. They are given
# HTLOOPS, the tool, and FOLDER, where they may write.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

# _run(<exit code> <argument of execute_process> <argument of the tool>...)
function(_run expected input)
  execute_process(${input} COMMAND "${HTLOOPS}" ${ARGN} WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code MATCHES "^(${expected})$")
    list(JOIN ARGN " " command)
    message(SEND_ERROR "htloops ${command}\nended with ${code} instead of ${expected}\n${out}${err}")
  endif()
  set(output "${out}" PARENT_SCOPE)
  set(errors "${err}" PARENT_SCOPE)
endfunction()

# run(<exit code> <argument>...) runs the tool in FOLDER and sets `output` and `errors`. More than
# one exit code may be acceptable: "0|5".
macro(run expected)
  _run("${expected}" "" ${ARGN})
endmacro()

# run_piped(<exit code> <file> <argument>...): the same, with a file coming through a pipe.
macro(run_piped expected file)
  _run("${expected}" "COMMAND;${CMAKE_COMMAND};-E;cat;${file}" ${ARGN})
endmacro()

# Each complains unless the text is what it should be.
function(expect_equal text expected)
  if(NOT "${text}" STREQUAL "${expected}")
    message(SEND_ERROR "expected: ${expected}\nfound: ${text}")
  endif()
endfunction()

function(expect_match text expression)
  if(NOT "${text}" MATCHES "${expression}")
    message(SEND_ERROR "expected: ${expression}\nfound: ${text}")
  endif()
endfunction()
