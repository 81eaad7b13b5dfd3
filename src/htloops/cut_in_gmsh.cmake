# Dual cuts, as Gmsh reads them: physical groups of which each crosses its own loop once.
include("${CMAKE_CURRENT_LIST_DIR}/run_htloops.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/judges.cmake")

find_judge(python gmsh python3 /usr/bin/python3)
judge_dual_cuts("${python}" msh msh2 msh22)
