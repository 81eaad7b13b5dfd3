# Makes meshes, finds their loops, checks them, and goes through what may be wrong.
include("${CMAKE_CURRENT_LIST_DIR}/run_htloops.cmake")

# From a mesh to checked loops, in every format.
foreach(extension IN ITEMS off obj ply stl)
  run(0 generate torus --faces 1000 -o torus.${extension} --quiet)
  expect_equal("${output}${errors}" "")
  run(0 loops torus.${extension} -o torus.json --quiet)
  expect_equal("${output}${errors}" "")
  run(0 check torus.${extension} torus.json)
  expect_match("${output}" "basis of H1")
endforeach()

# What the file of the loops says.
run(0 generate multi-torus --genus 3 --faces 3000 -o mesh.off)
expect_match("${output}" "genus 3")
run(0 loops mesh.off -o loops.json --threads 2 --seed 5
  --lines loops.ply --lines loops.obj --lines loops.vtp --lines loops.polylines.txt)
expect_match("${output}" "genus 3 in 1 component: 3 pairs")
expect_equal("${errors}" "")
file(READ "${FOLDER}/loops.json" loops)
string(JSON format GET "${loops}" format)
expect_equal("${format}" "htloops/1")
string(JSON genus GET "${loops}" mesh genus)
string(JSON pairs LENGTH "${loops}" pairs)
expect_equal("${genus} ${pairs}" "3 3")
string(JSON is_basis GET "${loops}" certificate basis)
expect_equal("${is_basis}" ON)
run(0 check mesh.off loops.json)
foreach(file IN ITEMS loops.ply loops.obj loops.vtp loops.polylines.txt)
  file(SIZE "${FOLDER}/${file}" size)
  expect_match("${size}" "^[0-9][0-9][0-9][0-9]+$")
endforeach()

# The JSON on the standard output is there alone.
run(0 loops mesh.off -o -)
string(JSON format GET "${output}" format)
expect_equal("${format}" "htloops/1")
expect_match("${errors}" "3 pairs")
run(0 loops mesh.off -o - --quiet --no-refine --no-tighten)
expect_equal("${errors}" "")

# No handles, no loops, no error.
run(0 generate sphere --genus 0 --faces 500 -o sphere.off)
run(0 loops sphere.off -o sphere.json)
expect_match("${output}" "no loops")
run(0 check sphere.off sphere.json)

# Answers that are wrong: a place off its edge, a loop in the place of another, another mesh.
string(JSON wrong SET "${loops}" pairs 1 tunnel locations 0 2 1.5)
file(WRITE "${FOLDER}/wrong.json" "${wrong}")
run(1 check mesh.off wrong.json)
expect_match("${errors}" "pair 1, tunnel, position 0: the ratio 1.5")
string(JSON handle GET "${loops}" pairs 0 handle)
string(JSON wrong SET "${loops}" pairs 0 tunnel "${handle}")
file(WRITE "${FOLDER}/wrong.json" "${wrong}")
run(1 check mesh.off wrong.json)
expect_match("${errors}" "fails its certificate")
run(1 check torus.off loops.json)
expect_match("${errors}" "it is about a mesh of")
file(WRITE "${FOLDER}/wrong.json" "{ \"format\": \"htloops/1\" ")
run(3 check mesh.off wrong.json)

# Wrong usage.
run(2)
run(2 loops)
run(2 turn mesh.off)
run(2 loops mesh.off --threads 0)
run(2 loops mesh.off --seed 1000000)
run(2 loops mesh.off --lines loops.txt)
run(2 loops mesh.off -o mesh.off)
run(2 loops mesh.off -o no/such/folder.json)
expect_match("${errors}" "cannot write no/such/folder.json")
run(2 generate torus --genus 2 -o torus.off)
run(2 generate torus -o torus.txt)

# Meshes that cannot be read, or are not what the method takes.
run(3 loops none.off)
file(WRITE "${FOLDER}/bad.off" "OFF\n3 1 0\n0 0 0\n1 0 0\n")
run(3 loops bad.off)
expect_match("${errors}" "only 2 of 3 vertices")
file(WRITE "${FOLDER}/open.off" "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
run(4 loops open.off)
expect_match("${errors}" "3 boundary edges")
run(4 check open.off loops.json)

# A backend is there or it is not.
run("0|5" loops mesh.off --quiet --backend cuda)
run("0|5" loops torus.off --quiet --backend reference)

# Help is no error.
foreach(command IN ITEMS "" loops check generate)
  run(0 ${command} --help)
  expect_match("${output}" "Usage: htloops")
endforeach()
run(0 --version)

file(GLOB unfinished "${FOLDER}/*.part-*")
expect_equal("${unfinished}" "")
