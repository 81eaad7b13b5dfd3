"""What is written down is what happens."""

import doctest
import inspect
import pathlib
import re

import pytest
from conftest import write_off

import handle_tunnel_loops as htl

ROOT = pathlib.Path(__file__).parent.parent.parent


def blocks():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    yield from re.findall(r"```python\n(.*?)```", readme, re.DOTALL)
    for page in sorted((ROOT / "doc/Handle_tunnel_loops").glob("*.txt")):  # the guides are run by test/journeys
        yield from re.findall(r"\\code\{\.py\}\n(.*?)\\endcode", page.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("block", list(blocks()))
def test_code_runs(block, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "meshes").mkdir()
    for i in range(3):
        write_off(tmp_path / "meshes" / f"{i}.off", *htl.generate("torus", faces=400, seed=i))
    exec(compile(block, "documentation", "exec"), {"__name__": "__main__"})


def test_the_package_tells_the_truth():
    failures, tried = doctest.testmod(htl)
    assert tried > 0 and failures == 0


@pytest.mark.parametrize("name", htl.__all__)
def test_everything_is_said(name):
    thing = getattr(htl, name)
    assert inspect.getdoc(thing), f"{name} has no documentation"
    if inspect.isfunction(thing):
        for parameter in inspect.signature(thing).parameters.values():
            assert parameter.annotation is not inspect.Parameter.empty, f"{name}: {parameter}"


def test_there_are_blocks():
    assert len(list(blocks())) >= 1
