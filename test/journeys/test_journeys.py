"""What people come for: from the file that they have, by one command, to the file that they need."""

import csv
import json
import math

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


def test_who_paints_textures_gets_charts_of_the_quadrangles(tool):
    """OBJ with quadrangles, to an OBJ with texture coordinates and the same quadrangles."""
    points, quads = torus()
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points] + ["f " + " ".join(str(v + 1) for v in q) for q in quads]
    (tool.folder / "ring.obj").write_text("\n".join(lines) + "\n")
    tool.run("cut", "ring.obj", "--uv", "charts.obj", "--seams", "seams.py", "-q")
    said = judges.blender(
        """
mesh = load(arguments[0])[0].data
say(quads=sum(len(p.vertices) == 4 for p in mesh.polygons), layers=len(mesh.uv_layers),
    points=len(mesh.vertices))
""",
        tool.folder / "charts.obj",
    )
    assert said == {"quads": len(quads), "layers": 1, "points": len(points)}
    compile((tool.folder / "seams.py").read_text(), "seams.py", "exec")


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
