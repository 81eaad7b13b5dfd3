#!/usr/bin/env bash
# Repeats the experiments of the paper, and writes a page of all tables and figures. Builds the programs
# first, each of which fails where a count is wrong.
#
#   scripts/make_results_page.sh [--all] [--runs N] [--output FILE] [FOLDER]
#
# Meshes are generated; with FOLDER, its closed meshes of up to 20000 faces are added, and those that have
# the names of meshes of the paper take the places of what is generated for these. --all runs also the rows
# of the paper's tables that have more than 200000 faces. The page is benchmark/results/paper.md if
# nothing else is said, with its figures beside it.
set -euo pipefail
cd "$(dirname "$0")/.."

page=benchmark/results/paper.md
paper=(--faces 200000)
runs=3
folder=()
while [ $# -gt 0 ]; do
  case "$1" in
    --all) paper=() ;;
    --runs) runs=$2 && shift ;;
    --output) page=$2 && shift ;;
    -*) echo "no such option: $1" >&2 && exit 2 ;;
    *) folder=("$(realpath "$1")") ;;
  esac
  shift
done

scripts/build.sh experiments -DHTL_BUILD_BENCHMARKS=ON >&2
build=build/benchmark/Handle_tunnel_loops
figures=$(dirname "$page")
mkdir -p "$figures"
written=$(mktemp)
trap 'rm -f "$written"' EXIT

# run PROGRAM [ARGUMENT...]: what it prints, under the command that anybody can repeat.
run() {
  local program=$1 word
  shift
  printf '    %s' "$program"
  for word in "$@"; do
    [ "${folder[*]-}" != "$word" ] || word=FOLDER
    [ "$figures" != "$word" ] || word=FIGURES
    printf ' %s' "$word"
  done
  printf '\n\n'
  echo "$program" >&2
  "$build/$program" "$@"
  printf '\n'
}

meshes() {
  echo "Meshes are generated: the ten shapes of \`benchmark/Handle_tunnel_loops/Subjects.h\`, and for the tables of"
  echo "the paper others with as many faces and at least as many handles as its own."
  if [ ${#folder[@]} -ne 0 ]; then
    echo "To these were added the closed meshes of up to 20000 faces of a folder of $(find "${folder[0]}" -maxdepth 1 -type f | wc -l) files."
  fi
}

processor() {
  awk -F': ' '/^model name/ { print $2; exit }' /proc/cpuinfo 2>/dev/null || uname -m
}

commit() {
  git rev-parse --short HEAD 2>/dev/null || echo unknown
  git diff --quiet HEAD -- include src benchmark/Handle_tunnel_loops || echo "and changes"
}

{
  cat <<HEAD
# The experiments of the paper

Written by \`scripts/make_results_page.sh\`, $(date -u +%Y-%m-%d), commit $(commit | paste -sd ' '): $(processor), $(nproc) processors,
$("${CXX:-c++}" --version | head -n 1). $(meshes)
Each program ends with an error if the number of loops is not that of the handles, or an answer is not
certified, so that there would be no page.

## Time and memory

HEAD
  run benchmark_paper -n "$runs" --only paper "${paper[@]}" "${folder[@]}"
  run benchmark_paper -n "$runs" --only hard --faces 400000 # larger plates take minutes each
  cat <<'SEEDS'
## Seeds

Twenty random vertices to start from. A loop is at the same place as the one that corresponds to it
in the answer for the first seed if no point of one of them is further from the other than half a mean
edge, or two. Where a handle is equally thin in many places, or is symmetric, so
are its loops equally good in many.

SEEDS
  run benchmark_seeds --figures "$figures" "${folder[@]}"
  cat <<'ROBUSTNESS'
![Loops of twenty seeds on one mesh](seeds_places.svg)

*The loops of twenty seeds (purple) over each other: handles orange, tunnels blue.*

![Total lengths of twenty seeds on each mesh](seeds_lengths.svg)

*Total length of the loops, over the shortest of the same mesh: a dot for each seed.*

## Noise, decimation, remeshing

Noise is normally distributed, along the normals, with a standard deviation in mean edge lengths. The loops
of the clean mesh can be carried along with it, as the faces are the same: so much longer does noise alone
make them. The plates have few, long triangles, whose mean edge is longer than they are thick: the slightest noise
lets them cross themselves. "Reference over host" is the total length of the loops of the reference solver over that of the
host solver.

ROBUSTNESS
  run benchmark_robustness --figures "$figures" "${folder[@]}"
  cat <<'SOLVERS'
![One shape under some of the changes](changes.svg)

*Loops of the host solver under some of the changes.*

![Lengths under noise](noise_lengths.svg)

*Total length over that of the clean mesh, a line for each mesh.*

## The paper to the letter, the reference solver, the host solver

What each pass finds, summed over the meshes, also of those where it ended without an answer. Linking
numbers tell which loops bound on one side, and which have the right name.

SOLVERS
  run benchmark_solvers "${folder[@]}"
  cat <<'LETTER'
## Rules of the paper, one by one

How many meshes have an answer under a rule, and in which pass the others fail; lengths are relative to
those of the reference solver without it, both as the passes leave them.

LETTER
  run benchmark_letter --faces 20000 "${folder[@]}"
} >"$written"
sed -i -e :a -e '/^\n*$/{$d;N;ba' -e '}' "$written"
cp "$written" "$page"
chmod 644 "$page"
echo "Written: $page" >&2
