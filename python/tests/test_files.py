"""Meshes that are written, and pictures."""

import gzip
import types

import numpy as np
import pytest

import handle_tunnel_loops as htl

EXACT = [".off", ".obj", ".ply", ".ascii.stl", ".vtp", ".binary.vtp", ".vtu", ".binary.vtu", ".msh", ".msh2", ".off.gz"]
OPTIONAL = [".3mf", ".glb"]  # their readers are libraries that a build may lack
SINGLE = [".stl", ".gii", ".surf"]


@pytest.mark.parametrize("end", EXACT + SINGLE + OPTIONAL)
def test_what_is_written_is_read(torus, tmp_path, end):
    V, F = torus
    path = tmp_path / f"mesh{end}"
    htl.write(path, V, F)
    try:
        new_V, new_F = htl.read(path, repair="stl" in end)
    except (OSError, ValueError) as error:
        if end in OPTIONAL and "this build cannot read" in str(error):
            pytest.skip(str(error))
        raise
    given, found = V[F], new_V[new_F]
    assert given.shape == found.shape
    if end in EXACT:
        assert np.array_equal(given, found)
    else:
        assert np.allclose(given, found, atol=1e-6)
    assert htl.loops(new_V, new_F).genus == 1


def test_objects_are_written(torus, tmp_path):
    V, F = torus
    htl.write(tmp_path / "a.off", types.SimpleNamespace(vertices=V, faces=F))
    assert np.array_equal(htl.read(tmp_path / "a.off")[1], F)
    htl.write(tmp_path / "b.off", V, F[:7])  # with vertices of no face
    htl.write(tmp_path / "c.off", V, F[:1, ::-1].repeat(2, axis=0))  # no surface
    assert (tmp_path / "c.off").stat().st_size > 0


def test_what_is_packed(torus, tmp_path):
    htl.write(tmp_path / "a.off.gz", *torus)
    assert gzip.decompress((tmp_path / "a.off.gz").read_bytes()).startswith(b"OFF")


def test_what_is_not_written(torus, tmp_path):
    V, F = torus
    for name in ("a.step", "a", "a.gz"):
        with pytest.raises(ValueError, match=r"\.off"):
            htl.write(tmp_path / name, V, F)
    with pytest.raises(OSError):
        htl.write(tmp_path / "no" / "a.off", V, F)
    with pytest.raises(ValueError, match="name of a file"):
        htl.write("-", V, F)
    with pytest.raises(htl.MeshError, match="refers to vertex"):
        htl.write(tmp_path / "a.off", V[:5], F)
    assert list(tmp_path.iterdir()) == []


def test_pictures(torus, tmp_path):
    if not htl.has_pictures:
        with pytest.raises(ValueError, match="without libpng"):
            htl.picture(*torus, htl.loops(*torus))
        pytest.skip("this build makes no pictures")
    L = htl.loops(*torus)
    content = htl.picture(*torus, L, size=(120, 90))
    assert content.startswith(b"\x89PNG") and content[16:24] == bytes([0, 0, 0, 120, 0, 0, 0, 90])
    assert htl.picture(torus, L, tmp_path / "a.png", size=(120, 90)) is None
    assert (tmp_path / "a.png").read_bytes() == content
    for wrong in (dict(path="a.jpg"), dict(size=(0, 5)), dict(size=7), dict(size=(10**6, 10**6))):
        with pytest.raises(ValueError, match="^(pictures are PNG files|size)"):
            htl.picture(*torus, L, **wrong)
    with pytest.raises(OSError):
        htl.picture(*torus, L, tmp_path / "no" / "a.png", size=(120, 90))
    with pytest.raises(TypeError, match="L must be"):
        htl.picture(*torus)
