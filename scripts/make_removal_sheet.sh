#!/usr/bin/env bash
# Makes a sheet of 40 meshes before and after all their handles are removed: 20 parts, 10 scans, and 10
# lattices and molecules, of a folder of OFF files and of the generator. OUT.png shows the faces,
# OUT_small.png what is odd at first sight. With --gallery, the twelve of the manual, in at most 500 kB.
# Builds htloops first; needs Python, or PYTHON, with NumPy, SciPy and Pillow.
#
#   scripts/make_removal_sheet.sh FOLDER OUT.png
#   scripts/make_removal_sheet.sh --gallery FOLDER OUT.png
#
# Meshes that FOLDER does not have are named and left out.
set -euo pipefail
cd "$(dirname "$0")/.."

gallery=no
if [ "${1:-}" = --gallery ]; then
  gallery=yes
  shift
fi
if [ $# -ne 2 ]; then
  sed -n 's/^#   //p' "$0" >&2
  exit 2
fi
folder="$1"
output="$2"

# Names of files without .off, or what to generate.
sheet=(
  plate_holes of_flange BracketInches IDGH_42400 thingi_73416 counter_unitsmm gmax15p_bed adns2610
  cranck_cse aqp_bed hinge deckel ADIS16480 chassis_upright hanger extruder_idler
  engine_Adapted03dist gearwheel impeller stratocaster

  fertility_6k botijo_jg rocker-arm happy_buddha_54k dragon_100k elk_vmas chair_vmas seahorse_vmas
  skull_low buddha_lihy

  protein_2jho protein_1CID_27k cgal_cheese magstim_coil
  "generate lattice --genus 12 --faces 20000" "generate gyroid --genus 8 --faces 20000"
  "generate sponge --genus 20" "generate foam --genus 15 --faces 20000"
  "generate plates --genus 20" "generate bores"
)
twelve=(
  of_flange adns2610 extruder_idler gmsh_t13 "generate plates --genus 20"
  "generate bars --genus 20" "generate foam --genus 15 --faces 20000" "generate scan --genus 2"
  "generate mug" "generate coral"
  "generate lattice --genus 12 --faces 20000" "generate sponge --genus 20"
)

scripts/build.sh htloops
made=$(mktemp --directory)
trap 'rm -rf "$made"' EXIT

# found NAME: adds it to the meshes
meshes=()
found() {
  local words mesh="$folder/$1.off"
  read -ra words <<<"$1"
  if [ "${words[0]}" = generate ]; then
    mesh="$made/${words[1]}.off"
    build/bin/htloops "${words[@]}" -q -o "$mesh"
  fi
  if [ -f "$mesh" ]; then
    meshes+=("$mesh")
  else
    echo "There is no $mesh" >&2
  fi
}

# draw OUT [OPTION of the sheet...]
draw() {
  "${PYTHON:-python3}" benchmark/python/removal_sheet.py "${meshes[@]}" -o "$@"
  du -h "$1"
}

if [ "$gallery" = yes ]; then
  for name in "${twelve[@]}"; do found "$name"; done
  draw "$output" --size 260 --columns 4 --colours 192
else
  for name in "${sheet[@]}"; do found "$name"; done
  draw "$output" --size 480 --columns 4
  draw "${output%.png}_small.png" --size 130 --columns 8
fi
