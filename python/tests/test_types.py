"""What type checkers know of the module."""

import pathlib
import subprocess
import sys

import pytest

import handle_tunnel_loops as htl

PROGRAM = """
import handle_tunnel_loops as htl
V, F = htl.generate("torus", faces=2000)
L = htl.loops(V, F, basis="shortest")
htl.remove_handles(V, F, shorter_than="3%", by="cut")
htl.reeb(V, F, measure="area", drawing="inside")
htl.repair(V, F, steps=["weld", "split"])
for handle, tunnel in L:
    print(handle.length - tunnel.length)
"""


@pytest.fixture(scope="module")
def errors(tmp_path_factory):
    pytest.importorskip("mypy", reason="mypy is not installed")
    folder = tmp_path_factory.mktemp("mypy")
    package = pathlib.Path(htl.__file__).parent.parent

    def find(program):
        (folder / "program.py").write_text(program)
        command = [sys.executable, "-m", "mypy", "--ignore-missing-imports", "program.py"]
        return subprocess.run(
            command, cwd=folder, env={"MYPYPATH": str(package)}, capture_output=True, text=True
        ).stdout

    return find


def test_what_is_right_is_found_right(errors):
    assert "Success" in errors(PROGRAM), errors(PROGRAM)


@pytest.mark.parametrize(
    "right, wrong",
    [
        ('basis="shortest"', 'basis="shrt"'),
        ('by="cut"', 'by="cat"'),
        ('measure="area"', 'measure="areas"'),
        ('drawing="inside"', 'drawing="outside"'),
        ('"weld"', '"wield"'),
    ],
)
def test_words_that_there_are_not(errors, right, wrong):
    found = errors(PROGRAM.replace(right, wrong))
    assert "program.py" in found and "Literal[" in found and "Found 1 error" in found, found
