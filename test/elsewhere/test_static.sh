#!/usr/bin/env bash
# The static executable: small, alone in an empty root folder, and with the answers of that of this build.
#
#   test_static.sh HTLOOPS FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
native=$1
folder=$2
most_bytes=$((12 << 20))

rm -rf "$folder"
mkdir -p "$folder/alone"
"$here/../../scripts/make_static.sh" "$folder/alone"
bytes=$(stat --format=%s "$folder/alone/htloops")
[ "$bytes" -le "$most_bytes" ] || { echo "htloops has $bytes bytes" >&2 && exit 1; }

# Nothing else is there: no library, no /proc, no /etc.
alone=(chroot "$folder/alone" /htloops)
[ "$(id -u)" -eq 0 ] || alone=(unshare --map-root-user "${alone[@]}")
if "${alone[@]}" --version; then
  "$native" generate gyroid --genus 5 --faces 20000 -o "$folder/alone/mesh.off" -q
  "${alone[@]}" loops mesh.off -o loops.json --picture loops.png --gltf loops.glb --html loops.html --threads 2
  "$native" check "$folder/alone/mesh.off" "$folder/alone/loops.json"
  "${alone[@]}" generate torus -o torus.3mf -q
  "${alone[@]}" measure torus.3mf --csv torus.csv --jobs 2
else
  echo "Nothing was tried in an empty root folder: that takes root, or namespaces of users"
fi
/usr/bin/python3 "$here/same_answers.py" "$native" "$folder/answers" "$folder/alone/htloops"
