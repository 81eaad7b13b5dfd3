#!/usr/bin/env bash
# The executable for Windows, run by Wine: with the answers of that of this build, and with names and patterns
# as people there write them. Skipped where there is no Wine.
#
#   test_windows.sh HTLOOPS FOLDER
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
native=$1
folder=$2

command -v wine >/dev/null || { echo "There is no Wine (Debian: wine, wine64)" && exit 77; }
rm -rf "$folder"
mkdir -p "$folder/names/Ordner mit ß"
"$here/../../scripts/make_windows.sh" "$folder"
export WINEDEBUG=-all WINEARCH=win64 WINEPREFIX=$folder/wine
windows=(wine "$folder/htloops.exe")

cd "$folder/names"
"${windows[@]}" generate torus --faces 1000 -o 'Ordner mit ß\grün 漢.off' -q
"${windows[@]}" loops 'Ordner mit ß\grün 漢.off' -o 'Ordner mit ß\Schleifen ü.json' -q
"$native" check 'Ordner mit ß/grün 漢.off' 'Ordner mit ß/Schleifen ü.json'
"${windows[@]}" loops '*\gr*.off' 'Ordner mit ß' --csv all.csv --jobs 2
[ "$(cut -d, -f1 all.csv)" = $'mesh\nOrdner mit ß/grün 漢.off' ]
"${windows[@]}" loops 'Ordner mit ß' --csv all.csv --resume
[ "$(wc -l <all.csv)" -eq 2 ]
# What is there stays, if it cannot be replaced; what comes by pipes is not changed.
! "${windows[@]}" loops 'Ordner mit ß/grün 漢.off' -o 'none/a.json'
"${windows[@]}" loops - --format off -o - -q <'Ordner mit ß/grün 漢.off' >piped.json
"$native" check 'Ordner mit ß/grün 漢.off' piped.json
! grep -q $'\r' piped.json
[ -z "$(find . -name 'htloops.part-*')" ]

/usr/bin/python3 "$here/same_answers.py" "$native" "$folder/answers" "${windows[@]}"
