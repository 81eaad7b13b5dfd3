#!/usr/bin/env bash
# Installs the Debian packages that are missing: for the tool, for the tests too, for the checks, for all
# tests (some skip without what brings many packages: with valijson comes Qt), or for the benchmarks
# beside other programs, which want VTK; or the programs that judge what the tool writes, of which some are
# large, and two come from npm into build/judges.
#
#   scripts/install_dependencies.sh [tool|tests|checks|all|benchmarks|judges]
#
# Touches nothing, and needs no network, where all is there. Where there is no apt-get it names the
# libraries and goes on: the build then says itself what it lacks.
set -euo pipefail

tool=(g++ cmake ninja-build libcgal-dev libtbb-dev libcli11-dev nlohmann-json3-dev zlib1g-dev
  libpng-dev libstb-dev fonts-dejavu-core libeigen3-dev libexpat1-dev libtinygltf-dev)
python=(python3-dev pybind11-dev python3-numpy python3-pytest python3-networkx python3-tqdm)
tests=("${tool[@]}" "${python[@]}" libgtest-dev assimp-utils)
checks=("${tests[@]}" clang-format)
all=("${checks[@]}" libbenchmark-dev libvalijson-dev python3-scipy python3-meshio python3-matplotlib
  python3-pil python3-distributed)
benchmarks=("${tests[@]}" libbenchmark-dev libvtk9-dev)
judges=("${tests[@]}" python3-nibabel python3-gmsh blender paraview python3-paraview prusa-slicer
  pymol xvfb xauth)

case "${1:-tool}" in
  tool) wanted=("${tool[@]}") ;;
  tests) wanted=("${tests[@]}") ;;
  checks) wanted=("${checks[@]}") ;;
  all) wanted=("${all[@]}") ;;
  benchmarks) wanted=("${benchmarks[@]}") ;;
  judges) wanted=("${judges[@]}") ;;
  *)
    echo "usage: $0 [tool|tests|checks|all|benchmarks|judges]" >&2
    exit 2
    ;;
esac

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "There is no apt-get here. Needed: a C++17 compiler, CMake 3.21, Ninja, CGAL 5.5, CLI11," >&2
  echo "nlohmann-json, zlib; used if present: oneTBB, Eigen, libpng, stb, Expat, tinygltf, GoogleTest," >&2
  echo "Google Benchmark," >&2
  echo "Python with NumPy and pybind11." >&2
  exit 0
fi

install_from_npm() {
  if ! command -v npm >/dev/null; then
    echo "There is no npm here: gltf-validator and manifold-3d are not installed" >&2
    return
  fi
  npm install --silent --no-audit --no-fund --prefix "$(dirname "$0")/../build/judges" gltf-validator manifold-3d
}
[ "${1:-tool}" != judges ] || install_from_npm

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing=()
for package in "${wanted[@]}"; do
  is_installed "$package" || missing+=("$package")
done
[ "${#missing[@]}" -gt 0 ] || exit 0

echo "Installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "Neither root nor sudo: as root, run  apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
"${as_root[@]}" apt-get update --quiet
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --quiet --no-install-recommends "${missing[@]}"
