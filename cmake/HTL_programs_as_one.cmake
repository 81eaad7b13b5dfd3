# htl_programs_as_one(<file> <source>...): writes a program that is any of the given ones, each in a namespace with
# its name, after all that they include; so what they share is compiled once. Its first argument names the one.
function(htl_programs_as_one file)
  set(headers)
  set(programs)
  set(names)
  foreach(source IN LISTS ARGN)
    cmake_path(GET source STEM name)
    cmake_path(ABSOLUTE_PATH source)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(READ "${source}" program)
    string(REGEX MATCHALL "#include <[^>]*>\n" included "${program}")
    list(APPEND headers ${included})
    string(REGEX REPLACE "#include <[^>]*>\n" "\n" program "${program}") # the lines keep their numbers
    string(REGEX REPLACE "int main\\(\\)" "int run(int, char*[])" program "${program}")
    string(REPLACE "int main(int argc, char* argv[])" "int run(int argc, char* argv[])" program "${program}")
    string(APPEND programs "namespace ${name} {\n#line 1 \"${source}\"\n${program}\n}\n")
    string(APPEND names "    {\"${name}\", &${name}::run},\n")
  endforeach()
  list(REMOVE_DUPLICATES headers)
  list(JOIN headers "" headers)
  file(CONFIGURE OUTPUT "${file}" CONTENT
"${headers}
#include <string>
#include <utility>

${programs}
#line 1 \"examples\"
int main(int argc, char* argv[]) {
  const std::pair<std::string, int (*)(int, char*[])> programs[] = {
${names}  };
  for(const auto& [name, run] : programs)
    if(argc > 1 && name == argv[1])
      return run(argc - 1, argv + 1);
  return 1;
}
" @ONLY)
endfunction()
