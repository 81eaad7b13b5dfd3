# The sources of the generators, relative to this folder.
set(HTL_GENERATOR_SOURCES
  closed_tubes.cpp
  generators.cpp
  grids.cpp
  holes.cpp
  hubs.cpp
  implicit_surfaces.cpp
  isosurface.cpp
  mesh_of_field.cpp
  necks.cpp
  plates.cpp
  random.cpp
  scan.cpp
  Shape.cpp
  sphere.cpp
  tubes.cpp)

# htl_embed_shapes(<output>): the texts in shapes/ as a source.
function(htl_embed_shapes output)
  set(folder "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/shapes")
  set(shape_entries "")
  foreach(name IN ITEMS bicycle bores borromean cage chair coral exchanger mug trefoil)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${folder}/${name}.txt")
    file(READ "${folder}/${name}.txt" text)
    string(APPEND shape_entries "    {\"${name}\", R\"shape(${text})shape\"},\n")
  endforeach()
  configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/shape_texts.cpp.in" "${output}" @ONLY)
endfunction()
