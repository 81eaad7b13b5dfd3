#!/usr/bin/env bash
# Compiles, with other compilers than that of the build, each header by itself, the library, the examples
# and the program of the README; fails if any does not compile without warnings.
#
#   scripts/checks/check_portability.sh [clang|c++20|windows]...
#
# `windows` is the compiler of Debian's g++-mingw-w64-x86-64-posix, with windows.h before all other
# headers; the program of the README is linked too. Without arguments: all compilers that are here.
#
# With another release of CGAL, in the folder DIR: builds headers, examples and tests, and runs them;
# or only the tests and examples that are named.
#
#   scripts/checks/check_portability.sh cgal DIR [TARGET...]
#
# JOBS in the environment is the number of jobs, that of the processors if it is not set.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
work=$root/build-portability
jobs=${JOBS:-$(nproc)}

# One source file per header that includes nothing else, those of the library, the examples, and the first C++ program of
# the README.
write_sources() {
  local header source
  rm -rf "$work/sources"
  mkdir -p "$work/sources"
  (cd include && find CGAL -name '*.h' | sort) | while read -r header; do
    echo "#include <$header>" >"$work/sources/header-${header//\//-}.cpp"
  done
  for source in src/library/*/*.cpp; do cp "$source" "$work/sources/library-${source##*/}"; done
  cp examples/Handle_tunnel_loops/*.cpp "$work/sources"
  awk '/^```/ { if(inside) exit; inside = /^```cpp$/; next } inside' README.md \
    >"$work/sources/README.cpp"
}

# compile_all NAME COMMAND... : COMMAND is given one source file at a time.
compile_all() {
  local name=$1 log=$work/$1.log
  shift
  echo "$name: $* FILE"
  if printf '%s\0' "$work"/sources/*.cpp |
    xargs -0 --max-args 1 --max-procs "$jobs" "$@" >"$log" 2>&1; then
    echo "$name: all $(find "$work/sources" -name '*.cpp' | wc -l) files compile"
  else
    cat "$log"
    echo "$name: some do not compile: see $log" >&2
    return 1
  fi
}

flags=(-fsyntax-only -Wall -Wextra -Wpedantic -Werror -I "$root/include")
here=(-isystem /usr/include/eigen3 -DCGAL_LINKED_WITH_TBB -DCGAL_EIGEN3_ENABLED)

check_clang() { compile_all clang clang++ -std=c++17 "${flags[@]}" "${here[@]}"; }

check_cxx20() { compile_all c++20 g++ -std=c++20 "${flags[@]}" "${here[@]}"; }

check_windows() {
  # CGAL, Boost and Eigen without the C library of this system.
  mkdir -p "$work/headers"
  ln -sfn /usr/include/CGAL "$work/headers/CGAL"
  ln -sfn /usr/include/boost "$work/headers/boost"
  ln -sfn /usr/include/eigen3/Eigen "$work/headers/Eigen"
  # The macros of windows.h are there on purpose: min, max, near, far, small ...
  local -a compiler=(x86_64-w64-mingw32-g++-posix -std=c++17 -isystem "$work/headers"
    -DCGAL_DISABLE_GMP=1 -DCGAL_EIGEN3_ENABLED -include windows.h)
  compile_all windows "${compiler[@]}" "${flags[@]}" &&
    "${compiler[@]}" -O1 -I "$root/include" "$work"/sources/{README,library-*}.cpp -o "$work/README.exe"
}

check_cgal() {
  local dir=$1 build=$work/cgal target
  shift
  cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release "-DCGAL_DIR=$(cd "$dir" && pwd)" -DHTL_CUDA=OFF \
    -DHTL_BUILD_BENCHMARKS=OFF -DHTL_WARNINGS_AS_ERRORS=ON
  cmake --build "$build" --parallel "$jobs" --target headers_alone "${@:-all}"
  if [ "$#" -eq 0 ]; then
    ctest --test-dir "$build" --output-on-failure --timeout 600 --parallel "$jobs" --label-exclude '^long$'
  else
    for target; do
      ctest --test-dir "$build" --output-on-failure --timeout 600 --tests-regex "^$target\$" \
        --no-tests=error
    done
  fi
}

if [ "${1:-}" = cgal ]; then
  [ "$#" -ge 2 ] || { echo "usage: $0 cgal DIR [TARGET...]" >&2; exit 2; }
  mkdir -p "$work"
  check_cgal "${@:2}"
  exit
fi

is_here() { command -v "$1" >/dev/null; }
if [ "$#" -eq 0 ]; then
  ! is_here clang++ || set -- "$@" clang
  ! is_here g++ || set -- "$@" c++20
  ! is_here x86_64-w64-mingw32-g++-posix || set -- "$@" windows
fi
write_sources
failed=0
for name; do
  case "$name" in
    clang) check_clang || failed=1 ;;
    c++20) check_cxx20 || failed=1 ;;
    windows) check_windows || failed=1 ;;
    *)
      echo "usage: $0 [clang|c++20|windows]...   or   $0 cgal DIR [TARGET...]" >&2
      exit 2
      ;;
  esac
done
exit "$failed"
