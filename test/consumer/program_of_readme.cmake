# htl_write_program_of_readme(<file>): the first C++ block of the README of PACKAGE_DIR. Semicolons and brackets
# would upset CMake's lists, so the text is cut by position.
function(htl_write_program_of_readme file)
  file(READ "${PACKAGE_DIR}/README.md" program)
  string(FIND "${program}" "```cpp\n" begin)
  math(EXPR begin "${begin} + 7")
  string(SUBSTRING "${program}" ${begin} -1 program)
  string(FIND "${program}" "```" end)
  string(SUBSTRING "${program}" 0 ${end} program)
  file(WRITE "${file}" "${program}")
endfunction()
