"""What people come for: from the file that they have, by one command, to the file that they need."""

import csv
import json
import math
import pathlib

import pytest

import judges
from mesh_files import read_off, read_stl, torus, triangles_of, washer, write_off, write_stl


def test_who_prints_a_scan_gets_a_solid_without_its_noise(tool):
    """STL in millimeters with noise handles, to STL or 3MF for a slicer."""
    tool.run("generate", "scan", "--faces", 40000, "-o", "scan.stl", "-q")
    handles = tool.facts("scan.stl")["genus"]
    assert handles > 0
    for result in ("clean.stl", "clean.3mf"):
        tool.run("remove", "scan.stl", "--shorter-than", "3%", "-o", result, "-q")
        assert tool.facts(result)["genus"] < handles
        assert judges.slicer(tool.folder / result)["manifold"] == "yes"


def placed(mesh, scale, shift, is_turned=False):
    points, faces = mesh
    return ([tuple(scale * x + s for x, s in zip(p, shift)) for p in points],
            [tuple(reversed(f)) if is_turned else tuple(f) for f in faces])


def joined(*meshes):
    points, faces = [], []
    for own_points, own_faces in meshes:
        faces += [tuple(v + len(points) for v in f) for f in own_faces]
        points += own_points
    return points, faces


def test_who_makes_models_by_ai_gets_one_solid_that_a_slicer_fills(tool):
    """GLB by another program, with an inner wall, leaks, crumbs and a part that is inside out, to STL and 3MF."""
    tool.run("generate", "hollow", "--faces", 60000, "--genus", 0, "--necks", 3, "-o", "hollow.off", "-q")
    body = read_off(tool.folder / "hollow.off")
    points, quads = torus(around=16, across=8)
    ring = points, triangles_of(quads)
    crumbs = [placed(ring, 0.01, (0.1 * i - 0.2, 0.0, 2.5 + 0.2 * i)) for i in range(5)]
    bulb = placed(ring, 0.3, (0.0, 4.0, 0.0), is_turned=True)
    buried = placed(ring, 0.05, (0.0, 0.0, 0.3))
    write_off(tool.folder / "model.off", *joined(*crumbs[:2], body, bulb, buried, *crumbs[2:]))
    tool.run("repair", "model.off", "-o", "model.obj", "-q")
    judges.exported_by_assimp(tool.folder / "model.obj", tool.folder / "model.glb")
    told = tool.run("clean", "model.glb", "solid.stl", "--channels", "10%", "--report", "report.json",
                    "--html", "page.html")
    report = json.loads((tool.folder / "report.json").read_text())
    counts = {step["step"]: step["count"] for step in report["steps"]}
    assert (counts["channels"], counts["floaters"], counts["shells"]) == (3, 5, 2)
    assert counts["orient"] >= 1 and "channels" in told.stdout
    assert (report["after"]["parts"], report["after"]["genus"], report["after"]["boundaries"]) == (2, 1, 0)
    assert report["after"]["crossings"] == 0
    said = judges.manifold(*read_stl(tool.folder / "solid.stl"), tool.folder)
    assert said["status"] in ("0", "NoError") and said["genus"] == 1
    assert said["volume"] == pytest.approx(report["after"]["volume"], rel=1e-4)
    tool.run("clean", "model.glb", "solid.3mf", "--channels", "10%", "-q")
    for result, unit in ("solid.stl", 1.0), ("solid.3mf", 1000.0):  # metres, which 3MF says and STL cannot
        words = judges.slicer(tool.folder / result)
        assert words["manifold"] == "yes" and words["number_of_parts"] == "2"
        assert float(words["volume"]) == pytest.approx(report["after"]["volume"] * unit**3, rel=1e-3)


def test_who_prints_a_scan_with_holes_gets_a_closed_solid(tool):
    """STL with noise handles, holes and crumbs, to a 3MF without them."""
    tool.run("generate", "scan", "--faces", 40000, "-o", "scan.off", "-q")
    points, faces = read_off(tool.folder / "scan.off")
    faces = [f for i, f in enumerate(faces) if i % 997]
    points, quads = joined((points, faces), placed((torus()[0], triangles_of(torus()[1])), 1e-3, (9.0, 9.0, 9.0)))
    write_stl(tool.folder / "scan.stl", points, quads)
    before = tool.run("clean", "scan.stl", "--dry-run", "--report", "before.json")
    left = {s["step"]: s["left"] for s in json.loads((tool.folder / "before.json").read_text())["steps"]}
    assert left["handles"] and "--genus" in before.stdout
    tool.run("clean", "scan.stl", "clean.3mf", "--genus", 0, "--report", "report.json", "-q")
    report = json.loads((tool.folder / "report.json").read_text())
    assert report["before"]["boundaries"] > 10 and report["before"]["parts"] == 2
    assert report["after"]["boundaries"] == 0 and report["after"]["parts"] == 1
    assert report["after"]["genus"] < report["before"]["genus"]
    assert judges.slicer(tool.folder / "clean.3mf")["manifold"] == "yes"


def test_who_cleans_what_is_clean_gets_the_same(tool):
    """And who has nothing but a sheet is told that it is not closed, with the sheet."""
    points, quads = torus()
    write_off(tool.folder / "ring.off", points, triangles_of(quads))
    tool.run("clean", "ring.off", "same.off", "-q")
    assert read_off(tool.folder / "same.off") == read_off(tool.folder / "ring.off")
    write_off(tool.folder / "quads.off", points, quads[:-3])
    tool.run("clean", "quads.off", "open.off", "--skip", "holes", code=4)
    assert len(read_off(tool.folder / "open.off")[1]) == 2 * len(quads) - 6
    assert "--skip" in tool.run("clean", "ring.off", "same.off", "--skip", "hole", code=2).stderr
    assert "OUT" in tool.run("clean", "ring.off", code=2).stderr


def test_who_paints_textures_gets_seams_along_the_quadrangles(tool):
    """OBJ with quadrangles, to seams that Blender unwraps along."""
    points, quads = torus()
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points] + ["f " + " ".join(str(v + 1) for v in q) for q in quads]
    (tool.folder / "ring.obj").write_text("\n".join(lines) + "\n")
    tool.run("cut", "ring.obj", "--seams", "seams.py", "-q")
    judge = pathlib.Path(__file__).parent / "judge_in_blender.py"
    assert "JUDGED ring.obj" in judges.program_in_blender(judge, "ring.obj", "seams.py", folder=tool.folder)


def test_who_maps_a_cortex_gets_genus_0_and_a_map(tool):
    """A surface of FreeSurfer with handles, to one of genus 0 with the same vertices elsewhere."""
    nibabel = judges.nibabel()
    import numpy

    tool.run("generate", "multi-torus", "--genus", 2, "--faces", 6000, "-o", "brain.off", "-q")
    points, triangles = read_off(tool.folder / "brain.off")
    nibabel.freesurfer.write_geometry(tool.folder / "lh.orig.nofix", numpy.array(points), numpy.array(triangles))
    tool.run("remove", "lh.orig.nofix", "--all", "-o", "lh.orig", "--map", "map.json", "-q")
    found, faces = nibabel.freesurfer.read_geometry(tool.folder / "lh.orig")
    edges = {frozenset((int(t[i]), int(t[i - 1]))) for t in faces for i in range(3)}
    used = {int(v) for t in faces for v in t}
    assert len(used) - len(edges) + len(faces) == 2
    origins = json.loads((tool.folder / "map.json").read_text())
    new_to_old = origins["vertices"]["origins"] if isinstance(origins["vertices"], dict) else origins["vertices"]
    kept = 0
    for v in used:
        old = new_to_old[v]
        if old is not None and old >= 0:
            kept += 1
            assert found[v] == pytest.approx(points[old], abs=1e-5)
    assert kept > 0.8 * len(points)


def test_who_designs_parts_gets_holes_with_their_diameters(tool):
    """STL of a part with a bore, to a list."""
    points, quads = washer()
    write_stl(tool.folder / "part.stl", points, triangles_of(quads))
    tool.run("loops", "part.stl", "--csv", "bores.csv", "-q")
    row, = csv.DictReader((tool.folder / "bores.csv").open())
    assert row["diameter_of"] == "bore" and float(row["diameter"]) == pytest.approx(4.0, rel=1e-5)
    assert abs(float(row["axis_z"])) == pytest.approx(1.0, abs=1e-6)
    assert [float(row[c]) for c in "xyz"] == pytest.approx([0.0, 0.0, 0.5 * float(row["depth"])], abs=1e-6)


def test_who_solves_fields_gets_cuts_as_physical_groups(tool):
    """A surface of Gmsh, to the same with a group for each cut."""
    judges.make_msh(tool.folder / "ring.msh", 4.1, False)
    tool.run("cut", "ring.msh", "--dual", "cuts.msh", "-q")
    groups = judges.gmsh(tool.folder / "cuts.msh")["groups"]
    lines = {name: edges for name, (dimension, edges) in groups.items() if dimension == 1}
    assert len(lines) == 2 and all(lines.values())


def test_who_looks_at_molecules_gets_channels_with_radii(tool):
    """A surface with a hole, to a file for PyMOL and ChimeraX."""
    points, quads = torus(48, 24, 6.0, 2.0)
    write_off(tool.folder / "protein.off", points, triangles_of(quads))
    tool.run("measure", "protein.off", "--channels", "channel.pdb", "-q")
    atoms = [line for line in (tool.folder / "channel.pdb").read_text().splitlines() if line.startswith("HETATM")]
    radii = [float(line[60:66]) for line in atoms]
    places = [tuple(float(line[i:i + 8]) for i in (30, 38, 46)) for line in atoms]
    assert min(radii) == pytest.approx(4.0, abs=0.1)  # of the hole
    for (x, y, z), radius in zip(places, radii):
        assert radius == pytest.approx(math.hypot(math.hypot(x, y) - 6, z) - 2, abs=0.1)
    said = judges.pymol(tool.folder / "channel.pdb")
    assert said["atoms"] == len(atoms) and said["radii"] == pytest.approx(radii, abs=1e-4)


def ring_of_atoms(middle, large=9.0):
    """Places of atoms around a hole."""
    return [(middle[0] + (large + r) * math.cos(a), middle[1] + (large + r) * math.sin(a), middle[2] + z)
            for a in (math.pi * i / 8 for i in range(16)) for r, z in ((0, 0), (-1.5, 1.5), (-1.5, -1.5), (1.5, 1.5), (1.5, -1.5))]


def test_who_has_a_pqr_gets_channels_by_way_of_a_surface(tool):
    """Atoms, to their surface by PyMOL, to a channel that PyMOL shows beside them."""
    middle, radius = (5.0, -3.0, 2.0), 1.7
    atoms = ring_of_atoms(middle)
    rows = [f"ATOM  {i:5d}  C   GLY A{i:4d}    {x:8.3f}{y:8.3f}{z:8.3f}  0.0000 {radius:.4f}" for i, (x, y, z) in enumerate(atoms, 1)]
    (tool.folder / "ring.pqr").write_text("\n".join([*rows, "END"]) + "\n")
    judges.surface_by_pymol(tool.folder / "ring.pqr", tool.folder / "ring.obj")
    tool.run("measure", "ring.obj", "--repair", "--channels", "channel.pdb", "-q")
    lines = [line for line in (tool.folder / "channel.pdb").read_text().splitlines() if line.startswith("HETATM")]
    places = [tuple(float(line[i:i + 8]) for i in (30, 38, 46)) for line in lines]
    radii = [float(line[60:66]) for line in lines]
    for place, room in zip(places, radii):  # the surface goes around the atoms, and no farther than a probe fits
        distance = min(math.dist(place, atom) for atom in atoms) - radius
        assert distance - 1.4 < room < distance + 0.1
    assert 5 < min(radii) < 6
    narrowest = places[radii.index(min(radii))]
    assert math.dist(narrowest[:2], middle[:2]) < 0.5 and abs(narrowest[2] - middle[2]) < 3
    assert {place[2] > middle[2] for place in places} == {True, False}  # it leads through
    said = judges.pymol(tool.folder / "channel.pdb")
    assert said["atoms"] == len(lines) and said["radii"] == pytest.approx(radii, abs=1e-4)


def test_channels_come_in_other_formats_as_well(tool):
    points, quads = torus(48, 24, 6.0, 2.0)
    write_off(tool.folder / "protein.off", points, triangles_of(quads))
    tool.run("measure", "protein.off", "--channels", "channel.pdb", "-q")
    atoms = (tool.folder / "channel.pdb").read_text().count("HETATM")
    tool.run("measure", "protein.off", "--channels", "channel.bild", "-q")
    assert (tool.folder / "channel.bild").read_text().count(".sphere") == atoms
    tool.run("measure", "protein.off", "--channels", "channel.csv", "-q")
    assert len((tool.folder / "channel.csv").read_text().splitlines()) == atoms + 1


@pytest.mark.parametrize("words", [("loops", "--channels", "c.pdb"), ("measure", "--channels", "c.xyz")])
def test_channels_that_cannot_be_written_are_refused_before(tool, words):
    points, quads = torus()
    write_off(tool.folder / "ring.off", points, triangles_of(quads))
    tool.run(words[0], "ring.off", *words[1:], code=2)
    assert not (tool.folder / words[2]).exists()


def test_who_surveys_scans_gets_a_row_for_each(tool):
    """A folder, to one table with a row for each mesh, whatever happened to it."""
    scans = tool.folder / "scans"
    scans.mkdir()
    points, quads = torus()
    write_stl(scans / "a.stl", points, triangles_of(quads))
    (scans / "b.ply").write_text("ply\nnonsense\n")
    tool.run("generate", "sphere", "--faces", 500, "-o", scans / "c.glb", "-q")
    (scans / "notes.txt").write_text("no mesh")
    tool.run("loops", "scans", "--csv", "table.csv", "-q", code=3)
    rows = list(csv.DictReader((tool.folder / "table.csv").open()))
    assert [row["mesh"].rsplit("/", 1)[-1] for row in rows] == ["a.stl", "b.ply", "c.glb"]
    assert [row["genus"] for row in rows] == ["1", "", "0"] and rows[1]["error"]
    # Read by another program: the points of the first are those of the torus.
    assert len(read_stl(scans / "a.stl")[0]) == len(points)
