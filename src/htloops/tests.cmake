# The tests that run the tool itself.
add_test(NAME htloops_end_to_end
  COMMAND "${CMAKE_COMMAND}" "-DHTLOOPS=$<TARGET_FILE:htloops>"
    "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/htloops_end_to_end"
    -P "${CMAKE_CURRENT_LIST_DIR}/end_to_end.cmake")
set_tests_properties(htloops_end_to_end PROPERTIES LABELS tool)

# All meshes of the folder HTL_MESHES (default: shared/meshes beside the checkout), where there is one.
add_test(NAME htloops_corpus
  COMMAND "${CMAKE_COMMAND}" "-DHTLOOPS=$<TARGET_FILE:htloops>"
    "-DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/htloops_corpus"
    -P "${CMAKE_CURRENT_LIST_DIR}/corpus.cmake")
set_tests_properties(htloops_corpus PROPERTIES
  LABELS "tool;corpus"
  TIMEOUT 3000
  SKIP_REGULAR_EXPRESSION "SKIPPED")
