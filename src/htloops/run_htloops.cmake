cmake_minimum_required(VERSION 3.21)

# For the scripts that test the tool, which run with cmake -P and so need no shell. They are given
# HTLOOPS, the tool, and FOLDER, where they may write.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

# run(<exit code> <argument>...) runs the tool in FOLDER and sets `output` and `errors`. More than
# one exit code may be acceptable: "0|5".
function(run expected)
  execute_process(COMMAND "${HTLOOPS}" ${ARGN} WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code MATCHES "^(${expected})$")
    list(JOIN ARGN " " command)
    message(SEND_ERROR "htloops ${command}\nended with ${code} instead of ${expected}\n${out}${err}")
  endif()
  set(output "${out}" PARENT_SCOPE)
  set(errors "${err}" PARENT_SCOPE)
endfunction()

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
