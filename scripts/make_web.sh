#!/usr/bin/env bash
# Makes the tool as WebAssembly, without a native build: installs what is missing, compiles in build/web, and
# writes into web/ the page that computes in a browser, in one file, the same with threads, and the package for npm.
#
#   scripts/make_web.sh [FOLDER]           default: web
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(realpath -m "${1:-web}")
build=build/web
package=$build/package
emscripten=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake
export NODE_PATH=/usr/share/nodejs # a node that is not Debian's does not look there

scripts/install_dependencies.sh web

# Small code, with small functions inlined: a fifth less than by -O2, and as fast.
optimization="-Os -sINLINING_LIMIT=0 -DNDEBUG"
# WebAssembly has no modes of rounding: CGAL has to know. Nor is there GMP.
arithmetic="-DCGAL_DISABLE_GMP=1 -DCGAL_ALWAYS_ROUND_TO_NEAREST"

# Pictures have letters of ASCII only. What is left of the font has no name: that is its own.
make_font() {
  [ -f "$build/font.ttf" ] || /usr/bin/python3 -m fontTools.subset \
    /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf --output-file="$build/font.ttf" \
    --unicodes=U+20-7E --no-hinting --name-IDs= --notdef-outline --drop-tables+=FFTM
}

# compile FOLDER THREADS [FLAGS C] [FLAGS C++]: the tool, with what it needs compiled by the same flags.
compile() {
  local made="$PWD/$build/$1" threads=$2 all=(-fwasm-exceptions "${@:3}")
  scripts/make_cross_prefix.sh "$made/prefix" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$emscripten" \
    -DCMAKE_C_FLAGS="${3:-}" -DCMAKE_CXX_FLAGS="${all[*]}"
  cmake -S . -B "$made/tool" -G Ninja -DHTL_PREFIX="$made/prefix" -C cmake/tool_alone.cmake \
    -DCMAKE_TOOLCHAIN_FILE="$emscripten" -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY \
    -DCMAKE_CXX_FLAGS_RELEASE="$optimization" -DCMAKE_CXX_FLAGS="${all[*]} $arithmetic" \
    -DHTL_THREADS="$threads" -DHTL_FONT="$PWD/$build/font.ttf"
  cmake --build "$made/tool" --target htloops --parallel "$(nproc)"
}

# The module of JavaScript, with what it is compiled to, without threads and with them.
lay_out_package() {
  rm -rf "$package"
  mkdir -p "$package"
  cp src/web/module/* LICENSE packaging/NOTICES packaging/npm/README.md "$package"
  local ending
  for ending in js wasm; do
    cp "$build/plain/tool/bin/htloops.$ending" "$package"
    cp "$build/threads/tool/bin/htloops.$ending" "$package/htloops_threads.$ending"
  done
  sed "s/@version@/$(<VERSION)/" packaging/npm/package.json >"$package/package.json"
}

# make_page PAGE MODULE WORKER HAS_THREADS: in one file.
make_page() {
  local made="$build/page/$1"
  mkdir -p "$made"
  zopfli --i5 -c "$package/$2" | base64 --wrap=0 >"$made/module"
  esbuild "$package/$3" --bundle --minify --log-level=warning --outfile="$made/worker"
  esbuild src/web/page/app.js --bundle --minify --format=esm --define:HAS_THREADS="$4" --log-level=warning \
    --outfile="$made/script"
  node src/web/assemble.js src/web/page/app.html "$folder/$1.html" style=src/web/page/app.css \
    module="$made/module" worker="$made/worker" script="$made/script" version=VERSION
}

mkdir -p "$build" "$folder"
make_font
compile plain NONE
compile threads STD -pthread "-include '$PWD/src/web/landing_pads.h'"
lay_out_package
make_page index htloops.wasm browser_worker.js false
make_page threads htloops_threads.wasm browser_threads_worker.js true
(cd "$package" && npm pack --silent --pack-destination "$folder" >/dev/null)
ls -l "$folder"
