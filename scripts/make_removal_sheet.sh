#!/usr/bin/env bash
# Makes a sheet of 40 meshes before and after all their handles are removed: parts, scans, lattices and
# molecules, from a folder of meshes and generated; or the gallery of the manual, twelve of them, in at
# most 500 kB. Builds htloops first. Needs Python with NumPy, SciPy and Pillow. Two sheets are made: OUT,
# and OUT with "_small" in its name.
#
#   scripts/make_removal_sheet.sh FOLDER OUT.png
#   scripts/make_removal_sheet.sh --gallery FOLDER OUT.png
#
# What FOLDER has not is left out, and said.
set -euo pipefail
cd "$(dirname "$0")/.."

gallery=no
if [ "${1:-}" = --gallery ]; then
  gallery=yes
  shift
fi
if [ $# -ne 2 ]; then
  sed -n '/^#   /s/^# *//p' "$0" >&2
  exit 2
fi
folder="$1"
output="$2"

parts=(plate_holes of_flange BracketInches IDGH_42400 thingi_73416 counter_unitsmm gmax15p_bed adns2610
  cranck_cse aqp_bed hinge deckel ADIS16480 chassis_upright hanger extruder_idler engine_Adapted03dist
  gearwheel impeller stratocaster)
scans=(fertility_6k botijo_jg rocker-arm happy_buddha_54k dragon_100k elk_vmas chair_vmas seahorse_vmas
  skull_low buddha_lihy)
spread=(protein_2jho protein_1CID_27k cgal_cheese magstim_coil)
generated=("lattice --genus 12" "gyroid --genus 8" "sponge --genus 20" "foam --genus 15"
  "plates --genus 20" "ladder --genus 4")
shown=(plate_holes of_flange deckel BracketInches chassis_upright hanger fertility_6k rocker-arm
  botijo_jg protein_2jho "sponge --genus 20" "lattice --genus 12")

scripts/build.sh htloops
made=$(mktemp --directory)
trap 'rm -rf "$made"' EXIT

# add NAME: the mesh of the folder, or what the generator makes of NAME, which has options then
meshes=()
add() {
  local words mesh
  read -ra words <<<"$1"
  mesh="$folder/$1.off"
  if [ "${#words[@]}" -gt 1 ]; then
    mesh="$made/${words[0]}.off"
    build/bin/htloops generate "${words[@]}" --faces 20000 -q -o "$mesh"
  fi
  if [ -f "$mesh" ]; then
    meshes+=("$mesh")
  else
    echo "There is no $mesh" >&2
  fi
}

# draw OUT [OPTION of the sheet...]
draw() {
  python3 benchmark/python/removal_sheet.py -o "$@" "${meshes[@]}"
}

if [ "$gallery" = yes ]; then
  for name in "${shown[@]}"; do add "$name"; done
  draw "$output" --size 190 --columns 4 --colours 64
else
  for name in "${parts[@]}" "${scans[@]}" "${spread[@]}" "${generated[@]}"; do add "$name"; done
  draw "$output" --size 500 --columns 4
  draw "${output%.png}_small.png" --size 130 --columns 8
fi
ls -l "$output"
