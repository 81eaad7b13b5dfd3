#!/usr/bin/python3
"""Loops of other programs beside those of the package: right ones, lengths, time and memory.

    benchmark/python/compare_loops.py [--program NAME=COMMAND]... [OPTIONS] FOLDER|FILE...

Each mesh that is closed and of positive genus is written as OFF, and each COMMAND is called with this file and
the name of a text to write:

    seconds 0.25          without reading and writing; left out, the time of the whole process is taken
    handle 0 17 4 ...     the vertices of a loop, in order, the first not repeated
    tunnel 8 3 12 ...

Times are of the processor, and the package uses one thread. The judge is benchmark_judged_loops: loops are
right if they are a basis of H1 with integer coefficients, all handle loops bound inside and all tunnel loops
outside; with --only-bases, also if they bound nowhere, for programs that know no sides. Prints tables of
Markdown, for all programs and for each mesh.
"""

import argparse
import json
import math
import os
import pathlib
import shlex
import subprocess
import tempfile

SIZES = [(0, 3000), (3000, 10000), (10000, 100000), (100000, math.inf)]


def run(command, limit):
    """The standard output, the time of the processor in seconds, and the peak of memory in MB."""
    line = shlex.join(["timeout", str(limit)] + [str(word) for word in command])
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as error:
        with subprocess.Popen(line, shell=True, stdout=out, stderr=error) as child:
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        error.seek(0)
        if child.returncode == 124:
            raise RuntimeError(f"more than {limit} s")
        if child.returncode != 0:
            said = error.read().strip().splitlines()
            raise RuntimeError(said[-1] if said else f"exit code {child.returncode}")
        seconds = usage.ru_utime + usage.ru_stime
        return out.read(), seconds, usage.ru_maxrss / 1024


class Package:
    name = "Handle_tunnel_loops"

    def __init__(self, judge):
        self.judge = judge

    def answer(self, mesh, folder, limit):
        out, _, memory = run([self.judge, "find", mesh], limit)
        return dict(json.loads(out), memory=memory)


class Other:
    def __init__(self, judge, text):
        self.judge = judge
        self.name, _, command = text.partition("=")
        self.command = shlex.split(command)

    def answer(self, mesh, folder, limit):
        loops = folder / "loops.txt"
        loops.unlink(missing_ok=True)
        _, seconds, memory = run([*self.command, mesh, loops], limit)
        if not loops.is_file():
            raise RuntimeError("wrote no loops")
        for line in loops.read_text().splitlines():
            if line.startswith("seconds "):
                seconds = float(line.split()[1])
        out, _, _ = run([self.judge, "judge", mesh, loops], limit)
        return dict(json.loads(out), seconds=seconds, memory=memory)


def answer_of(program, mesh, folder, options):
    try:
        answer = program.answer(mesh, folder, options.limit)
        return dict(answer, right=answer["basis"]) if options.only_bases else answer
    except RuntimeError as failure:
        return dict(failure=str(failure))


def report(name, mesh, answers):
    cells = [name, mesh["faces"], mesh["genus"], mesh["components"], "yes" if mesh["crosses_itself"] else ""]
    for a in answers:
        if "failure" in a:
            cells += [a["failure"].replace("|", "/")[:60], "", "", "", ""]
        else:
            cells += ["yes" if a["right"] else "no", f"{a['inside']}, {a['outside']}", f"{a['length']:.6g}",
                      f"{a['seconds']:.3f}", f"{a['memory']:.0f}"]  # fmt: skip
    print("|", " | ".join(map(str, cells)), "|", flush=True)


def mean(ratios):
    return math.exp(sum(map(math.log, ratios)) / len(ratios))


def is_right(answer):
    return answer.get("right", False)


def table(head):
    print("\n|", " | ".join(head), "|\n|", " | ".join(["---"] * len(head)), "|")


def compare_answers(programs, rows):
    table(["program", "meshes", "right", "not right", "no answer", "right, of those in one component"])
    single = [row for row in rows if row[0]["components"] == 1]
    for i, program in enumerate(programs):
        answers = [row[1][i] for row in rows]
        failed = sum("failure" in a for a in answers)
        right = sum(map(is_right, answers))
        right_of_single = sum(is_right(row[1][i]) for row in single)
        print(f"| {program.name} | {len(rows)} | {right} | {len(rows) - right - failed} | {failed} "
              f"| {right_of_single} of {len(single)} |")  # fmt: skip


def compare_with(i, programs, rows):
    """Lengths where both are right, time and memory where both answered; the package over the other."""
    print(f"\n{programs[0].name} over {programs[i].name}, geometric means, least and most:")
    table(["faces", "lengths where both are right", "seconds", "memory of the process"])
    for least, most in SIZES:
        both = [(a[0], a[i]) for mesh, a in rows
                if least <= mesh["faces"] < most and "failure" not in a[0] and "failure" not in a[i]]  # fmt: skip
        cells = [f"{least:,} to {most:,}" if most < math.inf else f"{least:,} or more"]
        for key in ("length", "seconds", "memory"):
            pairs = [(a, b) for a, b in both if key != "length" or is_right(a) and is_right(b)]
            ratios = [a[key] / b[key] for a, b in pairs if b[key] > 0]
            cells.append(f"{mean(ratios):.3f} ({min(ratios):.3f} to {max(ratios):.3f}) on {len(ratios)}"
                         if ratios else "")  # fmt: skip
        print("|", " | ".join(cells), "|")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+", type=pathlib.Path, metavar="FOLDER|FILE")
    parser.add_argument("--program", action="append", default=[], metavar="NAME=COMMAND")
    parser.add_argument("--judge", default="build/benchmark/Handle_tunnel_loops/benchmark_judged_loops")
    parser.add_argument("--largest", type=int, default=200000, help="faces of the largest mesh to take")
    parser.add_argument("--limit", type=int, default=120, help="seconds for each program and mesh")
    parser.add_argument("--only-bases", action="store_true", help="do not ask where loops bound")
    options = parser.parse_args()

    programs = [Package(options.judge)]
    programs += [Other(options.judge, text) for text in options.program]
    files = [f for m in options.meshes for f in (sorted(m.iterdir()) if m.is_dir() else [m])]
    table(["mesh", "faces", "genus", "components", "crosses itself"]
          + [f"{p.name}: {what}" for p in programs for what in
             ("right", "inside, outside", "length", "s", "MB")])  # fmt: skip
    rows = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for file in files:
            try:
                mesh = json.loads(run([options.judge, "write", file, folder / "mesh.off"], options.limit)[0])
            except RuntimeError as failure:
                print(f"| {file.stem} | left out: {failure} |")
                continue
            if mesh["genus"] == 0 or mesh["faces"] > options.largest:
                continue
            answers = [answer_of(p, folder / "mesh.off", folder, options) for p in programs]
            report(file.stem, mesh, answers)
            rows.append((mesh, answers))
    compare_answers(programs, rows)
    for i in range(1, len(programs)):
        compare_with(i, programs, rows)


if __name__ == "__main__":
    main()
