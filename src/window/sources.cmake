# The sources of the pages in which surfaces can be turned, relative to this folder. They need zlib and
# nlohmann-json.
set(HTL_WINDOW_SOURCES
  encoding.cpp
  packing.cpp
  page.cpp)

# htl_embed_page(<output>): the files in page/ as a source. Blanks at the beginning of lines and lines of
# comments are for who reads them here.
function(htl_embed_page output)
  set(folder "${CMAKE_CURRENT_FUNCTION_LIST_DIR}")
  set(scripts "")
  foreach(name IN ITEMS page.html page.css camera.js cells.js decode.js coarse.js openness.js sight.js
      shaders.js lines.js renderer.js viewer.js overlay.js table.js pointers.js filters.js switches.js saving.js
      page.js start.js)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/page/${name}")
    file(READ "${folder}/page/${name}" text)
    string(REGEX REPLACE "\n +" "\n" text "${text}")
    if(name MATCHES "js$")
      string(REGEX REPLACE "(^|\n)(//[^\n]*\n)+" "\\1" text "${text}")
      string(REGEX REPLACE "\n\n+" "\n" text "${text}")
    endif()
    string(REPLACE "." "_" variable "${name}")
    set(${variable} "${text}")
    if(name MATCHES "js$")
      string(APPEND scripts "\n    R\"page(${text})page\",")
    endif()
  endforeach()
  configure_file("${folder}/page_texts.cpp.in" "${output}" @ONLY)
endfunction()
