#!/usr/bin/env bash
# Copies the sources into a folder: in a clone what git has or would add, elsewhere all but what was built.
#
#   scripts/copy_sources.sh FOLDER
set -euo pipefail
mkdir -p "$1"
target=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."

listed() {
  if [ -e .git ]; then
    git ls-files -z --cached --others --exclude-standard
  else
    find . -mindepth 1 \( -path './build*' -o -path ./release \) -prune -o \( -type f -o -type l \) -print0
  fi
}

# What git has may have been removed here.
listed | while IFS= read -r -d '' file; do
  [ ! -e "$file" ] || printf '%s\0' "$file"
done | tar --create --null --files-from=- | tar --extract --directory="$target"
