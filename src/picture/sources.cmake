# The sources of the pictures, relative to this folder. They need libpng.
set(HTL_PICTURE_SOURCES
  Camera.cpp
  Font.cpp
  Painter.cpp
  Text_layer.cpp
  annotations.cpp
  cut_away.cpp
  encode_png.cpp
  layers.cpp
  picture.cpp
  shading.cpp)

# htl_embed_font(<output>): a font as a source.
function(htl_embed_font output)
  file(READ "${HTL_FONT}" bytes HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/font_data.cpp.in" "${output}" @ONLY)
endfunction()
