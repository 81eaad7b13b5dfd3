#!/usr/bin/env bash
set -euo pipefail
cmake -S . -B build -G Ninja ${CMAKE_ARGS} \
  -DPython_EXECUTABLE="$PYTHON" -DHTL_PYTHON_DIR="${SP_DIR#"$PREFIX"/}" -DHTL_CUDA=OFF \
  -DHTL_BUILD_TESTS=OFF -DHTL_BUILD_EXAMPLES=OFF -DHTL_BUILD_BENCHMARKS=OFF
cmake --build build --parallel "$CPU_COUNT"
cmake --install build
