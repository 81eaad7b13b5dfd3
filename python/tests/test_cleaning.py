"""Closed solids, made of meshes with something wrong."""

import numpy as np
import pytest

import handle_tunnel_loops as htl


def edges_of(F):
    return np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)


def is_closed(F):
    return np.all(np.unique(edges_of(F), axis=0, return_counts=True)[1] == 2)


def volume(V, F):
    return np.einsum("ij,ij->", V[F[:, 0]], np.cross(V[F[:, 1]], V[F[:, 2]])) / 6


def joined(*meshes):
    points, faces, count = [], [], 0
    for V, F in meshes:
        points.append(V)
        faces.append(F + count)
        count += len(V)
    return np.concatenate(points), np.concatenate(faces)


def check_origins(V, F, new_V, new_F, face_origin, report):
    kept = report["vertex_origin"] >= 0
    assert np.array_equal(new_V[kept], V[report["vertex_origin"][kept]])
    kept = face_origin >= 0
    assert np.array_equal(np.sort(new_V[new_F[kept]], axis=1), np.sort(V[F[face_origin[kept]]], axis=1))
    assert np.array_equal(report["face_parent"][kept], face_origin[kept])


def test_what_is_sound_stays(genus_3):
    V, F = genus_3
    new_V, new_F, face_origin, report = htl.clean(V, F)
    assert np.array_equal(new_V, V) and np.array_equal(new_F, F)
    assert np.array_equal(face_origin, np.arange(len(F)))
    assert report["closed"] and report["before"] == report["after"] and report["after"]["genus"] == 3
    assert [step["step"] for step in report["steps"]] == [
        "repair", "holes", "orient", "channels", "floaters", "shells", "handles"]
    assert not any(step["count"] for step in report["steps"])
    assert "noise_below or genus" in report["steps"][-1]["left"][0]


def test_all_at_once(genus_3):
    V, F = genus_3
    S, T = htl.generate("sphere", faces=320)
    extent = np.ptp(V, axis=0).max()
    crumb, ball = (0.01 * S + [2 * extent, 0, 0], T), (0.5 * extent * S + [3 * extent, 0, 0], T[:, ::-1])
    inner = (0.2 * extent * S + [3 * extent, 0, 0], T)
    points, faces = joined((V, F[3:]), crumb, ball, inner)
    W, G, face_origin, report = htl.clean(points, faces)
    assert report["closed"] and is_closed(G) and report["after"]["parts"] == 2 and report["after"]["genus"] == 3
    assert volume(W, G) == pytest.approx(report["after"]["volume"]) and volume(W, G) > 0
    counts = {step["step"]: step["count"] for step in report["steps"]}
    assert counts["orient"] == counts["floaters"] == counts["shells"] == 1 and counts["holes"] > 0
    check_origins(points, faces, W, G, face_origin, report)
    _, G, _, report = htl.clean(points, faces, skip=("floaters", "shells"), genus=1)
    assert report["after"]["parts"] == 4 and report["after"]["genus"] == 1 and is_closed(G)
    assert not htl.clean(points, faces, skip="holes")[3]["closed"]


def test_channels():
    V, F = htl.generate("hollow", genus=0, faces=60000, necks=2)
    W, G, _, report = htl.clean(V, F, channels="10%")
    assert is_closed(G) and report["after"]["parts"] == 1 and volume(W, G) > 2 * volume(V, F)
    report = htl.clean(V, F, channels="3%")[3]  # not closed, and nothing else done
    left = {step["step"]: step["left"] for step in report["steps"]}
    assert report["after"]["parts"] == 1 and left["channels"][0].startswith('channels="12%" would close 2')
    report = htl.remove_handles(V, F, channels="10%")[3]
    assert report["components_after"] == 2 and len(report["removed"]) == 1 == len(report["removed_necks"])


def test_large_hollows_are_filled_only_if_that_is_asked_for():
    S, T = htl.generate("sphere", faces=1280)
    drained, closed = htl.generate("hollow", genus=0, faces=60000, necks=2), joined((S, T), (0.6 * S, T[:, ::-1]))
    V, F = joined(drained, (S + [20, 0, 0], T), (closed[0] + [30, 0, 0], closed[1]))
    W, G, _, report = htl.clean(V, F)
    assert len(G) == len(F) and report["before"] == report["after"]
    left = {step["step"]: step["left"] for step in report["steps"]}
    assert 'use channels="3%" to do it' in left["channels"][0] and "use force=True to do it" in left["shells"][0]
    assert htl.clean(V, F, channels="3%")[3]["after"]["parts"] == 4
    assert htl.clean(V, F, force=True)[3]["after"]["parts"] == 3


def test_polygons_and_no_surfaces():
    V = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    quads = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    W, G, face_origin, report = htl.clean(V, quads)
    assert len(G) == 12 and sorted(face_origin) == sorted([*range(6)] * 2) and volume(W, G) == pytest.approx(1)
    with pytest.raises(htl.MeshError):
        htl.clean(V, [[0, 1, 9]])
    with pytest.raises(ValueError, match="skip"):
        htl.clean(V, quads, skip="hole")
    with pytest.raises(ValueError, match="share of the volume"):
        htl.clean(V, quads, floaters=2.0)
    with pytest.raises(ValueError, match="together"):
        htl.clean(V, quads, genus=0, noise_below="1%")
    for wrong in (dict(weld=0.0), dict(channels=np.inf)):
        with pytest.raises(ValueError, match="positive"):
            htl.clean(V, quads, **wrong)
    for wrong in (dict(skip="handles", genus=0), dict(skip="channels", channels=1.0), dict(skip=["repair"], weld="1%")):
        with pytest.raises(ValueError, match="leaves out"):
            htl.clean(V, quads, **wrong)
    with pytest.raises(TypeError, match="skip"):
        htl.clean(V, quads, skip=None)
    assert htl.clean(V, quads, floaters="0%")[3]["closed"]
