"""The commands and the programs of the guides run, and print what the guides show."""

import csv
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

from guides import DATA, GUIDES, first_line_not_in, steps_of

by_name = pytest.mark.parametrize("guide", GUIDES, ids=lambda guide: guide.stem)


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """By guide: the folder in which its steps were done, and the first thing in it that was not as it says."""
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
    for step in steps_of(guide):
        results = errors = ""
        for command, code in step.commands:
            done = run(["bash", "-c", command], folder, environment)
            if done.returncode != code:
                return f"{command}\nexit code {done.returncode}\n{done.stdout}\n{done.stderr}"
            results, errors = results + done.stdout, errors + done.stderr
        files = (file.read_text(errors="ignore") for file in folder.iterdir() if file.is_file())
        missing = first_line_in_none(step.shown, errors + results, results + errors, *files)
        if step.commands and missing:
            return f"{step.commands} do not show\n{missing}\nbut\n{results}{errors}"
    return None


def first_line_in_none(shown, *texts):
    """The first line shown that is not in the first of the texts, unless one of them has all of the lines."""
    missing = [first_line_not_in(shown, text) for text in texts]
    return missing[0] if None not in missing else None


def run(command, folder, environment=None):
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=300, check=False)


def test_there_are_guides():
    assert len(GUIDES) >= 10
    assert all(steps_of(guide) for guide in GUIDES)
    assert sum(len(step.shown) for guide in GUIDES for step in steps_of(guide)) > 100


@by_name
def test_commands_print_what_is_shown(guide, folders):
    assert folders(guide)[1] is None


@by_name
def test_programs_print_what_is_shown(guide, folders):
    programs = [step for step in steps_of(guide) if step.program]
    if programs and importlib.util.find_spec("handle_tunnel_loops") is None:
        pytest.skip("the module of Python is not there")
    folder, failed = folders(guide)
    assert failed is None
    done = run([sys.executable, "-c", "\n".join(step.program for step in programs)], folder)
    assert done.returncode == 0, done.stderr
    assert first_line_not_in([line for step in programs for line in step.shown], done.stdout) is None, done.stdout


def test_bores_are_those_of_the_guide(folders):
    folder, failed = folders(next(guide for guide in GUIDES if guide.stem == "bores_and_channels"))
    assert failed is None
    rows = list(csv.DictReader((folder / "bores.csv").read_text().splitlines()))
    assert sorted(round(float(row["diameter"]), 4) for row in rows) == [3.2, 3.2, 4.3, 5, 8.5, 12]
    balls = [line for line in (folder / "channels.pdb").read_text().splitlines() if line.startswith(("ATOM", "HETATM"))]
    assert len(balls) > 20
