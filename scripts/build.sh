#!/usr/bin/env bash
# Configures the folder build/ in release mode and builds a target there.
#
#   scripts/build.sh TARGET [CMake option...]
set -euo pipefail
cd "$(dirname "$0")/.."

target=$1
shift

# The generator of a folder cannot be changed: ask for Ninja only in a new one.
if [ ! -f build/CMakeCache.txt ] && command -v ninja >/dev/null; then
  set -- -G Ninja "$@"
fi
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release "$@"
cmake --build build --target "$target" --parallel "$(nproc)"
