#!/usr/bin/env bash
# Installs what is missing, builds htloops in build/ and runs it on a sample mesh: the table of the
# loops goes to the terminal; the mesh, the loops and a picture of them to the folder sample/.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh tool
scripts/build.sh htloops

htloops=build/bin/htloops
picture=()
if "$htloops" loops --help | grep -q -- --picture; then
  picture=(--picture sample/loops.png)
fi

mkdir -p sample
"$htloops" generate multi-torus --genus 3 --faces 20000 -o sample/mesh.off
"$htloops" loops sample/mesh.off -o sample/loops.json --lines sample/loops.obj "${picture[@]}"
echo "Written to sample/: $(ls -m sample)"
