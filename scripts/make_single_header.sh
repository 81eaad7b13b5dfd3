#!/usr/bin/env bash
# Writes all of the library as one header, to drop into a project: one source file of a program defines
# CGAL_HANDLE_TUNNEL_LOOPS_IMPLEMENTATION before it includes it. It needs CGAL; Reference_tag needs Eigen and
# CGAL_EIGEN3_ENABLED, threads need CGAL_LINKED_WITH_TBB or CGAL_HTL_STD_THREADS. What runs on CUDA devices is left out.
#
#   scripts/make_single_header.sh [FILE]           default: handle_tunnel_loops_single.hpp
set -euo pipefail
exec python3 "$(dirname "$0")/make_single_header.py" "${1:-handle_tunnel_loops_single.hpp}"
