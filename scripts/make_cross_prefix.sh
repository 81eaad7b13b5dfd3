#!/usr/bin/env bash
# Makes a folder of what the tool needs of other libraries, for another machine than this one: zlib, libpng, Expat
# and double-conversion as static libraries, compiled from Debian's sources; tinygltf from its header; the headers
# of CGAL, Boost, Eigen, CLI11, nlohmann-json and stb, as links. Nothing is compiled twice.
#
#   scripts/make_cross_prefix.sh PREFIX [CMake option...]      (options: the toolchain)
set -euo pipefail

prefix=$(realpath -m "$1")
shift
toolchain=("$@")
[ ! -f "$prefix/complete" ] || exit 0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$prefix/include" "$prefix/share/cmake"

link_headers() {
  local name
  for name in CGAL boost CLI nlohmann stb eigen3; do
    ln -sfn "/usr/include/$name" "$prefix/include/$name"
  done
  cp -r /usr/lib/*/cmake/CGAL /usr/share/cmake/CLI11 /usr/share/cmake/nlohmann_json "$prefix/share/cmake"
  cp -r /usr/share/eigen3 "$prefix/share"
}

# Sources whose signatures apt checks, of the release that this machine runs.
fetch_sources() {
  # shellcheck source=/dev/null
  . /etc/os-release
  echo "deb-src http://deb.debian.org/debian $VERSION_CODENAME main" >"$work/sources.list"
  mkdir -p "$work/lists/partial"
  local options=(-qq -o "Dir::Etc::sourcelist=$work/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$work/lists" -o APT::Sandbox::User=root)
  apt-get "${options[@]}" update
  (cd "$work" && apt-get "${options[@]}" source "$@" >/dev/null)
}

# build FOLDER LIBRARY HEADERS FILES [DEFINITION...]: a static library, into the prefix. Each is compiled in
# this one way: what their own build files ask of a compiler, they do not understand of all of them.
build() {
  local folder=$1 name=$2 headers=$3 files=$4
  shift 4
  cat >"$folder/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.21)
project($name C CXX)
file(GLOB files $files)
add_library($name STATIC \${files})
target_compile_features($name PRIVATE cxx_std_17)
target_compile_definitions($name PRIVATE $@)
target_include_directories($name PRIVATE . "\${CMAKE_INSTALL_PREFIX}/include")
install(TARGETS $name DESTINATION lib)
install(FILES $headers DESTINATION include)
END
  { cmake -S "$folder" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" \
    "${toolchain[@]}" && cmake --build "$folder/build" --parallel "$(nproc)" &&
    cmake --install "$folder/build"; } >"$work/log" 2>&1 || {
    tail -50 "$work/log" >&2
    exit 1
  }
}

# describe PACKAGE TARGET LIBRARY [DEFINITION...]: what find_package() reads where CMake itself has no module.
describe() {
  local package=$1 target=$2 library=$3
  shift 3
  mkdir -p "$prefix/share/cmake/$package"
  cat >"$prefix/share/cmake/$package/${package}Config.cmake" <<END
get_filename_component(_prefix "\${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
add_library($target STATIC IMPORTED)
set_target_properties($target PROPERTIES IMPORTED_LOCATION "\${_prefix}/lib/lib$library.a"
  INTERFACE_INCLUDE_DIRECTORIES "\${_prefix}/include" INTERFACE_COMPILE_DEFINITIONS "$(IFS=';' && echo "$*")")
END
}

write_gltf_sources() {
  mkdir "$work/gltf"
  cp /usr/include/tiny_gltf.h "$work/gltf"
  printf '%s\n' '#define TINYGLTF_IMPLEMENTATION' '#include <tiny_gltf.h>' >"$work/gltf/tiny_gltf.cc"
}

link_headers
fetch_sources zlib libpng1.6 expat double-conversion
build "$work"/zlib-* z "zlib.h zconf.h" "*.c" HAVE_UNISTD_H
cp "$work"/libpng1.6-*/scripts/pnglibconf.h.prebuilt "$(echo "$work"/libpng1.6-*/)/pnglibconf.h"
rm "$work"/libpng1.6-*/{example,pngtest}.c
build "$work"/libpng1.6-* png "png.h pngconf.h pnglibconf.h" "*.c" PNG_ARM_NEON_OPT=0 PNG_INTEL_SSE_OPT=0
: >"$(echo "$work"/expat-*/expat/lib)/expat_config.h" # all it would say is said here
build "$work"/expat-*/expat/lib expat "expat.h expat_external.h" "xml*.c" \
  XML_STATIC XML_DTD=1 XML_GE=1 XML_NS=1 XML_CONTEXT_BYTES=1024 XML_DEV_URANDOM
build "$work"/double-conversion-*/double-conversion double-conversion "" "*.cc"
mkdir "$prefix/include/double-conversion"
cp "$work"/double-conversion-*/double-conversion/*.h "$prefix/include/double-conversion"
describe double-conversion double-conversion::double-conversion double-conversion
no_images=(TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE)
write_gltf_sources
build "$work/gltf" tinygltf tiny_gltf.h tiny_gltf.cc "${no_images[@]}"
describe TinyGLTF TinyGLTF::TinyGLTF tinygltf "${no_images[@]}"
touch "$prefix/complete"
