#!/usr/bin/env bash
# The tool built without threads says so where they are asked for, and has the answers of that of this build.
#
#   test_without_threads.sh HTLOOPS FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
native=$1
folder=$2

cmake -S "$here/../.." -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -DHTL_THREADS=NONE -DHTL_CUDA=OFF \
  -DHTL_PYTHON=OFF -DHTL_BUILD_TESTS=OFF -DHTL_BUILD_EXAMPLES=OFF -DHTL_BUILD_BENCHMARKS=OFF
cmake --build "$folder/build" --target htloops --parallel "${JOBS:-$(nproc)}"
without=$folder/build/bin/htloops
[[ "$("$without" --version)" == *", without threads" ]]
cmake "-DHTLOOPS=$without" "-DFOLDER=$folder/usage" -P "$here/../../src/htloops/usage_end_to_end.cmake"
/usr/bin/python3 "$here/same_answers.py" "$native" "$folder/answers" "$without"
