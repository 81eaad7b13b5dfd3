# The sources of the generators, relative to this folder.
set(HTL_GENERATOR_SOURCES
  Bored_box.cpp
  bars.cpp
  chain.cpp
  closed_tube.cpp
  crosses_itself.cpp
  emptiness.cpp
  foam.cpp
  generators.cpp
  interlaced.cpp
  kinds.cpp
  grid_surface.cpp
  holes.cpp
  gyroid.cpp
  isosurface.cpp
  knot.cpp
  ladder.cpp
  lattice.cpp
  marching_table.cpp
  mesh_of_field.cpp
  multi_torus.cpp
  necks.cpp
  plates.cpp
  random.cpp
  request_checks.cpp
  scan.cpp
  Shape.cpp
  shape_kinds.cpp
  shell.cpp
  smoothing.cpp
  sphere.cpp
  sponge.cpp
  Srs_net.cpp
  torus.cpp
  torus_link.cpp
  waves.cpp)

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
