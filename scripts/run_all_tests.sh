#!/usr/bin/env bash
# Installs what is missing, builds everything in build/, warnings being errors, and runs all tests: of each
# property all cases, each header alone, the package in all uses. Then the tests but for those with the label
# "long" with the sanitizers of addresses, undefined behaviour and threads, in folders of their own. That takes
# hours.
#
#   scripts/run_all_tests.sh [CMake option...]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh all
scripts/install_dependencies.sh packages
scripts/build.sh all -DHTL_CUDA=ON -DHTL_BUILD_BENCHMARKS=ON -DHTL_WARNINGS_AS_ERRORS=ON "$@"
ctest --test-dir build --output-on-failure --timeout 3600 --parallel "$(nproc)"
for preset in asan-ubsan tsan; do
  cmake --preset "$preset" "$@"
  cmake --build --preset "$preset" --parallel "$(nproc)"
  ctest --preset "$preset" --timeout 3600 --parallel "$(nproc)"
done
