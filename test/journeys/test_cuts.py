"""Cuts, as solvers of fields and as Blender see them."""

import pathlib
import re

import pytest

import judges

HERE = pathlib.Path(__file__).parent


@pytest.mark.parametrize("mesh", [("--genus", 2, "--faces", 2000, "--holes", 4), ("--genus", 3, "--faces", 3000)])
@pytest.mark.parametrize("ending, module", [("msh", "gmsh"), ("msh2", "gmsh"), ("msh22", "gmsh"), ("vtu", "vtk"),
                                            ("binary.vtu", "vtk"), ("vtp", "vtk"), ("binary.vtp", "vtk")])
def test_each_dual_cut_crosses_its_own_loop_once_and_no_other(tool, mesh, ending, module):
    python = judges.python_with(module, "pvpython")
    tool.run("generate", "multi-torus", *mesh, "-o", "mesh.off", "-q")
    tool.run("loops", "mesh.off", "-o", "loops.json", "-q")
    tool.run("cut", "mesh.off", "--dual", f"cuts.{ending}", "-q")
    said = judges.script_says(python, "judge_dual_cuts.py", f"cuts.{ending}", "loops.json", folder=tool.folder)
    assert "cuts: each crosses its own loop once, and no other" in said


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Meshes of quadrangles and polygons that Blender has made."""
    folder = tmp_path_factory.mktemp("made")
    judges.program_in_blender(HERE / "make_in_blender.py", folder)
    return folder


@pytest.mark.parametrize("mesh", ["torus.obj", "tube.obj", "cylinder.obj", "monkey.obj", "torus.ply"])
def test_seams_are_what_blender_unwraps_along(tool, made, mesh):
    (tool.folder / mesh).write_bytes((made / mesh).read_bytes())
    (tool.folder / "elsewhere").mkdir()
    tool.run("cut", mesh, "--seams", "elsewhere/seams.py", "-q")
    said = judges.program_in_blender(HERE / "judge_in_blender.py", mesh, "elsewhere/seams.py", folder=tool.folder)
    assert re.search(f"JUDGED {mesh}: [1-9]", said)


def test_the_scene_is_kept_if_that_is_asked_for_and_a_missing_mesh_is_said(tool, made):
    (tool.folder / "torus.ply").write_bytes((made / "torus.ply").read_bytes())
    (tool.folder / "elsewhere").mkdir()
    program = tool.folder / "elsewhere" / "seams.py"
    tool.run("cut", "torus.ply", "--seams", program, "-q")
    said = judges.program_in_blender(program, tool.folder / "out.blend", folder=tool.folder)
    assert re.search("torus: [0-9]+ edges are seams", said) and (tool.folder / "out.blend").exists()
    (tool.folder / "torus.ply").rename(tool.folder / "gone.ply")
    said = judges.program_in_blender(program, folder=tool.folder, code=1)
    assert re.search("no object has the mesh of ../torus.ply, and .*torus.ply does not exist: import it first", said)
