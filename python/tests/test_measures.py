"""How thick handles are, how wide their holes, and what their removal would take."""

import numpy as np
import pytest

import handle_tunnel_loops as htl


@pytest.fixture(scope="module")
def torus():
    V, F = htl.generate("torus", faces=4000)
    return V, F, htl.loops(V, F)


def test_measures_of_a_torus(torus):
    M = htl.measure(*torus)
    assert len(M) == 1
    assert M.thickness.diameters[0] == pytest.approx(0.78, rel=0.05)
    assert M.clear_width.diameters[0] == pytest.approx(1.2, rel=0.05)
    assert (M.thickness.errors <= 0.01 * M.thickness.diameters).all()
    assert M.noise[0] == pytest.approx(M.thickness.diameters[0])
    assert M.why == [""]
    assert M.columns()["throat_x"].shape == (1,)


def test_costs_are_those_of_the_removal(torus):
    V, F, L = torus
    C = htl.removal_costs(V, F, L)
    assert len(C) == 1
    assert C.cut.volumes[0] > 0 > C.fill.volumes[0]
    assert C.cut.areas[0] < C.fill.areas[0]
    assert C.cut.why_not == C.fill.why_not == [""]
    assert sorted(C.columns()) == sorted(
        ["pair", "cut_area", "cut_volume", "no_cut_because", "fill_area", "fill_volume", "no_fill_because"]
    )


def test_a_sphere_has_none():
    V, F = htl.generate("sphere", faces=200)
    L = htl.loops(V, F)
    assert len(htl.removal_costs(V, F, L)) == len(htl.measure(V, F, L)) == 0


def test_what_cannot_be_is_nan():
    V, F = htl.generate("torus", faces=32, genus=1)
    V = np.array(V)
    C = htl.removal_costs(V, F, htl.loops(V, F))
    for way in (C.cut, C.fill):
        assert np.isnan(way.areas[0]) == (way.why_not[0] != "")
