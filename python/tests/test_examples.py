"""The examples run, and do what they say."""

import importlib.util
import pathlib

import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).parent.parent / "examples"


def example(name):
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_all_are_tried():
    tried = ["circuit_of_plate", "plot_loops", "remove_tunnels_in_box", "segmented_volume",
             "skeleton_to_swc"]
    assert sorted(path.stem for path in EXAMPLES.glob("*.py")) == tried


def test_remove_tunnels_in_box(tmp_path):
    report = example("remove_tunnels_in_box").main(None, tmp_path / "a.obj")
    assert 0 < len(report["removed"]) == report["genus_before"] - report["genus_after"]
    assert 0 < report["genus_after"]
    assert (tmp_path / "a.obj").read_text().startswith("v ")


def test_circuit_of_plate(tmp_path):
    from conftest import write_off

    import handle_tunnel_loops as htl

    module = example("circuit_of_plate")
    assert np.array_equal(module.main(), np.eye(4))
    write_off(
        tmp_path / "a.off", *htl.generate("multi-torus", faces=2500, genus=2, holes=2, hole_faces=20)
    )
    matrix = module.main(tmp_path / "a.off")
    assert np.array_equal(np.abs(matrix), np.eye(5))


def test_segmented_volume():
    report = example("segmented_volume").main()
    assert report["genus_before"] > 0 and report["genus_after"] == 0


def test_skeleton_to_swc(tmp_path):
    S = example("skeleton_to_swc").main(None, tmp_path / "a.swc")
    assert S.number_of_cycles > 0
    assert (tmp_path / "a.swc").read_text().count("# cycle:") == S.number_of_cycles


def test_plot_loops(tmp_path):
    pytest.importorskip("matplotlib")
    example("plot_loops").main(None, tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
