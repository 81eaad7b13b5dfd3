# Dual cuts, as VTK reads them, the library of ParaView: lines of which each knows its cut and its jump.
include("${CMAKE_CURRENT_LIST_DIR}/run_htloops.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/judges.cmake")

find_judge(python vtk python3 /usr/bin/python3 pvpython)
judge_dual_cuts("${python}" vtu binary.vtu vtp binary.vtp)
