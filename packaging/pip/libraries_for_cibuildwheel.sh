#!/usr/bin/env bash
# Installs what a wheel is made with, in the images and machines of cibuildwheel.
#
#   packaging/pip/libraries_for_cibuildwheel.sh dnf|brew|vcpkg
set -euo pipefail

case "${1:-}" in
  dnf) # manylinux_2_28 is AlmaLinux 8
    dnf --assumeyes install epel-release dnf-plugins-core
    dnf config-manager --set-enabled powertools
    dnf --assumeyes install cmake ninja-build boost-devel gmp-devel gmp-c++ mpfr-devel zlib-devel libpng-devel \
      expat-devel eigen3-devel cli11-devel json-devel stb-devel dejavu-sans-fonts
    # Headers alone, and newer than what is packaged there.
    cgal=5.6.1
    curl --fail --location "https://github.com/CGAL/cgal/releases/download/v$cgal/CGAL-$cgal-library.tar.xz" |
      tar --extract --xz --directory=/opt
    cmake -S "/opt/CGAL-$cgal" -B /opt/cgal-build -DCMAKE_INSTALL_PREFIX=/usr/local
    cmake --install /opt/cgal-build
    ;;
  brew)
    brew install cmake ninja cgal gmp mpfr libpng expat eigen cli11 nlohmann-json
    ;;
  vcpkg)
    vcpkg install --triplet=x64-windows cgal zlib libpng expat eigen3 cli11 nlohmann-json stb
    ;;
  *)
    echo "usage: $0 dnf|brew|vcpkg" >&2
    exit 2
    ;;
esac
