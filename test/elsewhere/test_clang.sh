#!/usr/bin/env bash
# The tool as another compiler makes it, with another standard library and without GMP, has the answers of that of
# this build: none is owed to how a library sorts what is equal, or to the order in which a compiler evaluates.
#
#   test_clang.sh HTLOOPS FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
native=$1
folder=$2
compiler=$(command -v clang++ || command -v clang++-14 || true)
echo '#include <vector>' | "${compiler:-false}" -stdlib=libc++ -x c++ -fsyntax-only - 2>/dev/null || {
  echo "There is no clang++ with libc++ (libc++-dev, libc++abi-dev)"
  exit 77
}

toolchain=("-DCMAKE_CXX_COMPILER=$compiler" "-DCMAKE_C_COMPILER=${compiler/++/}")
"$here/../../scripts/make_cross_prefix.sh" "$folder/prefix" "${toolchain[@]}" -DCMAKE_CXX_FLAGS=-stdlib=libc++
cmake -S "$here/../.." -B "$folder/build" -DHTL_PREFIX="$folder/prefix" -C "$here/../../cmake/tool_alone.cmake" \
  "${toolchain[@]}" "-DCMAKE_CXX_FLAGS=-stdlib=libc++ -DCGAL_DISABLE_GMP=1" -DHTL_THREADS=STD
cmake --build "$folder/build" --target htloops --parallel "${JOBS:-$(nproc)}"
/usr/bin/python3 "$here/same_answers.py" "$native" "$folder/answers" "$folder/build/bin/htloops"
