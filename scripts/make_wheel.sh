#!/usr/bin/env bash
# Makes a source archive for pip and, of what is in it, a wheel, with what Debian has: setuptools, and no network.
#
#   scripts/make_wheel.sh [PYTHON [FOLDER]]
#
# PYTHON is /usr/bin/python3 if none is named, and FOLDER build/dist. Options for CMake are taken from CMAKE_ARGS.
set -euo pipefail
cd "$(dirname "$0")/.."

python=${1:-/usr/bin/python3} folder=${2:-build/dist}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work" packaging/pip/*.egg-info' EXIT

"$python" -c "import setuptools.build_meta as backend, sys; backend.build_sdist(sys.argv[1])" "$folder" >"$work/log" ||
  { cat "$work/log" >&2 && exit 1; }

archive=$folder/handle_tunnel_loops-$(<VERSION).tar.gz
mkdir "$work/unpacked"
tar -xzf "$archive" -C "$work/unpacked" --strip-components=1
"$python" -m pip wheel "$work/unpacked" --no-build-isolation --no-deps --no-index --wheel-dir "$folder"
