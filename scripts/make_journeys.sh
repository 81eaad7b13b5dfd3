#!/usr/bin/env bash
# Draws the pictures of the README: makes the meshes that the eight journeys begin with, and calls the commands that the
# guides explain. Builds htloops first; needs Python, or PYTHON, with NumPy, SciPy
# and Pillow.
#
#   scripts/make_journeys.sh [FOLDER]
#
# The files stay in FOLDER, if it is given.
set -euo pipefail
cd "$(dirname "$0")/.."

root=$(pwd)
pictures="$root/doc/Handle_tunnel_loops/fig"
python="${PYTHON:-python3}"
"$python" -c 'import numpy, scipy, PIL' || {
  echo "This needs Python with NumPy, SciPy and Pillow" >&2
  exit 1
}
scripts/build.sh htloops
if [ $# -gt 0 ]; then
  folder="$1"
  mkdir -p "$folder"
else
  folder=$(mktemp --directory)
  trap 'rm -rf "$folder"' EXIT
fi
cd "$folder"

htloops() {
  echo "htloops $*"
  "$root/build/bin/htloops" "$@"
}

# draw HOW OUT FILE...
draw() {
  local how="$1" out="$2"
  shift 2
  "$python" "$root/benchmark/python/journey_pictures.py" "$how" "$out" "$@"
}

# look WIDTH MESH OUT.png [OPTION...]: the mesh with its loops
look() {
  "$root/build/bin/htloops" loops "$2" -q --size "$1,330" --picture "$3" "${@:4}"
}

# as_off MESH
as_off() {
  "$root/build/bin/htloops" repair "$1" -q -o "${1%.*}.off"
}

"$python" "$root/benchmark/python/journey_meshes.py" .

# Who prints a scan.
htloops generate scan --genus 2 --holes 5 --hole-faces 150 -o scan.stl
htloops clean scan.stl clean.3mf --noise-below 1%
look 400 scan.stl before.png --view 1,0.2,0.3
look 400 clean.3mf after.png --view 1,0.2,0.3
draw beside "$pictures/journey_scan.png" before.png after.png

# Who makes 3D by AI.
cat >model.txt <<'TEXT'
# a figure on a plinth, with inner walls, leaks and crumbs
faces 240000
blend 0.15
ball 0 0 0 1
ball 0 0 1.25 0.68
rod 0.45 0 1.75 0.55 0 2.3 0.16
rod -0.45 0 1.75 -0.55 0 2.3 0.16
rod 0.85 0 0.35 1.5 0 0.75 0.2
rod -0.85 0 0.35 -1.5 0 0.75 0.2
rod 0.4 0 -0.7 0.45 0 -1.4 0.28
rod -0.4 0 -0.7 -0.45 0 -1.4 0.28
block -1.4 -1 -1.8 1.4 1 -1.5 0.05
blend 0
cut ball 0 0 0 0.84
cut ball 0 0 1.25 0.52
cut rod 0.4 0 1.25 1 0 1.25 0.022
cut rod 0 0 -0.5 0 0 -1.2 0.022
cut rod -0.4 0 1.25 -1 0 1.25 0.022
ball 1.3 0 1.9 0.05
ball -1.1 0 2.2 0.05
ball -1.4 0 -0.6 0.06
ball 0.2 0 0.2 0.12
TEXT
htloops generate shape --text model.txt -o model.glb
htloops clean model.glb solid.stl
as_off model.glb
as_off solid.stl
draw section "$pictures/journey_model.png" model.off solid.off

# Who paints textures.
htloops cut cup.obj --seams seams.py --picture "$pictures/journey_cup.png" --size 400,330

# Who maps a cortex.
htloops generate scan --genus 0 --bridges 8 --tunnels 8 -o lh.orig.nofix
htloops remove lh.orig.nofix --all -o lh.orig --map map.json
"$root/build/bin/htloops" repair lh.orig.nofix -q -o nofix.off
"$root/build/bin/htloops" repair lh.orig -q -o orig.off
draw changed "$pictures/journey_cortex.png" nofix.off orig.off

# Who designs parts.
htloops loops part.stl --csv bores.csv
look 640 part.stl "$pictures/journey_part.png" --labels --view -0.4,-1,1.4

# Who solves fields.
htloops generate multi-torus --genus 2 --faces 6000 -o plate.msh
htloops cut plate.msh --dual cuts.msh
"$root/build/bin/htloops" cut plate.msh -q --dual cuts.json
as_off plate.msh
draw cuts "$pictures/journey_plate.png" plate.off cuts.json

# Who looks at molecules.
cat >molecule.txt <<'TEXT'
# a molecule with channels
faces 60000
blend 1
ball 0 0 0 8.5
times 8 around 0 0 0 0 0 1 ball 8.6 1 0 2.3
times 8 around 0 0 0 0 0 1 ball 6.9 3.6 4.2 2.3
times 8 around 0 0 0 0 0 1 ball 7.1 3.3 -4.2 2.3
times 5 around 0 0 0 0 0 1 ball 3.4 1.7 7.8 2.3
times 5 around 0 0 0 0 0 1 ball 3.5 1.4 -7.8 2.3
blend 0.3
cut pipe 1.7 -14 0 4 -6 0 3 0 0 5 4 0 2 7 0 3 14 0 3
cut pipe 1.2 -13 0 -5 -6 0 -4 -2 0 -6 -1 0 -14
ball -2.5 1.3 4.2 0.9
TEXT
htloops generate shape --text molecule.txt -o molecule.ply
htloops measure molecule.ply --channels channels.pdb
"$root/build/bin/htloops" measure molecule.ply -q --channels channels.csv
as_off molecule.ply
draw channels "$pictures/journey_molecule.png" molecule.off channels.csv

# Who surveys scans.
mkdir -p scans
cp scan.stl part.stl molecule.ply scans
htloops generate mug -o scans/mug.obj
htloops generate sphere -o scans/ball.glb
head --bytes 100000 scan.stl >scans/torn.stl
htloops loops scans --csv table.csv || echo "exit code $?"
thumbs=()
for mesh in scans/*; do
  if look 440 "$mesh" "${mesh##*/}.png" 2>/dev/null; then
    thumbs+=("${mesh##*/}.png")
  fi
done
draw survey "$pictures/journey_scans.png" table.csv "${thumbs[@]}"

du -ch "$pictures"/journey_*.png
