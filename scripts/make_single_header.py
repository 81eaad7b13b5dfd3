"""Joins the headers and sources of the library in one header: see make_single_header.sh."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = ROOT / "include"
LICENCE = re.compile(r"(?://[^\n]*\n)+\n")
OWN = re.compile(r"^ *# *include <(CGAL/[^>]+)>.*$")
# Stays an include, which programs linked with the CUDA solver reach.
DEVICES = "/internal/device/"

joined = []
seen = set()


def join(path):
    """What a file includes comes where it is first included. Where that is under a condition, it comes again where
    it is included without: its guard sees to the rest."""
    text = path.read_text()
    depth = 0 if path.suffix == ".h" else 1  # a guard is no condition
    before = set()
    for line in text[LICENCE.match(text).end():].splitlines():
        name = OWN.match(line)
        if re.match(r" *# *if", line):
            depth += 1
            if depth == 2:
                before = set(seen)
        elif re.match(r" *# *endif", line):
            depth -= 1
            if depth == 1:
                seen.intersection_update(before)
        if not name or DEVICES in name[1] or not (INCLUDE / name[1]).exists():
            joined.append(line)
        elif name[1] not in seen:
            seen.add(name[1])
            join(INCLUDE / name[1])


def main():
    sources = sorted((ROOT / "src/library").glob("*/*.cpp"))
    joined.append(LICENCE.match(sources[0].read_text())[0])
    joined.append("#ifndef CGAL_HANDLE_TUNNEL_LOOPS_SINGLE_HPP\n#define CGAL_HANDLE_TUNNEL_LOOPS_SINGLE_HPP\n")
    # Reference_tag comes last: it is under a condition, and includes much.
    public = [path for path in INCLUDE.rglob("*.h") if "internal" not in path.parts]
    for path in sorted(public, key=lambda path: (path.name == "Reference_tag.h", path)):
        name = path.relative_to(INCLUDE).as_posix()
        if name not in seen:
            seen.add(name)
            join(path)
    joined.append("\n#ifdef CGAL_HANDLE_TUNNEL_LOOPS_IMPLEMENTATION\n")
    for path in sources:
        join(path)
    joined.append("\n#endif // CGAL_HANDLE_TUNNEL_LOOPS_IMPLEMENTATION\n\n#endif // CGAL_HANDLE_TUNNEL_LOOPS_SINGLE_HPP")
    text = "\n".join(joined) + "\n"
    pathlib.Path(sys.argv[1]).write_text(re.sub(r"\n{3,}", "\n\n", text))


main()
