#!/usr/bin/env bash
# Makes htloops as one file that needs nothing of the system it is run on: for any Linux on this kind of
# processor, with threads, pictures, glTF and 3MF.
#
#   scripts/make_static.sh [FOLDER [CMake option...]]
#
# FOLDER/htloops is written; FOLDER is build/static if none is named. What it is made in is
# build/static-work.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=${1:-build/static}
shift || true

scripts/install_dependencies.sh tool
work=build/static-work
generator=()
[ -f "$work/CMakeCache.txt" ] || ! command -v ninja >/dev/null || generator=(-G Ninja)
cmake -S . -B "$work" "${generator[@]}" -C cmake/tool_alone.cmake -DHTL_STATIC=ON -DHTL_THREADS=STD "$@"
cmake --build "$work" --target htloops --parallel "${JOBS:-$(nproc)}"

# Whatever it lacks is missed here, not by its users.
version=$("$work/bin/htloops" --version)
[[ "$version" == *", with threads"* ]] || { echo "made without threads: $version" >&2 && exit 1; }
if readelf --program-headers "$work/bin/htloops" | grep -q INTERP; then
  echo "$work/bin/htloops asks for libraries of the system" >&2
  exit 1
fi
mkdir -p "$folder"
strip --strip-all -o "$folder/htloops" "$work/bin/htloops"
ls -l "$folder/htloops"
