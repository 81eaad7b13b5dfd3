# The tests that run the tool itself.
foreach(script IN ITEMS end_to_end files_end_to_end remove_end_to_end
    repair_end_to_end show_end_to_end)
  add_test(NAME htloops_${script}
    COMMAND "${CMAKE_COMMAND}" "-DHTLOOPS=$<TARGET_FILE:htloops>"
      "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/htloops_${script}"
      -P "${CMAKE_CURRENT_LIST_DIR}/${script}.cmake")
  set_tests_properties(htloops_${script} PROPERTIES LABELS tool TIMEOUT 300)
endforeach()

# All meshes of the folder HTL_MESHES (default: shared/meshes beside the checkout), where there is one.
set(_htl_parts 4)
foreach(part RANGE 1 ${_htl_parts})
  set(name htloops_corpus_${part}_of_${_htl_parts})
  add_test(NAME ${name}
    COMMAND "${CMAKE_COMMAND}" "-DHTLOOPS=$<TARGET_FILE:htloops>"
      "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/${name}" -DPART=${part} -DPARTS=${_htl_parts}
      -P "${CMAKE_CURRENT_LIST_DIR}/corpus.cmake")
  set_tests_properties(${name} PROPERTIES
    LABELS "tool;corpus" TIMEOUT 300 SKIP_REGULAR_EXPRESSION "SKIPPED")
endforeach()
unset(_htl_parts)
