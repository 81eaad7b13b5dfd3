#!/usr/bin/env bash
# Installs what is missing, builds in build/ everything but the benchmarks, and what needs a compiler for CUDA
# where there is one, and runs the tests but for those with the label "long"; the last lines are the summary
# of ctest. What scripts/run_sample.sh has compiled is not compiled again.
#
#   scripts/run_tests.sh [CMake option...]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh tests
scripts/build.sh all -DHTL_CUDA=ON -DHTL_BUILD_BENCHMARKS=OFF "$@"
exec ctest --test-dir build --output-on-failure --timeout 600 --parallel "$(nproc)" \
  --label-exclude '^long$'
