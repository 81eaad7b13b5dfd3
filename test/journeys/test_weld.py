"""Meshes whose points are nearly at the same place: recognised, named, and welded where that makes a surface."""

import random
import re

import pytest

import judges
from mesh_files import read_off, torus, triangles_of, write_off, write_stl


def torn(points, triangles, distance, seed=1):
    """Each triangle with corners of its own, off by a little."""
    shake = random.Random(seed)
    corners = [tuple(x + shake.uniform(-distance, distance) for x in points[v]) for t in triangles for v in t]
    return corners, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(triangles))]


@pytest.fixture
def scan(tool):
    points, quads = torus(40, 20)
    return write_stl(tool.folder / "scan.stl", *torn(points, triangles_of(quads), 1e-6))


def test_nearly_welded_meshes_are_named(tool, scan):
    said = tool.run("loops", scan).stderr
    assert "4800 of 4800 boundary edges coincide with others" in said
    assert "1600 components are single triangles" in said and "--weld 0.001%" in said
    assert "nearly coincide" in tool.run("repair", scan, "--dry-run").stderr


@pytest.mark.parametrize("length", ["0.001%", "1e-5"])
def test_welding_gives_the_surface(tool, scan, length):
    tool.run("repair", scan, "--weld", length, "-o", "sound.off", "-q")
    facts = tool.facts("sound.off")
    assert (facts["components"], facts["boundaries"], facts["genus"], facts["faces"]) == (1, 0, 1, 1600)
    assert "nearly" not in tool.run("loops", "sound.off").stderr
    assert tool.facts(scan, "--weld", length)["genus"] == 1
    # The points that stay are points of the file.
    before, _ = tool.as_off(scan, "--steps", "degenerate")
    after, triangles = read_off(tool.folder / "sound.off")
    used = {v for t in triangles for v in t}
    assert len(used) == 800 and {after[v] for v in used} <= set(before)


def test_a_slicer_takes_it_for_a_solid(tool, scan):
    tool.run("repair", scan, "--weld", "0.001%", "-o", "sound.stl", "-q")
    assert judges.slicer(tool.folder / "sound.stl")["manifold"] == "yes"


def test_what_would_be_no_surface_is_refused_with_the_place(tool, scan):
    said = tool.run("repair", scan, "--weld", "0.5", "-o", "sound.off", code=4).stderr
    assert "faces along edge" in said and "near (" in said and "would not be a surface" in said
    assert not (tool.folder / "sound.off").exists()
    said = tool.run("repair", scan, "--weld", "20%", "-o", "sound.off", code=4).stderr
    assert re.search(r"--weld: a length of [0-9]+\.[0-9]{1,6} would join ", said)


@pytest.mark.parametrize("length", ["x", "-1", "0", "inf"])
def test_lengths_that_are_none_are_refused(tool, scan, length):
    tool.run("repair", scan, f"--weld={length}", "-o", "sound.off", code=2)
    assert not (tool.folder / "sound.off").exists()


def test_what_lies_exactly_there_is_for_the_repair(tool):
    points, quads = torus()
    triangles, n = triangles_of(quads), len(points)
    half = len(triangles) // 2
    halves = triangles[:half] + [tuple(v + n for v in t) for t in triangles[half:]]
    write_off(tool.folder / "halves.off", points + points, halves)
    said = tool.run("loops", "halves.off").stderr
    assert "48 of 48 boundary edges coincide with others" in said and "--repair welds them" in said
    assert tool.facts("halves.off", "--repair")["genus"] == 1


def test_boundaries_that_only_run_near_each_other_are_nothing_to_weld(tool):
    points, quads = torus()
    write_off(tool.folder / "open.off", points, triangles_of(quads)[2:])
    assert "note" not in tool.run("loops", "open.off").stderr


def test_two_sheets_are_not_pressed_together(tool):
    """Faces that share an edge stay apart, however coarse the length is."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 1e-7)]
    write_off(tool.folder / "sheet.off", points, [(0, 1, 2), (1, 3, 2)])
    tool.run("repair", "sheet.off", "--weld", "0.9", "-o", "same.off", "-q")
    assert read_off(tool.folder / "same.off")[1] == [(0, 1, 2), (1, 3, 2)]


def test_a_stray_vertex_makes_nothing_near(tool):
    """The length is of the boundary's box, and finding what is near takes no time that grows with its square."""
    points, quads = torus()
    corners, triangles = torn(points, triangles_of(quads), 1e-3)
    write_off(tool.folder / "stray.off", corners + [(1e6, 0, 0)], triangles)
    assert "nearly coincide" not in tool.run("loops", "stray.off").stderr
