"""What the module of Python takes beside the program: time, memory, and many meshes on two workers.

    PYTHONPATH=build/python HTLOOPS=build/bin/htloops python3 benchmark/python/benchmark_module.py [RUNS]

The program reads the file and computes; the module gets arrays. Each run is a process of its own, of the
one and the other by turns. Prints tables of Markdown.
"""

import concurrent.futures
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

MESHES = [
    ("torus", dict(faces=1000000)),
    ("multi-torus", dict(faces=1000000, genus=250)),
    ("gyroid", dict(faces=1000000, genus=250)),
]

CHILD = """
import json, resource, sys, time
import numpy as np
import handle_tunnel_loops as htl
arrays = np.load(sys.argv[1])
V, F = arrays["V"], arrays["F"]
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
before, start = peak(), time.perf_counter()
L = htl.loops(V, F)
seconds = time.perf_counter() - start
print(json.dumps(dict(seconds=seconds, solve=L.seconds["total"], before=before, peak=peak(),
                      arrays=V.nbytes + F.nbytes, genus=L.genus)))
"""


def of_module(folder):
    command = [sys.executable, "-c", CHILD, folder / "a.npz"]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def of_program(folder):
    command = [os.environ["HTLOOPS"], "loops", folder / "a.off", "-q", "-o", folder / "a.json"]
    with subprocess.Popen(command) as child:
        _, _, usage = os.wait4(child.pid, 0)
        child.returncode = 0
    times = json.loads((folder / "a.json").read_text())["timings"]
    return dict(solve=times["total"], read=times["read"], peak=usage.ru_maxrss * 1024)


def compare(runs, folder):
    import numpy as np

    import handle_tunnel_loops as htl

    print("| mesh | module, s | of which solving | program: reading, s | solving, s | module / program in all "
          "| least, most | solving / solving | more memory of the module, bytes per face "
          "| its arrays, bytes per face |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    for kind, options in MESHES:
        V, F = htl.generate(kind, **options)
        np.savez(folder / "a.npz", V=V, F=F)
        arguments = [f"--{key}={value}" for key, value in options.items()]
        subprocess.run(
            [os.environ["HTLOOPS"], "generate", kind, *arguments, "-q", "-o", folder / "a.off"], check=True
        )
        module, program = [], []
        for _ in range(runs):
            module.append(of_module(folder))
            program.append(of_program(folder))
        ratios = [m["seconds"] / (p["read"] + p["solve"]) for m, p in zip(module, program)]
        solving = [m["solve"] / p["solve"] for m, p in zip(module, program)]

        def median(records, key):
            return statistics.median(record[key] for record in records)

        more = (median(module, "peak") - median(program, "peak")) / len(F)
        print(f"| {kind} {options} | {median(module, 'seconds'):.2f} | {median(module, 'solve'):.2f} "
              f"| {median(program, 'read'):.2f} | {median(program, 'solve'):.2f} "
              f"| {statistics.median(ratios):.2f} | {min(ratios):.2f}, {max(ratios):.2f} "
              f"| {statistics.median(solving):.2f} | {more:.0f} "
              f"| {module[0]['arrays'] / len(F):.0f} |", flush=True)


def survey(runs, folder):
    import handle_tunnel_loops as htl

    paths = []
    for i in range(500):
        paths.append(folder / f"{i}.off")
        arguments = ["--faces", str(4000 + 40 * i), "--genus", str(1 + i % 7), "--seed", str(i)]
        subprocess.run([os.environ["HTLOOPS"], "generate", "multi-torus", *arguments, "-q", "-o", paths[-1]],
                       check=True)
    print()
    print("| 500 meshes, s | sum of their times / 2, s | ratio |")
    print("| --- | --- | --- |")
    for _ in range(runs):
        with concurrent.futures.ProcessPoolExecutor(2) as executor:
            list(executor.map(abs, range(8)))  # they are there
            start = time.perf_counter()
            rows = htl.survey(paths, folder / "table.csv", executor, resume=False)
            seconds = time.perf_counter() - start
        ideal = sum(row["seconds"] for row in rows) / 2
        print(f"| {seconds:.2f} | {ideal:.2f} | {seconds / ideal:.3f} |", flush=True)


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    with tempfile.TemporaryDirectory() as name:
        compare(number, pathlib.Path(name))
        survey(number, pathlib.Path(name))
