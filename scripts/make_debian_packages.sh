#!/usr/bin/env bash
# Makes the packages of Debian in a copy of the sources, and has lintian look at them, where that is.
#
#   scripts/make_debian_packages.sh [FOLDER]
#
# FOLDER is build/debian if none is named. What is needed, scripts/install_dependencies.sh packages installs.
set -euo pipefail
folder=${1:-$(dirname "$0")/../build/debian}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$(dirname "$0")/.."

copy=$folder/handle-tunnel-loops-$(<VERSION)
rm -rf "$copy" "$folder"/*.deb
scripts/copy_sources.sh "$copy"
cp -r packaging/debian "$copy/debian"
cd "$copy"
export DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:-parallel=$(nproc)}"
dpkg-buildpackage --build=binary --no-sign

cd "$folder"
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error,warning ./*.changes
fi
rm -rf "$copy"
ls ./*.deb
