# What takes longest comes first, so that no processor waits at the end: what makes the templates of the
# library.
set(HTLOOPS_APP_SOURCES
  solve/backends.cpp
  solve/boundaries.cpp
  solve/certification.cpp
  solve/cut_solver.cpp
  solve/details.cpp
  solve/host_backend.cpp
  solve/reeb_solver.cpp
  solve/skeleton_solver.cpp
  solve/throat_solver.cpp
  solve/removal_solver.cpp)
if(HTL_HAS_EIGEN)
  list(APPEND HTLOOPS_APP_SOURCES solve/reference_backend.cpp)
endif()
if(TARGET Handle_tunnel_loops_cuda)
  list(APPEND HTLOOPS_APP_SOURCES solve/cuda_backend.cpp)
endif()
list(APPEND HTLOOPS_APP_SOURCES
  solve/changeable_mesh.cpp
  version.cpp
  interrupt.cpp
  draw/gltf.cpp
  draw/layers.cpp
  draw/lines.cpp
  draw/meshes.cpp
  draw/pages.cpp
  draw/pictures.cpp
  draw/skeletons.cpp
  draw/surfaces.cpp
  draw/tints.cpp
  draw/view.cpp
  mend/Change_log.cpp
  mend/comparison.cpp
  mend/face_dropping.cpp
  mend/face_gluing.cpp
  mend/mending.cpp
  mend/mesh_reader.cpp
  mend/point_welding.cpp
  mend/triangulation.cpp
  mend/vertex_splitting.cpp
  read/input_file.cpp
  read/loops_reader.cpp
  read/obj_reader.cpp
  read/off_reader.cpp
  read/ply_reader.cpp
  read/skeleton_reader.cpp
  read/soup.cpp
  read/soup_diagnosis.cpp
  read/sources.cpp
  read/stl_reader.cpp
  read/vertex_data.cpp
  write/documents.cpp
  write/dual_formats.cpp
  write/files.cpp
  write/rows.cpp
  write/mesh_writer.cpp
  write/msh_writer.cpp
  write/pair_listing.cpp
  write/skeleton_formats.cpp
  write/tables.cpp
  write/throat_tables.cpp)

# Only one file has to be compiled again when the version changes.
set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/version.cpp" PROPERTIES
  COMPILE_DEFINITIONS "HTLOOPS_VERSION=\"${PROJECT_VERSION}\"")
