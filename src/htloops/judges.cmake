# For tests in which another program judges what the tool has written. Without it they are skipped.

# find_judge(<variable> <module> <program>...): one of some Pythons that has a module.
macro(find_judge variable module)
  foreach(name IN ITEMS ${ARGN})
    find_program(_python "${name}" NO_CACHE)
    if(_python)
      execute_process(COMMAND "${_python}" -c "import ${module}" RESULT_VARIABLE _status
        OUTPUT_QUIET ERROR_QUIET)
      if(_status EQUAL 0)
        set(${variable} "${_python}")
        break()
      endif()
    endif()
    unset(_python)
  endforeach()
  if(NOT ${variable})
    message("SKIPPED: no Python here has the module ${module}")
    return()
  endif()
endmacro()

# judge(<argument>...): runs a judge in FOLDER, who must be content; sets `output`.
function(judge)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE status
    OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(SEND_ERROR "${command}\nended with ${status}\n${out}${err}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

# judge_dual_cuts(<python> <ending>...) of a plate with handles and holes, and of a closed surface.
function(judge_dual_cuts python)
  run(0 generate multi-torus --genus 2 --faces 2000 --holes 4 -o plate.off)
  run(0 generate multi-torus --genus 3 --faces 3000 -o closed.off)
  foreach(mesh IN ITEMS plate closed)
    run(0 loops ${mesh}.off -o loops.json --quiet)
    foreach(ending IN LISTS ARGN)
      run(0 cut ${mesh}.off --dual cuts.${ending} --quiet)
      judge("${python}" "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/judge_dual_cuts.py" cuts.${ending} loops.json)
      expect_match("${output}" "cuts: each crosses its own loop once, and no other")
    endforeach()
  endforeach()
endfunction()
