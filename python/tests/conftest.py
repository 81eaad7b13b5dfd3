"""Meshes that several tests use."""

import os

import numpy as np
import pytest

import handle_tunnel_loops as htl


@pytest.fixture(scope="session")
def torus():
    return htl.generate("torus", faces=2000)


@pytest.fixture(scope="session")
def genus_3():
    return htl.generate("multi-torus", faces=4000, genus=3)


@pytest.fixture(scope="session")
def plate():
    """A surface of genus 0 with four boundary curves."""
    return htl.generate("sphere", faces=3000, holes=4, hole_faces=40)


@pytest.fixture(scope="session")
def htloops():
    """The program, of the same build."""
    if "HTLOOPS" not in os.environ:
        pytest.skip("HTLOOPS does not name the program")
    return os.environ["HTLOOPS"]


def write_off(path, V, F):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(V)} {len(F)} 0\n")
        np.savetxt(file, V, fmt="%.17g")
        np.savetxt(file, np.column_stack([np.full(len(F), 3), F]), fmt="%d")
