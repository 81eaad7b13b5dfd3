#!/usr/bin/env bash
# Draws the gallery of the manual: of each mesh its loops and its Reeb graph. Builds htloops first.
#
#   scripts/make_gallery.sh [FOLDER]
set -euo pipefail
cd "$(dirname "$0")/.."

folder="${1:-doc/Handle_tunnel_loops/fig/gallery}"
scripts/build.sh htloops
htloops=build/bin/htloops
mesh=$(mktemp --suffix .off)
trap 'rm -f "$mesh"' EXIT
mkdir -p "$folder"

# draw NAME [OPTION of the generator...]
draw() {
  local name="$1"
  shift
  "$htloops" generate "$@" -q -o "$mesh"
  "$htloops" loops "$mesh" -q --size 384,288 --picture "$folder/$name.png"
  "$htloops" reeb "$mesh" -q --size 384,288 --picture "$folder/${name}_reeb.png"
}

for shape in mug chair bicycle trefoil borromean bores exchanger coral cage; do
  draw "$shape" "$shape"
done
draw torus torus --faces 20000
draw knot knot --faces 40000
draw multi_torus multi-torus --genus 5 --faces 40000
draw lattice lattice --genus 12 --faces 60000
draw gyroid gyroid --genus 8 --faces 60000
draw sponge sponge --genus 20 --faces 60000
draw foam foam --genus 15 --faces 60000
draw chain chain --genus 5 --faces 40000
draw torus_link torus-link --genus 2 --long-way 2 --short-way 3 --faces 40000
draw ladder ladder --genus 4 --faces 60000
draw plates plates --genus 20
draw shell shell --genus 6 --faces 40000
draw waves waves --frequency 3 --faces 60000
draw interlaced interlaced --genus 6 --faces 60000
draw scan scan --genus 2
du -ch "$folder"/*.png | tail -1
