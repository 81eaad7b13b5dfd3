set(HTLOOPS_SOURCES
  atomic_file.cpp
  backends.cpp
  check_command.cpp
  common_options.cpp
  edge_table.cpp
  events_writer.cpp
  export_lines.cpp
  export_obj.cpp
  export_ply.cpp
  export_polylines.cpp
  export_vtp.cpp
  exported_lines.cpp
  generate_command.cpp
  help_style.cpp
  host_backend.cpp
  input_file.cpp
  interrupt.cpp
  linking_words.cpp
  loops_binding.cpp
  loops_command.cpp
  loops_json_reader.cpp
  loops_json_writer.cpp
  main.cpp
  mesh_builder.cpp
  mesh_reader.cpp
  mesh_writer.cpp
  off_reader.cpp
  output_paths.cpp
  pair_table.cpp
  picture_export.cpp
  ply_guard.cpp
  ply_header.cpp
  progress_bar.cpp
  reeb_answer.cpp
  reeb_command.cpp
  reeb_exports.cpp
  reeb_json_writer.cpp
  reeb_solver.cpp
  self_contact.cpp
  soup_diagnosis.cpp
  soup_reader.cpp
  stl_guard.cpp
  terminal.cpp
  text_cursor.cpp
  text_writer.cpp
  thread_limit.cpp
  values_reader.cpp
  version.cpp)
if(HTL_HAS_EIGEN)
  list(APPEND HTLOOPS_SOURCES reference_backend.cpp)
  set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/backends.cpp" PROPERTIES
    COMPILE_DEFINITIONS HTLOOPS_HAS_REFERENCE)
endif()

if(TARGET Handle_tunnel_loops_cuda)
  list(APPEND HTLOOPS_SOURCES cuda_backend.cpp)
endif()

# Only one file has to be compiled again when the version changes.
set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/version.cpp" PROPERTIES
  COMPILE_DEFINITIONS "HTLOOPS_VERSION=\"${PROJECT_VERSION}\"")
