#!/usr/bin/env bash
# Fails if clang-format would change a source file; with --fix, lets it.
set -euo pipefail
cd "$(dirname "$0")/../.."

# Other versions of clang-format break some lines differently, so only this one judges.
version=14
if command -v "clang-format-$version" >/dev/null; then
  format=clang-format-$version
elif clang-format --version 2>/dev/null | grep -q " version $version\."; then
  format=clang-format
else
  echo "format: not checked, clang-format $version is not here"
  exit 0
fi

mode=(--dry-run -Werror)
[ "${1:-}" != --fix ] || mode=(-i)
if ! git ls-files -z --cached --others --exclude-standard -- '*.h' '*.cpp' '*.cu' '*.cuh' |
  xargs -0 --no-run-if-empty "$format" "${mode[@]}"; then
  echo "format: run  $0 --fix" >&2
  exit 1
fi
echo "format: all is well"
