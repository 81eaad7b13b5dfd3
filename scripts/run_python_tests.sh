#!/usr/bin/env bash
# Installs what is missing, builds the module of Python and the tool in build/, and runs the tests of
# the module; PYTHONPATH=build/python names it then.
#
#   scripts/run_python_tests.sh [CMake option...]
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh tests
scripts/build.sh htl_python "$@"
scripts/build.sh htloops "$@"
exec ctest --test-dir build --output-on-failure --label-regex '^python$' --no-tests=error
