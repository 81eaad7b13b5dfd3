#!/usr/bin/env bash
# Holds the rooms of the package to their arrows: a room, its headers and its files in src/library, includes
# headers of its own and of those that the line "Uses:" of its README.md names; the rooms make no circle; none
# has more lines than its line "Budget:" grants, which changes with a reason in the same commit; what only a device
# needs is not in the way of a program for the processor.
set -euo pipefail
export LC_ALL=C
cd "$(dirname "$0")/../.."

internal=include/CGAL/Handle_tunnel_loops/internal
library=src/library
for_devices='^device$'
findings=$(mktemp)
trap 'rm -f "$findings"' EXIT

complain() { echo "$*" >>"$findings"; }

rooms() { find "$internal" -mindepth 1 -maxdepth 1 -type d -printf '%f\n' | sort; }

files_of() { find "$internal/$1" "$library/$1" \( -name '*.h' -o -name '*.cpp' \) 2>/dev/null | sort || true; }

# What a room may use, by its own page.
uses() { sed -n 's/^Uses://p' "$internal/$1/README.md"; }

check_pages() {
  local room other
  for room in $(rooms); do
    if [ "$(grep -c '^Uses:' "$internal/$room/README.md" 2>/dev/null)" != 1 ]; then
      complain "$internal/$room: no README.md with one line 'Uses: ROOM...'"
      continue
    fi
    for other in $(uses "$room"); do
      [ -d "$internal/$other" ] || complain "$internal/$room/README.md: there is no room $other"
      [[ "$room" =~ $for_devices || ! "$other" =~ $for_devices ]] ||
        complain "$internal/$room/README.md: $other is for devices only"
    done
    grep -q "$room/README.md" "$internal/README.md" || complain "$internal/README.md: no room $room"
  done
  find "$internal" -maxdepth 1 -name '*.h' | while read -r header; do
    complain "$header: not in a room"
  done
  for room in "$library"/*/; do
    [ -d "$internal/$(basename "$room")" ] || complain "$room: not a room"
  done
}

check_includes() {
  local room header other
  for room in $(rooms); do
    files_of "$room" | xargs grep -Ho "internal/[a-z]*/[A-Za-z_]*\.h>" | while IFS=: read -r header other; do
      other=$(echo "$other" | cut -d/ -f2)
      [[ " $room $(uses "$room") " == *" $other "* ]] ||
        complain "$header: includes the room $other, which $room does not use"
    done
  done
}

check_budgets() {
  local room lines budget
  for room in $(rooms); do
    lines=$(files_of "$room" | xargs cat | wc -l)
    budget=$(sed -n 's/^Budget: \([0-9]*\) lines$/\1/p' "$internal/$room/README.md")
    if [ -z "$budget" ]; then
      complain "$internal/$room/README.md: no line 'Budget: N lines'"
    elif [ "$lines" -gt "$budget" ]; then
      complain "$internal/$room: $lines lines, where $budget are granted"
    fi
  done
}

# tsort names the circles, if there are any.
check_circles() {
  for room in $(rooms); do
    for other in $(uses "$room"); do echo "$room $other"; done
  done | tsort 2>&1 >/dev/null | grep -v 'tsort: -: input' | while read -r line; do
    complain "a circle of rooms: ${line#tsort: }"
  done
}

# The public headers, as a program without CUDA includes them.
check_processor() {
  printf '#include <CGAL/%s.h>\n' handle_tunnel_loops reeb_graph Handle_tunnel_loops/Reference_tag |
    "${CXX:-c++}" -std=c++17 -Iinclude -x c++ -M - | tr -s ' \\' '\n' | grep "^$internal/" |
    while read -r header; do
      [[ ! "$(basename "$(dirname "$header")")" =~ $for_devices ]] ||
        complain "$header: included by programs without CUDA"
    done
  echo '#include <CGAL/reeb_graph_of_function.h>' |
    "${CXX:-c++}" -std=c++17 -Iinclude -x c++ -M - | tr -s ' \\' '\n' |
    grep -E "^$internal/(passes|shortening|certificate)/" | while read -r header; do
      complain "$header: included for the graph of a function"
    done || true
}

check_pages
check_includes
check_budgets
check_circles || true
check_processor

if [ -s "$findings" ]; then
  sort -u "$findings" >&2
  echo "rooms: see above" >&2
  exit 1
fi
echo "rooms: all is well"
