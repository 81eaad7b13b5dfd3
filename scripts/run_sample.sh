#!/usr/bin/env bash
# Installs what is missing, builds htloops in build/ and runs it on a sample mesh: the table of the
# loops goes to the terminal; the mesh, the loops, a picture and a page to turn them in to the folder
# sample/.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_dependencies.sh tool
scripts/build.sh htloops

htloops=build/bin/htloops
picture=()
if "$htloops" loops --help | grep -- --picture >/dev/null; then # grep -q would break the pipe
  picture=(--picture sample/loops.png)
fi

mkdir -p sample
"$htloops" generate multi-torus --genus 3 --faces 20000 -o sample/mesh.off
"$htloops" loops sample/mesh.off -o sample/loops.json --lines sample/loops.obj \
  --html sample/loops.html "${picture[@]}"
echo "Written to sample/: $(ls -m sample)"
echo "Open sample/loops.html in a browser to turn the mesh and to choose among its loops."
