"""The commands and the programs of the guides do what a reader expects: they run."""

import csv
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

from guides import DATA, GUIDES, commands_of, programs_of

by_name = pytest.mark.parametrize("guide", GUIDES, ids=lambda guide: guide.stem)


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """By guide: the folder in which its commands were run, and the first of them that failed."""
    if "HTLOOPS" not in os.environ:
        pytest.skip("HTLOOPS names no tool")
    tool = tmp_path_factory.mktemp("tool")
    (tool / "htloops").symlink_to(pathlib.Path(os.environ["HTLOOPS"]).resolve())
    environment = {**os.environ, "PATH": f"{tool}{os.pathsep}{os.environ['PATH']}"}
    known = {}

    def folder_of(guide):
        if guide not in known:
            folder = tmp_path_factory.mktemp(guide.stem)
            shutil.copytree(DATA, folder, dirs_exist_ok=True)
            known[guide] = folder, failure(guide, folder, environment)
        return known[guide]

    return folder_of


def failure(guide, folder, environment):
    for command, code in commands_of(guide):
        done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, capture_output=True, text=True,
                              timeout=300, check=False)
        if done.returncode != code:
            return f"{command}\nexit code {done.returncode}\n{done.stdout}\n{done.stderr}"
    return None


def test_there_are_guides():
    assert len(GUIDES) >= 10
    assert all(len(list(commands_of(guide))) > 0 or programs_of(guide) for guide in GUIDES)


@by_name
def test_commands_run(guide, folders):
    assert folders(guide)[1] is None


@by_name
def test_programs_run(guide, folders):
    program = programs_of(guide)
    if program and importlib.util.find_spec("handle_tunnel_loops") is None:
        pytest.skip("the module of Python is not there")
    folder, failed = folders(guide)
    assert failed is None
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True, timeout=300,
                          check=False)
    assert done.returncode == 0, done.stderr


def test_bores_are_those_of_the_guide(folders):
    folder, failed = folders(next(guide for guide in GUIDES if guide.stem == "bores_and_channels"))
    assert failed is None
    rows = list(csv.DictReader((folder / "bores.csv").read_text().splitlines()))
    assert sorted(round(float(row["diameter"]), 4) for row in rows) == [3.2, 3.2, 4.3, 5, 8.5, 12]
    balls = [line for line in (folder / "channels.pdb").read_text().splitlines() if line.startswith(("ATOM", "HETATM"))]
    assert len(balls) > 20
