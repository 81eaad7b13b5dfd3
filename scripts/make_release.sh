#!/usr/bin/env bash
# Makes all that is given away of a release, in one folder, with checksums: the archive of the sources, the wheel
# and the archive for pip, the packages of Debian, the static executable, that for Windows, the page and the package
# for npm, and the recipes with the checksums of the archive. Takes twenty minutes on two processors. Names what
# cannot be made, and then fails, with all the rest in the folder.
#
#   scripts/make_release.sh [FOLDER]
#
# FOLDER is release if none is named; an earlier release in it is removed. What each step printed is in build/release.
set -euo pipefail
release=$(realpath -m "${1:-$(dirname "$0")/../release}")
cd "$(dirname "$0")/.."

version=$(<VERSION)
work=$PWD/build/release
missing=()
export SOURCE_DATE_EPOCH="${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || stat --format=%Y VERSION)}"

# The version is the same everywhere.
scripts/checks/check_package.sh >/dev/null

# step NAME COMMAND [ARGUMENT...]: what the rest can do without.
step() {
  local name=$1 begin=$SECONDS
  shift
  printf '%s ... ' "$name"
  if "$@" >"$work/$name.log" 2>&1; then
    echo "$((SECONDS - begin)) s"
  else
    echo "not made: $(grep -iE 'error|fail|there is no' "$work/$name.log" | head -n 1)"
    missing+=("$name ($work/$name.log)")
  fi
}

# by_script SCRIPT [NAME=NEW_NAME...]: what a script of that name writes into a folder, into that of the release.
by_script() {
  local script=scripts/$1 made=$work/${1%.sh} rename
  shift
  [ -x "$script" ] || { echo "there is no $script" && return 1; }
  rm -rf "$made"
  "$script" "$made" || return 1
  for rename in "$@"; do
    [ ! -e "$made/${rename%%=*}" ] || mv "$made/${rename%%=*}" "$made/${rename#*=}"
  done
  find "$made" -maxdepth 1 -type f -exec cp --target-directory="$release" {} +
}

# pack FOLDER NAME: the same bytes for the same files.
pack() {
  tar --create --directory="$1" --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner "$2" |
    gzip --no-name --best
}

make_source_archive() {
  local name=handle-tunnel-loops-$version
  rm -rf "$work/sources"
  scripts/copy_sources.sh "$work/sources/$name" || return 1
  pack "$work/sources" "$name" >"$release/$name-source.tar.gz"
}

make_wheel() { scripts/make_wheel.sh /usr/bin/python3 "$release"; }

# The wheel and the static executable have most objects in common: these are compiled once.
in_common() {
  mkdir -p "$work/tmp"
  TMPDIR=$work/tmp CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_DIR=$work/ccache CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 "$@"
}

make_debian_packages() {
  scripts/make_debian_packages.sh "$work/debian" && cp "$work"/debian/*.deb "$release"
}

# Recipes have zeros where the checksums of the archive belong.
make_recipes() {
  local archive=$release/handle-tunnel-loops-$version-source.tar.gz sha256 sha512
  sha256=$(sha256sum "$archive" | cut -d' ' -f1) || return 1
  sha512=$(sha512sum "$archive" | cut -d' ' -f1)
  mkdir -p "$work/recipes"
  cp -r packaging/vcpkg packaging/conda packaging/homebrew "$work/recipes" || return 1
  sed -i -E "s/\b0{128}\b/$sha512/; s/\b0{64}\b/$sha256/" "$work"/recipes/*/*
  grep -rqE '0{64}' "$work/recipes" && return 1
  pack "$work" recipes >"$release/handle-tunnel-loops-$version-recipes.tar.gz"
}

if [ -n "$(ls -A "$release" 2>/dev/null)" ] && [ ! -e "$release/SHA256SUMS" ]; then
  echo "$release is not empty, and not an earlier release" >&2
  exit 2
fi
rm -rf "$release" "$work"
mkdir -p "$release" "$work"
[ -z "$(git status --porcelain 2>/dev/null)" ] || echo "What is not committed is in it, too."
scripts/install_dependencies.sh packages

step sources make_source_archive
step recipes make_recipes
step static in_common by_script make_static.sh "htloops=htloops-$version-linux-$(uname -m)"
step pip in_common make_wheel
step debian make_debian_packages
step windows by_script make_windows.sh "htloops.exe=htloops-$version-windows-x86_64.exe"
step web by_script make_web.sh "index.html=htloops-$version.html" "threads.html=htloops-$version-threads.html"

cp packaging/NOTICES LICENSE "$release"
(cd "$release" && find . -maxdepth 1 -type f -printf '%P\n' | grep -v '^SHA256SUMS$' | sort | xargs sha256sum >SHA256SUMS)
ls -l "$release"
echo "Made in $((SECONDS / 60)) minutes and $((SECONDS % 60)) seconds: $release"
if [ "${#missing[@]}" -gt 0 ]; then
  printf 'Not made: %s\n' "${missing[@]}" >&2
  exit 1
fi
