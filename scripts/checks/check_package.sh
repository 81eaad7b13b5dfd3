#!/usr/bin/env bash
# The rules of a CGAL package that can be checked without compiling it. Prints what breaks one, a
# line per finding, and fails if there is any. (No -e: a grep that finds nothing is good here.)
set -uo pipefail
export LC_ALL=C.UTF-8
cd "$(dirname "$0")/../.." || exit

package=Handle_tunnel_loops
licence=GPL-3.0-or-later
manual=doc/$package
cgal=/usr/include
findings=$(mktemp)
trap 'rm -f "$findings"' EXIT

complain() { echo "$*" >>"$findings"; }

# What git would commit from here: its files, and those it does not ignore.
files() {
  git ls-files --cached --others --exclude-standard -- "$@" ':!test/fuzz/corpus' | while read -r file; do
    [ ! -f "$file" ] || echo "$file"
  done
}

text_files() { files | grep -vE '\.(png|jpg|pdf)$'; }

check_text() {
  local file
  text_files | while read -r file; do
    ! grep -qP '\t' "$file" || [[ "$file" == */debian/rules ]] || complain "$file: a tab" # make wants them
    ! grep -qP '[ \r]$' "$file" || complain "$file: a blank or a carriage return ends a line"
    iconv -f UTF-8 -t UTF-8 "$file" >/dev/null 2>&1 || complain "$file: not UTF-8"
    [ -z "$(tail -c 1 "$file")" ] || complain "$file: the last line does not end"
  done
}

check_executable_bits() {
  local file
  text_files | while read -r file; do
    if [ "$(head -c 2 "$file")" = '#!' ]; then
      [ -x "$file" ] || complain "$file: a script that is not executable"
    else
      [ ! -x "$file" ] || complain "$file: executable, but not a script"
    fi
  done
}

# Package files end up in one tree, on file systems that may not tell letter cases apart.
check_letter_case() {
  files | tr '[:upper:]' '[:lower:]' | sort | uniq -d | while read -r file; do
    complain "$file: two files differ in letter case alone"
  done
}

# The banner is the same for all but the year and the authors.
check_banner() {
  local file=$1 line number=0
  local -a pattern=('Copyright \(c\) [0-9-]+ .+' 'All rights reserved\.' '' '\$URL(: .*)?\$'
    '\$Id(: .*)?\$' "SPDX-License-Identifier: $licence" '' 'Author\(s\)     : .+')
  while read -r line && [ "$number" -lt "${#pattern[@]}" ]; do
    [[ "$line" =~ ^//\ ?${pattern[number]}$ ]] ||
      complain "$file:$((number + 1)): the banner differs: $line"
    number=$((number + 1))
  done <"$file"
}

check_banners() {
  local file
  files 'include/*.h' 'src/*.h' 'src/*.cpp' | while read -r file; do check_banner "$file"; done
}

check_headers() {
  local header guard
  files 'include/*.h' | while read -r header; do
    guard=$(echo "${header#include/}" | tr '[:lower:]/.' '[:upper:]__')
    grep -qx "#ifndef $guard" "$header" && grep -qx "#define $guard" "$header" &&
      [ "$(tail -n 1 "$header")" = "#endif // $guard" ] ||
      complain "$header: the guard is not $guard, or not repeated at the end"
    [ "$header" = "include/CGAL/license/$package.h" ] ||
      [ "$(grep -m 1 '^#include' "$header")" = "#include <CGAL/license/$package.h>" ] ||
      complain "$header: CGAL/license/$package.h is not the first include"
  done
}

# Headers neither print nor end the program, are safe where min and max are macros, spell no type
# that later releases of CGAL replace, and open no namespace for those who include them.
check_header_code() {
  local words='std::(cerr|cout)|(assert|abort|exit)\(|std::(min|max)(<\w+>)?\(' line
  words+='|boost::(optional|variant)\b'
  words+='|numeric_limits<\w+>::(min|max)\(|\b(near|far|small)( = |;$|\[|\.[a-z]|[,)] \{$)'
  files 'include/*.h' |
    xargs -r grep -nP "^(?!\s*(//|\*)).*\b($words)|^using namespace|^#pragma once" |
    while read -r line; do complain "$line: not in a header"; done
}

# What begins a paragraph or a block of Doxygen's begins its line; filled lines hide it.
check_documentation_commands() {
  local commands='brief|t?param|returns?|pre|post|throws|sa|(in|addto)group' line
  commands+='|cgal(Param|NamedParams|Models)\w*'
  files 'include/*.h' 'doc/*.h' |
    xargs -r grep -nP "[^\s/*!]\s*\\\\($commands)\b" |
    while read -r line; do complain "$line: a command within a line"; done
}

# Each folder of programs names its project as CGAL wants it, and every source file in its list.
check_program_folders() {
  local kind folder list source
  for kind in examples:Examples test:Tests benchmark:Benchmark; do
    folder=${kind%%:*}/$package
    list=$folder/CMakeLists.txt
    [ -f "$list" ] || { complain "$folder: no CMakeLists.txt" && continue; }
    [[ "$(grep -vE '^(#|$)' "$list" | head -n 1)" == cmake_minimum_required* ]] ||
      complain "$list: cmake_minimum_required is not first"
    grep -q "^project(${package}_${kind##*:}\b" "$list" ||
      complain "$list: the project is not ${package}_${kind##*:}"
    files "$folder/*.cpp" | while read -r source; do
      source=${source#"$folder/"}
      grep -qF "$source" "$list" || complain "$list: $source is not in it"
    done
  done
}

# The version is told by the file VERSION; what cannot read it tells the same.
check_versions() {
  local version place file pattern
  version=$(<VERSION)
  [[ "$version" =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || complain "VERSION: not a version: $version"
  for place in 'CHANGES.md:^## \K[0-9][^ ]*' 'CITATION.cff:^version: \K.*' \
    'packaging/debian/changelog:^handle-tunnel-loops \(\K[^)]*' \
    'packaging/vcpkg/vcpkg.json:"version": "\K[^"]*' \
    'packaging/conda/meta.yaml:^{% set version = "\K[^"]*' \
    'packaging/homebrew/handle-tunnel-loops.rb:/handle-tunnel-loops-\K[0-9.]+(?=-source\.tar\.gz)'; do
    file=${place%%:*} pattern=${place#*:}
    [ "$(grep -oPm 1 "$pattern" "$file")" = "$version" ] || complain "$file: the version is not $version"
  done
  # Where it is read, it is not written.
  for file in CMakeLists.txt pyproject.toml setup.py packaging/vcpkg/portfile.cmake packaging/nix/default.nix packaging/docker/Dockerfile; do
    ! grep -qF "$version" "$file" || complain "$file: tells the version, which is in the file VERSION"
  done
}

check_package_info() {
  local info=package_info/$package file
  for file in copyright description.txt license.txt long_description.txt maintainer dependencies; do
    [ -s "$info/$file" ] || complain "$info/$file: missing or empty"
  done
  [ "$(wc -l <"$info/description.txt")" -eq 1 ] || complain "$info/description.txt: not one line"
  grep -qx 'GPL (v3 or later)' "$info/license.txt" || complain "$info/license.txt: not $licence"
}

# What is compiled for a device includes no header of CGAL, only of this package.
check_device_headers() {
  local header
  local included
  included=$(files 'cuda/*.cu' 'cuda/*.cuh' | xargs -r grep -h '^#include <CGAL/' | sort -u |
    "${CXX:-c++}" -std=c++17 -Iinclude -x c++ -M - | tr -s ' \\' '\n' | grep '/CGAL/')
  [ -n "$included" ] || complain "cuda: what it includes is not known"
  grep -v '^include/' <<<"$included" | while read -r header; do
    complain "cuda: includes $header"
  done
}

# The list was made with CGAL 5.5; other releases include other packages.
check_dependencies() {
  local list=package_info/$package/dependencies
  if ! grep -q '#define CGAL_VERSION 5\.5' "$cgal/CGAL/version.h" 2>/dev/null; then
    echo "$list: not checked, CGAL 5.5 is not in $cgal"
    return
  fi
  diff "$list" <(scripts/checks/package_dependencies.sh) >&2 ||
    complain "$list: not what scripts/checks/package_dependencies.sh prints"
}

# The manual lists the examples that there are, and shows no other.
check_manual_examples() {
  local example
  files 'examples/*.cpp' | while read -r example; do
    example=${example#examples/}
    grep -qx "\\\\example $example" "$manual/examples.txt" ||
      complain "$manual/examples.txt: $example is not in it"
  done
  cat "$manual"/*.txt | grep -oP '(\\example |\\cgalExample\{)\K[^}\s]+' | while read -r example; do
    [ -f "examples/$example" ] || complain "$manual: there is no example $example"
  done
}

check_manual_headers() {
  local header
  cat README.md "$manual"/*.txt | grep -oP '#include <\KCGAL/[^>]+' | sort -u |
    while read -r header; do
      [ -f "include/$header" ] || [ -f "$cgal/$header" ] ||
        complain "README.md or $manual: there is no header $header"
    done
}

# A documented named parameter is one of ours, or in the central list of CGAL.
check_named_parameters() {
  local ours=include/CGAL/$package/parameters.h name
  local theirs=$cgal/CGAL/STL_Extension/internal/parameters_interface.h
  [ -f "$theirs" ] || return
  files 'include/*.h' | xargs -r grep -hoP '\\cgalParamNBegin\{\K\w+' | sort -u |
    while read -r name; do
      grep -qzP "\(\w+,\s+\w+,\s+$name\)" "$ours" "$theirs" ||
        complain "include: there is no named parameter $name"
    done
}

check_manual_pictures() {
  local picture
  cat "$manual"/*.txt | grep -oP '(\\cgalFigureBegin\{\w+,|\\cgalPkgPicture\{)\K[^}]+' |
    while read -r picture; do
      [ -f "$manual/fig/$picture" ] || complain "$manual: there is no picture $picture"
      grep -q "fig/$picture" "$manual/Doxyfile.in" ||
        complain "$manual/Doxyfile.in: $picture is not in it"
    done
}

check_links() {
  local path
  grep -ohP '\]\(\K[^)#:]+(?=\))' README.md CHANGES.md | sort -u | while read -r path; do
    [ -e "$path" ] || complain "README.md or CHANGES.md: there is no $path"
  done
}

check_text
check_executable_bits
check_letter_case
check_banners
check_headers
check_header_code
check_documentation_commands
check_program_folders
check_versions
check_package_info
check_device_headers
check_dependencies
check_manual_examples
check_manual_headers
check_named_parameters
check_manual_pictures
check_links

if [ -s "$findings" ]; then
  sort -u "$findings" >&2
  echo "package: see above" >&2
  exit 1
fi
echo "package: all is well"
