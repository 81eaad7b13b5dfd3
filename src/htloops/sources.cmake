set(HTLOOPS_SOURCES
  main.cpp
  version.cpp
  commands/box_option.cpp
  commands/check_command.cpp
  commands/command_line.cpp
  commands/common_options.cpp
  commands/cut_command.cpp
  commands/file_options.cpp
  commands/generate_command.cpp
  commands/help_commands.cpp
  commands/help_style.cpp
  commands/length_option.cpp
  commands/listing_choice.cpp
  commands/loops_command.cpp
  commands/loops_file.cpp
  commands/loops_options.cpp
  commands/man_page.cpp
  commands/many_meshes.cpp
  commands/mesh_options.cpp
  commands/outcome.cpp
  commands/reeb_command.cpp
  commands/remove_command.cpp
  commands/shell_completion.cpp
  commands/usage_message.cpp
  draw/arc_surface.cpp
  draw/cut_exports.cpp
  draw/export_gltf.cpp
  draw/export_lines.cpp
  draw/export_vtp.cpp
  draw/exported_lines.cpp
  draw/loops_page.cpp
  draw/mesh_arrays.cpp
  draw/page_export.cpp
  draw/picture_export.cpp
  draw/reeb_exports.cpp
  draw/reeb_page.cpp
  draw/removal_page.cpp
  draw/tube.cpp
  draw/view.cpp
  mend/duplicate_faces.cpp
  mend/edge_division.cpp
  mend/face_dropping.cpp
  mend/face_gluing.cpp
  mend/face_pieces.cpp
  mend/faces_around_edge.cpp
  mend/mending.cpp
  mend/mesh_reader.cpp
  mend/point_welding.cpp
  mend/polygon_triangulation.cpp
  mend/remedy_words.cpp
  mend/soup_triangulation.cpp
  mend/vertex_splitting.cpp
  read/binary_source.cpp
  read/edge_table.cpp
  read/input_file.cpp
  read/loops_binding.cpp
  read/loops_json_reader.cpp
  read/mesh_builder.cpp
  read/obj_lines.cpp
  read/obj_reader.cpp
  read/off_header.cpp
  read/off_reader.cpp
  read/ply_header.cpp
  read/ply_numbers.cpp
  read/ply_reader.cpp
  read/point_merger.cpp
  read/soup_diagnosis.cpp
  read/soup_reader.cpp
  read/stl_reader.cpp
  read/text_cursor.cpp
  read/text_source.cpp
  read/unread_data.cpp
  read/values_reader.cpp
  read/vertex_properties_reader.cpp
  solve/backends.cpp
  solve/boundaries.cpp
  solve/certification.cpp
  solve/cut_solver.cpp
  solve/dual_cut_solver.cpp
  solve/face_arcs.cpp
  solve/host_backend.cpp
  solve/reeb_answer.cpp
  solve/reeb_solver.cpp
  solve/removal_solver.cpp
  solve/self_contact.cpp
  solve/spread_properties.cpp
  solve/thread_limit.cpp
  terminal/interrupt.cpp
  terminal/progress_bar.cpp
  terminal/terminal.cpp
  write/arc_table.cpp
  write/atomic_file.cpp
  write/change_table.cpp
  write/dual_cuts_json_writer.cpp
  write/events_writer.cpp
  write/linking_words.cpp
  write/loops_json_writer.cpp
  write/mesh_lines.cpp
  write/mesh_writer.cpp
  write/pair_csv.cpp
  write/pair_listing.cpp
  write/pair_table.cpp
  write/reeb_json_writer.cpp
  write/removal_json_writer.cpp
  write/removal_table.cpp
  write/text_writer.cpp)
if(HTL_HAS_EIGEN)
  list(APPEND HTLOOPS_SOURCES solve/reference_backend.cpp)
endif()

if(TARGET Handle_tunnel_loops_cuda)
  list(APPEND HTLOOPS_SOURCES solve/cuda_backend.cpp)
endif()

# What the library makes for one backend it makes for most others, too.
set(_htloops_backends ${HTLOOPS_SOURCES})
list(FILTER _htloops_backends INCLUDE REGEX "solve/(.*backends?|certification)\\.cpp")
list(TRANSFORM _htloops_backends PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
set_source_files_properties(${_htloops_backends} PROPERTIES UNITY_GROUP backends)

# Only one file has to be compiled again when the version changes.
set_source_files_properties("${CMAKE_CURRENT_LIST_DIR}/version.cpp" PROPERTIES
  COMPILE_DEFINITIONS "HTLOOPS_VERSION=\"${PROJECT_VERSION}\"")
