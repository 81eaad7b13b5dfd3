#!/usr/bin/env bash
# Makes the tool as WebAssembly, without a native build: installs what is missing, compiles in build/web, and
# writes into web/ the page that computes in a browser, in one file, and the package for npm.
#
#   scripts/make_web.sh [FOLDER]           default: web
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(realpath -m "${1:-web}")
build=build/web
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
  cmake -S . -B "$build/tool" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$emscripten" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="$optimization" -DCMAKE_CXX_FLAGS="$flags" \
    -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_FIND_ROOT_PATH_MODE_PACKAGE=ONLY \
    -DCGAL_DIR="$prefix/share/cmake/CGAL" -DCGAL_DISABLE_GMP=ON \
    -DBoost_NO_BOOST_CMAKE=ON -DBoost_INCLUDE_DIR="$prefix/include" -DHTL_THREADS=NONE \
    -DHTL_FONT="$PWD/$build/font.ttf" -DHTL_STB="$prefix/include" \
    -DHTL_CUDA=OFF -DHTL_PYTHON=OFF -DHTL_BUILD_TESTS=OFF -DHTL_BUILD_EXAMPLES=OFF \
    -DHTL_BUILD_BENCHMARKS=OFF -DHTL_INSTALL=OFF
  cmake --build "$build/tool" --target htloops --parallel "$(nproc)"
}

make_page() {
  local made="$build/page"
  mkdir -p "$made" "$folder"
  zopfli --i5 -c "$build/tool/bin/htloops.wasm" | base64 --wrap=0 >"$made/module"
  esbuild src/web/page/page_worker.js --bundle --minify --log-level=warning \
    --alias:htloops="$PWD/$build/tool/bin/htloops.js" --outfile="$made/worker"
  esbuild src/web/page/app.js --bundle --minify --format=esm --log-level=warning --outfile="$made/script"
  node src/web/assemble.js src/web/page/app.html "$folder/index.html" style=src/web/page/app.css \
    module="$made/module" worker="$made/worker" script="$made/script" version=VERSION
}

make_package() {
  local made="$build/package"
  rm -rf "$made"
  mkdir -p "$made"
  cp src/web/module/* "$build"/tool/bin/htloops.{js,wasm} LICENSE packaging/NOTICES packaging/npm/README.md "$made"
  sed "s/@version@/$(<VERSION)/" packaging/npm/package.json >"$made/package.json"
  (cd "$made" && npm pack --silent --pack-destination "$folder" >/dev/null)
}

mkdir -p "$build"
make_font
compile
make_page
make_package
ls -l "$folder"
