#!/usr/bin/env bash
# Builds the fuzz targets with clang and sanitizers, and runs each for so many seconds, one after the
# other: what makes one fail is kept in build-fuzz/found.
#
#   test/fuzz/run.sh SECONDS [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/../.."

seconds="${1:?how many seconds for each target}"
shift
targets=("$@")
[ "${#targets[@]}" -gt 0 ] || targets=(off obj ply stl glb gltf 3mf vtp vtu gii surf msh off.gz loops_json complexes)

cmake --preset fuzz
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}"
for target in "${targets[@]}"; do
  mkdir -p "build-fuzz/corpus/$target" "build-fuzz/found/$target"
  dictionary=()
  [ -f "test/fuzz/dictionaries/$target.dict" ] && dictionary=("-dict=test/fuzz/dictionaries/$target.dict")
  "build-fuzz/test/fuzz/fuzz_$target" "build-fuzz/corpus/$target" "test/fuzz/corpus/$target" "${dictionary[@]}" \
    "-artifact_prefix=build-fuzz/found/$target/" -max_total_time="$seconds" -timeout=10 \
    -rss_limit_mb=4096 -print_final_stats=1
done
