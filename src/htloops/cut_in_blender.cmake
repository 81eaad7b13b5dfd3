# Seams and texture coordinates of meshes that Blender has made, as Blender sees them.
include("${CMAKE_CURRENT_LIST_DIR}/run_htloops.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/judges.cmake")

find_program(BLENDER blender)
if(NOT BLENDER)
  message("SKIPPED: blender is not here")
  return()
endif()
set(blender "${BLENDER}" --background --factory-startup --python-exit-code 1 --python)

judge(${blender} "${CMAKE_CURRENT_LIST_DIR}/make_in_blender.py" -- "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/elsewhere")
foreach(mesh IN ITEMS torus.obj tube.obj cylinder.obj monkey.obj torus.ply)
  run(0 cut ${mesh} --seams elsewhere/seams.py --uv uv.obj)
  expect_match("${output}" "\n[13] charts?: angles off by a factor of [1-9][.0-9]* in the mean")
  judge(${blender} "${CMAKE_CURRENT_LIST_DIR}/judge_in_blender.py" -- ${mesh} elsewhere/seams.py uv.obj)
  expect_match("${output}" "JUDGED ${mesh}: [1-9]")
endforeach()

# The scene is kept if that is asked for. Without the mesh the program says so.
judge(${blender} "${FOLDER}/elsewhere/seams.py" -- "${FOLDER}/out.blend")
expect_match("${output}" "torus: [0-9]+ edges are seams")
if(NOT EXISTS "${FOLDER}/out.blend")
  message(SEND_ERROR "the scene was not kept")
endif()
file(RENAME "${FOLDER}/torus.ply" "${FOLDER}/gone.ply")
execute_process(COMMAND ${blender} "${FOLDER}/elsewhere/seams.py" WORKING_DIRECTORY "${FOLDER}"
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE errors)
expect_equal("${status}" 1)
expect_match("${errors}" "no object is the mesh of ../torus.ply, and .*torus.ply is not there: import it first")
