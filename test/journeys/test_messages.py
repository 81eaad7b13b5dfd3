"""What the tool says: options that help do, and the seconds are those that passed."""

import os
import pty
import random
import re
import select
import signal
import subprocess
import time

import pytest

from mesh_files import triangles_of, write_off


def cube(x=0, y=0, z=0):
    points = [(x + i, y + j, z + k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    return points, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def joined(*meshes):
    """Equal points become one."""
    numbers, faces = {}, []
    for points, own in meshes:
        faces += [tuple(numbers.setdefault(points[v], len(numbers)) for v in face) for face in own]
    return list(numbers), faces


def torn(points, faces, distance):
    """Each face with corners of its own, moved by up to that distance."""
    shake = random.Random(1)
    corners = [tuple(x + shake.uniform(0, distance) for x in points[v]) for face in faces for v in face]
    return corners, [tuple(range(3 * i, 3 * i + 3)) for i in range(len(faces))]


def defective_meshes():
    points, quads = cube()
    triangles = triangles_of(quads)
    cubes = joined(cube(), cube(1, 1, 0))  # with an edge of four faces
    cubes_as_triangles = cubes[0], triangles_of(cubes[1])
    bowtie = [(0, 0, 0), (0, 0, 1), (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)], \
        [(0, 1, 2), (1, 0, 3), (0, 1, 4), (1, 0, 5)]
    corner = joined(cube(), cube(1, 1, 1))
    return {
        "edge of four faces": cubes_as_triangles,
        "open edge of four faces": bowtie,
        "polygons": cube(),
        "polygons with an edge of four faces": cubes,
        "corner": (corner[0], triangles_of(corner[1])),
        "face twice": (points, triangles + triangles[:1]),
        "turned face": (points, [triangles[0][::-1]] + triangles[1:]),
        "degenerate face": (points, triangles + [(0, 0, 1)]),
        "torn": torn(points, triangles, 0),
        "nearly welded": torn(points, triangles, 1e-7),
        "nearly welded at an edge of four faces": torn(*cubes_as_triangles, 1e-7),
        "nearly welded bowtie": torn(*bowtie, 1e-7),
    }


COMMANDS = [["loops"], ["measure"], ["reeb"], ["cut", "-o", "out.obj"],
            ["remove", "--all", "-o", "out.off"], ["clean", "-o", "out.off"], ["repair", "-o", "out.off"]]


@pytest.mark.parametrize("name", defective_meshes())
def test_options_that_are_named_help(tool, name):
    write_off(tool.folder / "mesh.off", *defective_meshes()[name])
    told = 0
    for command, *options in COMMANDS:
        said = tool.run(command, "mesh.off", *options, code=None)
        named = re.findall(r"--[a-z-]+(?: [0-9.]+%)?", said.stderr)
        told += len(named) > 0 or "no option" in said.stderr
        if named:
            again = tool.run(command, "mesh.off", *options, *" ".join(named).split())
            assert not re.findall("--[a-z]", again.stderr)
        else:
            assert said.returncode in (0, 4), said.stderr
    assert told > 0


def test_options_that_are_named_for_lengths_help(tool):
    tool.run("generate", "torus", "--faces", 400, "-o", "torus.off", "-q")
    for command in (["remove", "torus.off", "-o", "out.off", "--shorter-than", 30],
                    ["remove", "torus.off", "-o", "out.off", "--noise-below", 2],
                    ["clean", "torus.off", "out.off", "--noise-below", 2]):
        assert "--yes" in tool.run(*command, code=2).stderr
        tool.run(*command, "--yes")


def on_terminal(tool, *words, seconds=60):
    """What the tool shows while it runs, and its exit code; Ctrl-C comes after these seconds."""
    terminal, other_end = pty.openpty()
    process = subprocess.Popen([os.environ["HTLOOPS"], *map(str, words)], cwd=tool.folder, stderr=other_end,
                               stdout=subprocess.DEVNULL)
    os.close(other_end)
    shown, begin = b"", time.perf_counter()
    is_interrupted = False
    while True:
        if not is_interrupted and time.perf_counter() - begin > seconds:
            is_interrupted = True
            process.send_signal(signal.SIGINT)
        if select.select([terminal], [], [], 0.05)[0]:
            try:
                shown += os.read(terminal, 65536)
            except OSError:  # the other end is closed
                break
        elif process.poll() is not None:
            break
    os.close(terminal)
    return shown.decode(), process.wait(60), time.perf_counter() - begin


def percentages(shown, what):
    return [int(percent) for percent in re.findall(r"(\d+)%  [\d.]+ s  " + what, shown)]


def test_each_step_begins_at_0_percent(tool):
    tool.run("generate", "torus", "--faces", 3000, "-o", "torus.off", "-q")
    shown, code, _ = on_terminal(tool, "measure", "torus.off")
    percents = percentages(shown, "measures")
    assert code == 0 and percents[0] == 0 and percents == sorted(percents)


def test_making_a_mesh_shows_how_far_it_is_and_can_be_interrupted(tool):
    shown, code, _ = on_terminal(tool, "generate", "gyroid", "--faces", 200000, "-o", "gyroid.off")
    percents = percentages(shown, "generate")
    assert code == 0 and percents == sorted(percents) and any(0 < percent < 100 for percent in percents)
    assert percentages(shown, "write")
    for kind in (["plates", "--faces", 400000, "--genus", 1], ["gyroid", "--faces", 6000000],
                 ["torus", "--faces", 8000000]):
        _, code, passed = on_terminal(tool, "generate", *kind, "-o", "large.off", seconds=0.5)
        assert code == 130 and passed < 5
    assert not (tool.folder / "large.off").exists()


def test_the_seconds_that_are_told_are_those_that_passed(tool):
    tool.run("generate", "scan", "--faces", 28000, "--bridges", 2, "--tunnels", 2, "-o", "scan.off", "-q")
    for command in (["loops"], ["loops", "--html", "page.html", "--gltf", "loops.glb"],
                    ["loops", "--removal", "--measure"], ["measure"],
                    ["reeb", "-o", "reeb.json"], ["skeleton", "--csv", "arcs.csv"],
                    ["cut", "-o", "open.obj", "--dual", "cuts.vtu"], ["remove", "--all", "-o", "ball.ply.gz"],
                    ["remove", "--noise-below", "3%", "-o", "clean.off"],
                    ["clean", "--genus", 1, "-o", "solid.3mf"]):
        begin = time.perf_counter()
        said = tool.run(command[0], "scan.off", *command[1:]).stdout
        passed = time.perf_counter() - begin
        line = next(line for line in reversed(said.splitlines()) if " of reading" in line)
        told = sum(map(float, re.findall(r"(?<!\()\b(\d+\.\d\d) s\b", line)))
        assert told == pytest.approx(passed, rel=0.1, abs=0.2), line
