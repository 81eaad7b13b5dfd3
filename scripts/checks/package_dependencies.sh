#!/usr/bin/env bash
# Prints the CGAL packages that the headers and the library include, directly or not, as in the file
# package_info/Handle_tunnel_loops/dependencies: one per line, sorted, this package among them.
# Each header of CGAL names its package in the URL of its banner.
#
#   scripts/checks/package_dependencies.sh > package_info/Handle_tunnel_loops/dependencies
set -euo pipefail
export LC_ALL=C
cd "$(dirname "$0")/../../include"

{ find CGAL -name '*.h' | sort | sed 's/.*/#include <&>/'; grep -h '^#include <CGAL' ../src/library/*/*.cpp; } |
  "${CXX:-c++}" -std=c++17 -DCGAL_LINKED_WITH_TBB -I. -x c++ -M - |
  tr -s ' \\' '\n' | grep '/CGAL/.*\.h$' |
  xargs sed -n 's|^// \$URL: .*/\([^/]*\)/include/CGAL/.*|\1|p' |
  cat - <(echo Handle_tunnel_loops) | sort -u
