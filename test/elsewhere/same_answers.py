"""Whether two programs htloops, of this machine and of another kind, write the same, to the last digit.

    same_answers.py NATIVE FOLDER COMMAND [ARGUMENT...]

NATIVE is the program of this machine; COMMAND with its arguments is the other one, say "wine htloops.exe". Both
make the same meshes in FOLDER, and compute the same on these. All that is written must be equal but what
tells of the program itself and of time.
"""

import csv
import json
import pathlib
import subprocess
import sys
import time

KINDS = [  # with the least faces that show them
    ("torus", 1200), ("knot", 1200), ("trefoil", 1600), ("torus-link", 1200), ("borromean", 2100), ("ladder", 12600),
    ("multi-torus --genus 3", 1200), ("gyroid --genus 2", 1200), ("lattice --genus 4", 1400), ("sponge --genus 5", 1200),
    ("waves", 12000), ("chair", 11000), ("coral", 4900), ("sphere", 1200), ("hubs", 1200), ("plates --genus 2", 1200),
    ("bores", 1600), ("interlaced --genus 5", 3000), ("bars", 3000), ("random --genus 3 --seed 4", 1200)]  # fmt: skip

RECIPES = [(*kind.split(), "--faces", str(more + least)) for more in (0, 2000) for kind, least in KINDS]

NOT_COMPARED = {"tool", "timings", "threads", "seconds", "mesh_file"}


def told(path):
    """What a file says, numbers as they are written."""
    if path.suffix == ".json":
        return without(json.loads(path.read_text(), parse_float=str))
    if path.suffix == ".csv":
        with path.open(newline="") as file:
            return [without(row) for row in csv.DictReader(file)]
    return path.read_bytes()


def without(value):
    if isinstance(value, dict):
        return {key: without(part) for key, part in value.items() if key not in NOT_COMPARED}
    return [without(part) for part in value] if isinstance(value, list) else value


def differences(mine, other, where=""):
    """Names a few places where these differ."""
    if type(mine) is not type(other):
        return [f"{where}: {mine!r} {other!r}"[:200]]
    if isinstance(mine, dict):
        keys = sorted(set(mine) | set(other))
        return [d for k in keys for d in differences(mine.get(k), other.get(k), f"{where}/{k}")]
    if isinstance(mine, list) and len(mine) == len(other):
        return [d for i, pair in enumerate(zip(mine, other)) for d in differences(*pair, f"{where}/{i}")]
    return [] if mine == other else [f"{where}: {mine!r:.90} is there {other!r:.90}"]


class Program:
    def __init__(self, command, folder):
        self.command = command
        self.folder = folder
        self.seconds = 0.0
        folder.mkdir(parents=True, exist_ok=True)

    def run(self, *arguments):
        """The exit code."""
        begin = time.monotonic()
        done = subprocess.run([*self.command, *arguments], cwd=self.folder, capture_output=True)
        self.seconds += time.monotonic() - begin
        if done.returncode not in (0, 1):
            print(*arguments, done.stderr.decode(errors="replace"))
        return done.returncode


def commands(name):
    """What is computed, and the files that it writes."""
    mesh = f"{name}.off"
    yield ("loops", mesh, "-o", f"{name}.json", "--csv", f"{name}.csv", "-q"), [f"{name}.json", f"{name}.csv"]
    yield ("check", mesh, f"{name}.json", "-q"), []
    yield ("measure", mesh, "--csv", f"{name}.measures.csv", "-q"), [f"{name}.measures.csv"]
    yield ("remove", mesh, "-o", f"{name}.ball.off", "--all", "-q"), [f"{name}.ball.off"]
    yield ("reeb", mesh, "-o", f"{name}.reeb.json", "-q"), [f"{name}.reeb.json"]
    yield ("cut", mesh, "-o", f"{name}.open.obj", "-q"), [f"{name}.open.obj"]
    if name.endswith("1200"):  # it takes longest
        yield ("skeleton", mesh, "-o", f"{name}.skeleton.json", "-q"), [f"{name}.skeleton.json"]


def main(native, folder, *command):
    folder = pathlib.Path(folder)
    mine, other = Program([native], folder / "native"), Program(command, folder / "other")
    failures = []
    number = 0
    for recipe in RECIPES:
        name = f"{recipe[0]}_{recipe[-1]}"
        steps = [(("generate", *recipe, "-o", f"{name}.off", "-q"), [f"{name}.off"]), *commands(name)]
        for arguments, files in steps:
            codes = mine.run(*arguments), other.run(*arguments)
            found = [] if codes[0] == codes[1] else [f"exit codes {codes}"]
            for file in files:
                paths = mine.folder / file, other.folder / file
                if paths[0].exists() != paths[1].exists():
                    found.append(f"{file}: only one wrote it")
                elif paths[0].exists():
                    found += differences(told(paths[0]), told(paths[1]), file)
                    number += 1
            if found:
                failures.append(arguments)
                print("htloops", *arguments, *found[:4], sep="\n  ", flush=True)
    print(f"{number} files of {len(RECIPES)} meshes; {mine.seconds:.1f} s here, {other.seconds:.1f} s there")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
