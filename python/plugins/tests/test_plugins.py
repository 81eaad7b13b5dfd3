"""The plug-ins, in their programs. HTL_BUILD is a build of which they are installed; without it they are taken as they
are, with the module that PYTHONPATH names."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "test" / "journeys"))

import judges

VERSION = f"{sys.version_info[0]}.{sys.version_info[1]}"  # that the module is built for


def checks_of(program):
    return re.findall(r"^@check\ndef (\w+)", (HERE / program).read_text(), re.MULTILINE)


class Installed:
    def __init__(self, plugins, module):
        self.plugins, self.module = plugins, module


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    if "HTL_BUILD" not in os.environ:
        folders = [f for f in os.environ.get("PYTHONPATH", "").split(":") if (pathlib.Path(f) / "handle_tunnel_loops").is_dir()]
        if not folders:
            pytest.skip("neither HTL_BUILD nor PYTHONPATH names a module of Python")
        return Installed(HERE.parent, pathlib.Path(folders[0]).resolve())
    prefix = tmp_path_factory.mktemp("prefix")
    subprocess.run([shutil.which("cmake"), "--install", os.environ["HTL_BUILD"], "--prefix", prefix, "--component", "python"],
                   check=True, capture_output=True, timeout=120)
    module, = prefix.rglob("handle_tunnel_loops/__init__.py")
    return Installed(prefix / "share" / "handle_tunnel_loops" / "plugins", module.parents[1])


def failures(output):
    said = [json.loads(line[len("JUDGED "):]) for line in output.splitlines() if line.startswith("JUDGED ")]
    versions = [one["python"] for one in said if "python" in one]
    assert versions, output[-3000:]
    if versions[0] != VERSION:
        pytest.skip(f"its Python is {versions[0]}, and the module is built for {VERSION}")
    return {one["check"]: one["failure"] for one in said if "check" in one}


@pytest.fixture(scope="module")
def in_blender(installed, tmp_path_factory):
    folder = tmp_path_factory.mktemp("blender")
    (folder / "scripts" / "addons").mkdir(parents=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", "")
        patch.setenv("BLENDER_USER_SCRIPTS", str(folder / "scripts"))
        return failures(judges.program_in_blender(
            HERE / "in_blender.py", installed.plugins / "handle_tunnel_loops_blender.py", installed.module, folder / "picture.png",
            VERSION))


@pytest.fixture(scope="module")
def in_paraview(installed, tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", "" if "HTL_BUILD" in os.environ else str(installed.module))
        patch.setenv("LIBGL_ALWAYS_SOFTWARE", "1")
        return failures(judges.program_in_paraview(HERE / "in_paraview.py", installed.plugins,
                                                   tmp_path_factory.mktemp("paraview") / "picture.png", VERSION))


@pytest.mark.parametrize("check", checks_of("in_blender.py"))
def test_in_blender(in_blender, check):
    assert in_blender[check] == ""


@pytest.mark.parametrize("check", checks_of("in_paraview.py"))
def test_in_paraview(in_paraview, check):
    assert in_paraview[check] == ""


def test_paraview_says_that_the_module_is_missing(installed, tmp_path):
    shutil.copy(installed.plugins / "handle_tunnel_loops_paraview.py", tmp_path)
    (tmp_path / "use.py").write_text("""
import handle_tunnel_loops_paraview
handle_tunnel_loops_paraview.load(globals())
from paraview import simple
loops = HandleTunnelLoops(Input=simple.Superquadric())
loops.UpdatePipeline()
print("cells:", loops.GetDataInformation().GetNumberOfCells())
""")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(tmp_path))
        said = judges.program_in_paraview(tmp_path / "use.py")
    assert re.search(r"Python 3\.\d+ does not find the module handle_tunnel_loops", said) and "Traceback" not in said
    assert "cells: 0" in said
