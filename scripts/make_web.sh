#!/usr/bin/env bash
# Makes the tool as WebAssembly, without a native build: installs what is missing, compiles in build/web, and
# writes into web/ the page that computes in a browser, in one file, and the package for npm.
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
flags="-fwasm-exceptions -DCGAL_DISABLE_GMP=1 -DCGAL_ALWAYS_ROUND_TO_NEAREST"

# Pictures have letters of ASCII only. What is left of the font has no name: that is its own.
make_font() {
  [ -f "$build/font.ttf" ] || /usr/bin/python3 -m fontTools.subset \
    /usr/share/fonts/truetype/dejavu/DejaVuSansMono-Bold.ttf --output-file="$build/font.ttf" \
    --unicodes=U+20-7E --no-hinting --name-IDs= --notdef-outline --drop-tables+=FFTM
}

compile() {
  local prefix="$PWD/$build/prefix"
  scripts/make_cross_prefix.sh "$prefix" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$emscripten" \
    -DCMAKE_CXX_FLAGS=-fwasm-exceptions
  cmake -S . -B "$build/tool" -G Ninja -DHTL_PREFIX="$prefix" -C cmake/tool_alone.cmake \
    -DCMAKE_TOOLCHAIN_FILE="$emscripten" -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY \
    -DCMAKE_CXX_FLAGS_RELEASE="$optimization" -DCMAKE_CXX_FLAGS="$flags" \
    -DHTL_THREADS=NONE -DHTL_FONT="$PWD/$build/font.ttf"
  cmake --build "$build/tool" --target htloops --parallel "$(nproc)"
}

# The module of JavaScript, with what it is compiled to.
lay_out_package() {
  rm -rf "$package"
  mkdir -p "$package"
  cp src/web/module/* "$build"/tool/bin/htloops.{js,wasm} LICENSE packaging/NOTICES packaging/npm/README.md "$package"
  sed "s/@version@/$(<VERSION)/" packaging/npm/package.json >"$package/package.json"
}

make_page() {
  local made="$build/page"
  mkdir -p "$made"
  zopfli --i5 -c "$package/htloops.wasm" | base64 --wrap=0 >"$made/module"
  esbuild "$package/browser_worker.js" --bundle --minify --log-level=warning --outfile="$made/worker"
  esbuild src/web/page/app.js --bundle --minify --format=esm --log-level=warning --outfile="$made/script"
  node src/web/assemble.js src/web/page/app.html "$folder/index.html" style=src/web/page/app.css \
    module="$made/module" worker="$made/worker" script="$made/script" version=VERSION
}

mkdir -p "$build" "$folder"
make_font
compile
lay_out_package
make_page
(cd "$package" && npm pack --silent --pack-destination "$folder" >/dev/null)
ls -l "$folder"
