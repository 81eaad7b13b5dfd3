# The tests that run the tool itself.
foreach(script IN ITEMS batch_end_to_end check_end_to_end end_to_end files_end_to_end
    measure_end_to_end remove_end_to_end
    repair_end_to_end show_end_to_end skeleton_end_to_end usage_end_to_end)
  add_test(NAME htloops_${script}
    COMMAND "${CMAKE_COMMAND}" "-DHTLOOPS=$<TARGET_FILE:htloops>"
      "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/htloops_${script}"
      -P "${CMAKE_CURRENT_LIST_DIR}/${script}.cmake")
  set_tests_properties(htloops_${script} PROPERTIES LABELS tool TIMEOUT ${HTL_TEST_TIME_LIMIT})
endforeach()

# The meshes of the folder HTL_MESHES (default: shared/meshes beside the checkout), where there is one: a
# twelfth of them, and with the label "long" all.
function(_htl_add_corpus_test name part parts)
  add_test(NAME ${name}
    COMMAND "${CMAKE_COMMAND}" "-DHTLOOPS=$<TARGET_FILE:htloops>"
      "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/${name}" -DPART=${part} -DPARTS=${parts}
      -P "${CMAKE_CURRENT_LIST_DIR}/corpus.cmake")
  set_tests_properties(${name} PROPERTIES
    LABELS "tool;corpus;${ARGN}" TIMEOUT ${HTL_TEST_TIME_LIMIT} SKIP_REGULAR_EXPRESSION "SKIPPED")
endfunction()

_htl_add_corpus_test(htloops_corpus 1 12)
foreach(part RANGE 1 4)
  _htl_add_corpus_test(htloops_corpus_${part}_of_4 ${part} 4 long)
endforeach()
