#!/usr/bin/env python3
"""Hashes of all that htloops answers, to compare before and after a change that is to change nothing.

    scripts/checks/hash_answers.py HTLOOPS [--generated N] [MESH...] > before.txt

A line for each mesh, command and file that it writes, the terminal's text among them: without times.
Meshes that are generated have seeds 1 to N, and shapes in turn. Compare two such files with diff.
"""

import argparse
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

COMMANDS = {
    "loops": "loops {mesh} -o loops.json --csv loops.csv --lines loops.ply --gltf loops.glb --waists",
    "throats": "loops {mesh} --throats --csv throats.csv --lines throats.vtp",
    "raw": "loops {mesh} --no-refine --no-tighten --no-coarsen -o raw.json --events events.json",
    "picture": "loops {mesh} --picture loops.png --html loops.html --size 400x300 --labels",
    "check": "check {mesh} loops.json",
    "measure": "measure {mesh} -o measures.json --csv measures.csv",
    "reeb": "reeb {mesh} -o reeb.json --csv reeb.csv --lines reeb.obj --graph reeb.dot --parts reeb.ply",
    "height": "reeb {mesh} --height 0,0,1 -o height.json",
    "skeleton": "skeleton {mesh} -o skeleton.json --swc skeleton.swc --graph skeleton.graphml",
    "cut": "cut {mesh} -o open.ply --dual dual.json --lines cut.obj --seams seams.py",
    "remove": "remove {mesh} -o sphere.off --all --force --report remove.json --map map.json --csv remove.csv",
    "clean": "clean {mesh} -o clean.stl --report clean.json --yes",
    "repair": "repair {mesh} -o repaired.obj",
}
SHAPES = ["scan", "lattice", "shell", "plates", "bars", "chain", "gyroid", "multi-torus"]
TIMES = [
    (re.compile(rb"\b[0-9.]+(e-?[0-9]+)? s\b"), b"TIME s"),
    (re.compile(rb'("timings": *)(\{[^}]*\}|[0-9.e+-]+)'), rb"\1TIME"),
]
TEXTS = {".json", ".csv", ".txt", ".html", ".jsonl", ".py"}


def without_times(data):
    for pattern, replacement in TIMES:
        data = pattern.sub(replacement, data)
    return data


def hash_of(data):
    return hashlib.sha256(data).hexdigest()[:16]


def answer(tool, command, mesh, folder, limit):
    """The hashes of what a command writes, by file."""
    before = {file: file.stat().st_mtime_ns for file in folder.iterdir()}
    words = [word.format(mesh=mesh) for word in command.split()]
    try:
        run = subprocess.run([tool, *words], cwd=folder, capture_output=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return {"exit": "over the time limit"}
    hashes = {"exit": str(run.returncode), "text": hash_of(without_times(run.stdout + run.stderr))}
    for file in sorted(folder.iterdir()):
        if before.get(file) != file.stat().st_mtime_ns:
            data = file.read_bytes()
            hashes[file.name] = hash_of(without_times(data) if file.suffix in TEXTS else data)
    return hashes


def generated(tool, number, folder):
    for seed in range(1, number + 1):
        shape = SHAPES[seed % len(SHAPES)]
        mesh = folder / f"{shape}_{seed}.off"
        words = ["generate", shape, "--seed", str(seed), "-o", str(mesh)]
        subprocess.run([tool, *words], capture_output=True, check=True)
        yield mesh


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("htloops", type=lambda name: str(pathlib.Path(name).resolve()))
    parser.add_argument("meshes", nargs="*", type=pathlib.Path)
    parser.add_argument("--generated", type=int, default=0, metavar="N")
    parser.add_argument("--limit", type=float, default=120., metavar="SECONDS", help="of a command")
    arguments = parser.parse_intermixed_args()
    with tempfile.TemporaryDirectory() as folder:
        meshes = [*arguments.meshes]
        meshes += generated(arguments.htloops, arguments.generated, pathlib.Path(folder))
        for mesh in meshes:
            with tempfile.TemporaryDirectory() as place:
                shutil.copy(mesh, place)
                for name, command in COMMANDS.items():
                    hashes = answer(arguments.htloops, command, mesh.name, pathlib.Path(place),
                                    arguments.limit)
                    for file, value in hashes.items():
                        print(mesh.name, name, file, value)
            sys.stdout.flush()


if __name__ == "__main__":
    main()
