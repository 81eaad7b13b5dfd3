#!/usr/bin/env bash
# Configures the folder build/ in release mode and builds a target there.
#
#   scripts/build.sh TARGET [CMake option...]
#
# As many jobs at a time as there are processors, or as the memory that is available is enough for.
set -euo pipefail
cd "$(dirname "$0")/.."

target=$1
shift

# The generator of a folder cannot be changed: ask for Ninja only in a new one.
if [ ! -f build/CMakeCache.txt ] && command -v ninja >/dev/null; then
  set -- -G Ninja "$@"
fi
# ... and nothing for devices where there is none, unless that is asked for.
if [ ! -f build/CMakeCache.txt ] && [ ! -e /dev/nvidiactl ] && [ ! -e /dev/dxg ]; then
  set -- -DHTL_CUDA=OFF "$@"
fi
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release "$@"
jobs=$(nproc)
if [ -r /proc/meminfo ]; then
  # The largest jobs take 1.6 GB.
  fitting=$(awk '/^MemAvailable:/ { print int($2 / 1600000) }' /proc/meminfo)
  if [ -n "$fitting" ] && [ "$fitting" -lt "$jobs" ]; then
    jobs=$((fitting > 1 ? fitting : 1))
  fi
fi
cmake --build build --target "$target" --parallel "$jobs"
