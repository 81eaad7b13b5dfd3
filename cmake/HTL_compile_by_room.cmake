# The files of a folder compiled as one: what they include is read once, and templates are made once for
# all of them, which is most of what a build from nothing takes. A group of files that share much may
# be named beforehand, by the property UNITY_GROUP.
function(htl_compile_by_room target)
  if(NOT HTL_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  foreach(file IN LISTS ARGN)
    get_source_file_property(group "${file}" UNITY_GROUP)
    if(NOT group)
      get_filename_component(group "${file}" DIRECTORY)
      string(MAKE_C_IDENTIFIER "${group}" group)
      set_source_files_properties("${file}" PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
endfunction()
