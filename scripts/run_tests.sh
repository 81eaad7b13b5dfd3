#!/usr/bin/env bash
# Installs what is missing, builds everything in build/ and runs the tests; the last lines are the
# summary of ctest.
#
#   scripts/run_tests.sh [CMake option...]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh tests
scripts/build.sh all -DHTL_CUDA=ON "$@" # the sample does without
exec ctest --test-dir build --output-on-failure --timeout 600 --parallel "$(nproc)"
