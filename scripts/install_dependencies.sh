#!/usr/bin/env bash
# Installs the Debian packages that are missing: for the tool, for the tests too, for the checks, for all
# tests (some skip without what brings many packages: with valijson comes Qt), or for the benchmarks
# beside other programs, which want VTK; for WebAssembly, or to test that; for an executable for Windows; for
# what is given away, as packages of Debian and wheels; or the programs that judge what the tool writes, of
# which some are large, and two come from npm into build/judges.
#
#   scripts/install_dependencies.sh [GROUP]
#
# GROUP is tool, tests, checks, all, benchmarks, web, web_tests, windows, packages or judges.
#
# Touches nothing, and needs no network, where all is there. Where there is no apt-get it names the
# libraries and goes on: the build then says itself what it lacks.
set -euo pipefail

tool=(g++ cmake ninja-build libcgal-dev libtbb-dev libcli11-dev nlohmann-json3-dev zlib1g-dev
  libpng-dev libstb-dev fonts-dejavu-core libeigen3-dev libexpat1-dev libtinygltf-dev)
python=(python3-dev pybind11-dev python3-numpy python3-pytest python3-networkx python3-tqdm)
tests=("${tool[@]}" "${python[@]}" libgtest-dev assimp-utils)
checks=("${tests[@]}" clang-format git)
all=("${checks[@]}" libbenchmark-dev libvalijson-dev python3-scipy python3-meshio python3-matplotlib
  python3-pil python3-distributed clang libc++-dev libc++abi-dev)
benchmarks=("${tests[@]}" libbenchmark-dev libvtk9-dev)
web=(cmake ninja-build emscripten esbuild dpkg-dev libcgal-dev libeigen3-dev libcli11-dev nlohmann-json3-dev
  libtinygltf-dev libstb-dev fonts-dejavu-core python3-fonttools zopfli)
command -v npm >/dev/null || web+=(npm) # that of Debian does not go with a node that is not
packages=("${tests[@]}" debhelper dh-python dpkg-dev lintian debootstrap autopkgtest doxygen libjs-mathjax pkg-config
  python3-pip python3-setuptools python3-wheel python3-venv ccache)
windows=(cmake ninja-build g++-mingw-w64-x86-64-posix dpkg-dev libcgal-dev libeigen3-dev libcli11-dev nlohmann-json3-dev
  libtinygltf-dev libstb-dev fonts-dejavu-core)
judges=("${tests[@]}" python3-nibabel python3-gmsh blender paraview python3-paraview prusa-slicer
  pymol xvfb xauth)

case "${1:-tool}" in
  tool) wanted=("${tool[@]}") ;;
  tests) wanted=("${tests[@]}") ;;
  checks) wanted=("${checks[@]}") ;;
  all) wanted=("${all[@]}") ;;
  benchmarks) wanted=("${benchmarks[@]}") ;;
  web) wanted=("${web[@]}") ;;
  web_tests) wanted=("${web[@]}" chromium firefox-esr xvfb xauth libgl1-mesa-dri) ;;
  windows) wanted=("${windows[@]}") ;;
  packages) wanted=("${packages[@]}") ;;
  judges) wanted=("${judges[@]}") ;;
  *)
    echo "usage: $0 [tool|tests|checks|all|benchmarks|web|web_tests|windows|packages|judges]" >&2
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

# install_from_npm FOLDER PACKAGE...: into build/FOLDER.
install_from_npm() {
  local folder=$1
  shift
  if ! command -v npm >/dev/null; then
    echo "There is no npm here: not installed are $*" >&2
    return
  fi
  npm install --silent --no-audit --no-fund --prefix "$(dirname "$0")/../build/$folder" "$@"
}

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

install_from_debian() {
  local missing=() as_root=() package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ "${#missing[@]}" -gt 0 ] || return 0
  echo "Installing: ${missing[*]}"
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
}

install_from_debian "${wanted[@]}"
case "${1:-tool}" in
  judges) install_from_npm judges gltf-validator manifold-3d ;;
  web_tests) install_from_npm web_tests puppeteer-core@24 axe-core@4 vite@7 typescript@5 ;;
esac
