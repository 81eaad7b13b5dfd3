import numpy as np
import pytest

import handle_tunnel_loops as htl


def necklace(beads):
    """A tube around a circle, of a radius that varies along it."""
    m, k = 24 * beads, 24
    u = np.repeat(np.arange(m), k) * 2 * np.pi / m
    v = np.tile(np.arange(k), m) * 2 * np.pi / k
    r = 0.35 - 0.15 * np.cos(beads * u + 1)
    out = 2 + r * np.cos(v)
    V = np.stack([out * np.cos(u), out * np.sin(u), r * np.sin(v)], axis=1)
    i, j = np.repeat(np.arange(m), k), np.tile(np.arange(k), m)
    a, b = i * k + j, (i + 1) % m * k + j
    c, d = (i + 1) % m * k + (j + 1) % k, i * k + (j + 1) % k
    return V, np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def test_a_necklace_has_a_throat_for_each_bead():
    V, F = necklace(5)
    throats = htl.throats(V, F)
    inside = [t for t in throats if t.bounds == "inside"]
    assert len(inside) == 5 and len(throats) == 6
    for t in inside:
        assert t.pair == 0 and t.kind == "handle" and not t.separating and t.through == ()
        assert t.diameter == pytest.approx(0.4, rel=0.02)
        assert t.closed().shape == (len(t) + 1, 3)
        steps = np.linalg.norm(np.diff(t.closed(), axis=0), axis=1)
        assert steps.sum() == pytest.approx(t.length)
    assert [t.prominence for t in throats] == sorted((t.prominence for t in throats), reverse=True)


def test_loops_that_are_known_are_taken():
    V, F = necklace(2)
    L = htl.loops(V, F)
    assert [t.length for t in htl.throats(V, F, L)] == [t.length for t in htl.throats(V, F)]
    found = htl.throats(V, F, L, through=[7])
    assert sum(t.through == (7,) for t in found) == 1


def test_a_ball_has_none():
    V, F = htl.generate("sphere", faces=2000)
    assert htl.throats(V, F) == [] and htl.throats(V, F, through=0) == []


def test_what_makes_no_sense_is_refused():
    V, F = necklace(2)
    with pytest.raises(ValueError):
        htl.throats(V, F, least_prominence=0.0)
    with pytest.raises(TypeError):
        htl.throats(V, F, "loops")
