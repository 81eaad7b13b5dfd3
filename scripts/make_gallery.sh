#!/usr/bin/env bash
# Draws the gallery of the manual: of each mesh its loops and its Reeb graph, and of three how the layers
# of the first pass grow. Builds htloops first.
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

# grow NAME SIZE VIEW MOMENT...: the mesh at these moments of the first pass
grow() {
  local name="$1" size="$2" view="$3" moment number=0
  shift 3
  for moment in "$@"; do
    number=$((number + 1))
    "$htloops" loops "$mesh" -q --moment "$moment" --size "$size" --view "$view" \
      --picture "$folder/layers_${name}_$number.png"
  done
}

"$htloops" generate torus --faces 20000 -q -o "$mesh"
grow torus 288,200 0.3,-1,0.9 0.25 0.5 0.75 1
"$htloops" generate multi-torus --genus 2 --faces 30000 -q -o "$mesh"
grow double_torus 288,176 0.3,-1,1.1 0.2 0.4 0.6 0.8
"$htloops" generate shape -q -o "$mesh" --text - <<'END'
# a ball of meridians and parallels
genus 31
faces 80000
times 8 around 0 0 0   0 0 1 ring 0 0 0   1 0 0   1 0.085
ring 0 0 -0.62   0 0 1   0.785 0.085
ring 0 0 0   0 0 1   1 0.085
ring 0 0 0.62   0 0 1   0.785 0.085
END
grow ball 240,240 -0.6,-1,0.4 0.2 0.4 0.6 0.8

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
