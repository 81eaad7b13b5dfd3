# What takes longest comes first, so that no processor waits at the end: what makes the templates of the
# library.
set(HTLOOPS_APP_SOURCES
  solve/backends.cpp
  solve/boundaries.cpp
  solve/certification.cpp
  solve/channels.cpp
  solve/cut_solver.cpp
  solve/details.cpp
  solve/host_backend.cpp
  solve/reeb_solver.cpp
  solve/skeleton_solver.cpp
  solve/throat_solver.cpp
  solve/removal_solver.cpp
  clean/copies.cpp
  clean/crossings.cpp
  clean/fates.cpp
  clean/handle_steps.cpp
  clean/holes.cpp
  clean/parts.cpp
  clean/soup_cleaning.cpp
  clean/cleaning.cpp)
if(HTL_HAS_EIGEN)
  list(APPEND HTLOOPS_APP_SOURCES solve/reference_backend.cpp)
endif()
if(TARGET Handle_tunnel_loops_cuda)
  list(APPEND HTLOOPS_APP_SOURCES solve/cuda_backend.cpp)
endif()
list(APPEND HTLOOPS_APP_SOURCES
  solve/changeable_mesh.cpp
  version.cpp
  file_names.cpp
  interrupt.cpp
  numbers.cpp
  check/claims.cpp
  check/document_comparison.cpp
  draw/gltf.cpp
  draw/layers.cpp
  draw/lines.cpp
  draw/meshes.cpp
  draw/pages.cpp
  draw/pictures.cpp
  draw/samples.cpp
  draw/scenes.cpp
  draw/seen_lines.cpp
  draw/skeletons.cpp
  draw/spread_lines.cpp
  draw/surfaces.cpp
  draw/tints.cpp
  draw/upright.cpp
  draw/view.cpp
  mend/Change_log.cpp
  mend/comparison.cpp
  mend/face_dropping.cpp
  mend/face_gluing.cpp
  mend/mending.cpp
  mend/mesh_reader.cpp
  mend/near_points.cpp
  mend/point_welding.cpp
  mend/triangulation.cpp
  mend/vertex_splitting.cpp
  read/Vtk_document.cpp
  read/Zip_content.cpp
  read/input_file.cpp
  read/json_errors.cpp
  read/loops_reader.cpp
  read/mesh_list.cpp
  read/patterns.cpp
  read/skeleton_reader.cpp
  read/soup.cpp
  read/soup_diagnosis.cpp
  read/sources.cpp
  read/unpacking.cpp
  read/vertex_data.cpp
  read/xml.cpp
  read/meshes/freesurfer_reader.cpp
  read/meshes/gifti_reader.cpp
  read/meshes/mesh_formats.cpp
  read/meshes/msh_reader.cpp
  read/meshes/obj_reader.cpp
  read/meshes/off_reader.cpp
  read/meshes/ply_reader.cpp
  read/meshes/stl_reader.cpp
  read/meshes/vtk_reader.cpp
  system/console.cpp
  system/files.cpp
  system/memory.cpp
  write/Gltf_document.cpp
  write/Zip_archive.cpp
  write/channel_formats.cpp
  write/clean_report.cpp
  write/documents.cpp
  write/dual_formats.cpp
  write/files.cpp
  write/growing_file.cpp
  write/line_files.cpp
  write/rows.cpp
  write/mesh_writer.cpp
  write/pair_listing.cpp
  write/seam_script.cpp
  write/skeleton_formats.cpp
  write/tables.cpp
  write/throat_tables.cpp
  write/meshes/freesurfer_writer.cpp
  write/meshes/gifti_writer.cpp
  write/meshes/glb_writer.cpp
  write/meshes/msh_writer.cpp
  write/meshes/single_precision.cpp
  write/meshes/stl_writer.cpp
  write/meshes/text_writers.cpp
  write/meshes/three_mf_writer.cpp
  write/meshes/vtk_writers.cpp)

# What wants a library that may be missing.
if(HTL_HAS_GLTF)
  list(APPEND HTLOOPS_APP_SOURCES read/meshes/gltf_reader.cpp)
endif()
if(HTL_HAS_EXPAT)
  list(APPEND HTLOOPS_APP_SOURCES read/meshes/three_mf_reader.cpp)
endif()

# The headers of systems have macros that others would stumble over.
set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/system/console.cpp"
  "${CMAKE_CURRENT_LIST_DIR}/system/memory.cpp" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# Only one file has to be compiled again when the version changes.
set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/version.cpp" PROPERTIES
  COMPILE_DEFINITIONS "HTLOOPS_VERSION=\"${PROJECT_VERSION}\"")
