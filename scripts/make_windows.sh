#!/usr/bin/env bash
# Makes htloops.exe for Windows 10 or later, on Linux: one file that needs nothing else.
#
#   scripts/make_windows.sh [FOLDER [CMake option...]]
#
# FOLDER/htloops.exe is written; FOLDER is build/windows if none is named. What it is made in, and of, is
# build/windows-work and build/windows-prefix.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=${1:-build/windows}
shift || true

scripts/install_dependencies.sh windows
toolchain=-DCMAKE_TOOLCHAIN_FILE=$PWD/cmake/mingw_w64.cmake
prefix=$PWD/build/windows-prefix
work=build/windows-work
scripts/make_cross_prefix.sh "$prefix" -G Ninja "$toolchain"
cmake -S . -B "$work" -G Ninja -DHTL_PREFIX="$prefix" -C cmake/tool_alone.cmake "$toolchain" \
  -DCMAKE_CXX_FLAGS=-DCGAL_DISABLE_GMP=1 -DHTL_STATIC=ON -DHTL_THREADS=STD \
  -DHTL_FONT=/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf "$@"
cmake --build "$work" --target htloops --parallel "${JOBS:-$(nproc)}"

# Whatever it would ask Windows for is there in all of them.
lacking=$(x86_64-w64-mingw32-objdump --private-headers "$work/bin/htloops.exe" |
  sed -n 's/.*DLL Name: //p' | grep -viE '^(kernel32|msvcrt|shell32|advapi32|user32|ucrtbase|api-ms-.*)\.dll$' || true)
[ -z "$lacking" ] || { echo "htloops.exe asks for $lacking" >&2 && exit 1; }
mkdir -p "$folder"
x86_64-w64-mingw32-strip --strip-all -o "$folder/htloops.exe" "$work/bin/htloops.exe"
ls -l "$folder/htloops.exe"
