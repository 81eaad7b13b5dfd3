#!/usr/bin/env bash
# Runs the commands of the guides of the manual, and takes the pictures that these draw, guide_*.png, to the manual's
# figures. Builds htloops first; needs Python, or PYTHON, with Pillow.
#
#   scripts/make_guide_pictures.sh [GUIDE...]
#
# GUIDE is the name of one, such as seams; all by default.
set -euo pipefail
cd "$(dirname "$0")/.."

root=$(pwd)
python="${PYTHON:-python3}"
"$python" -c 'import PIL' || {
  echo "This needs Python with Pillow" >&2
  exit 1
}
scripts/build.sh htloops
[ $# -gt 0 ] || set -- $(cd doc/Handle_tunnel_loops/guides && printf '%s\n' *.txt | sed 's/\.txt$//')

for guide; do
  folder=$(mktemp --directory)
  cp examples/Handle_tunnel_loops/data/* "$folder"
  echo "== $guide"
  (cd "$folder" && PATH="$root/build/bin:$PATH" PYTHONPATH="$root/test/journeys" "$python" -c '
import pathlib, subprocess, sys
from guides import commands_of
for command, code in commands_of(pathlib.Path(sys.argv[1])):
    print(command, flush=True)
    if subprocess.run(["bash", "-c", command], stdout=subprocess.DEVNULL).returncode != code:
        sys.exit("failed: " + command)
' "$root/doc/Handle_tunnel_loops/guides/$guide.txt")
  for picture in "$folder"/guide_*.png; do
    [ ! -f "$picture" ] || "$python" -c '
import os, sys
from PIL import Image
picture = Image.open(sys.argv[1]).convert("RGB")
if os.path.getsize(sys.argv[1]) > 120000:  # octrees keep the colours of thin lines
    picture = picture.quantize(256, method=Image.Quantize.FASTOCTREE, kmeans=1)
picture.save(sys.argv[2], optimize=True)
' "$picture" "doc/Handle_tunnel_loops/fig/${picture##*/}"
  done
  rm -r "$folder"
done
