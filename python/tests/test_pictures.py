"""Pictures and pages of all that can be drawn."""

import copy
import os
import pickle

import numpy as np
import pytest

import handle_tunnel_loops as htl


def removed(V, F, **which):
    return htl.remove_handles(V, F, loops=htl.loops(V, F), **(which or {"genus": 0}))


MAKERS = {
    "loops": htl.loops,
    "skeleton": htl.curve_skeleton,
    "reeb": htl.reeb,
    "reeb_inside": lambda V, F: htl.reeb(V, F, drawing="inside"),
    "reeb_parts": lambda V, F: htl.reeb(V, F, shortest_arc=2, drawing="inside"),
    "removal": removed,
    "cut": htl.cut_edges,
}
WORDS = {
    "loops": "Handle and tunnel loops of a mug</title>",
    "skeleton": "Skeleton of a mug</title>",
    "reeb": "Reeb graph of a mug</title>",
    "removal": "Handles removed from a mug</title>",
    "cut": "Cut along edges: a mug</title>",
}


@pytest.fixture(scope="module", params=MAKERS)
def found(request):
    V, F = htl.generate("multi-torus", faces=3000, genus=3)
    return request.param, V, F, MAKERS[request.param](V, F)


def test_pages(found, tmp_path):
    kind, V, F, what = found
    name = tmp_path / "page.html"
    htl.html(V, F, what, name, title="a mug")
    page = name.read_text()
    assert WORDS[kind.split("_")[0]] in page and page.endswith("</html>\n")
    assert [path.name for path in tmp_path.iterdir()] == ["page.html"]


def test_pictures(found, tmp_path):
    if not htl.has_pictures:
        pytest.skip("this build makes no pictures")
    kind, V, F, what = found
    content = htl.picture(V, F, what, size=(160, 120))
    assert content.startswith(b"\x89PNG") and content[16:24] == bytes([0, 0, 0, 160, 0, 0, 0, 120])
    arguments = ((V, F), None, what) if kind == "cut" else ((V, F), what)
    htl.picture(*arguments, path=tmp_path / "a.png", size=(160, 120))
    assert (tmp_path / "a.png").read_bytes() == content
    # What is drawn is what was found, and not the mesh alone.
    sphere = htl.generate("sphere", faces=500)
    assert htl.picture(*sphere, htl.loops(*sphere), size=(160, 120)) != content


def test_copies_are_drawn(found, tmp_path):
    _, V, F, what = found
    for number, twin in enumerate([copy.deepcopy(what), pickle.loads(pickle.dumps(what))]):
        htl.html(V, F, twin, tmp_path / f"{number}.html")
    pages = [path.read_text() for path in tmp_path.iterdir()]
    assert pages[0] == pages[1]


def test_of_another_mesh(found, tmp_path):
    _, _, _, what = found
    V, F = htl.generate("sphere", faces=500)
    with pytest.raises(ValueError):
        htl.html(V, F, what, tmp_path / "page.html")
    assert not list(tmp_path.iterdir())


def test_a_page_is_whole_or_not_there(found, tmp_path):
    _, V, F, what = found
    if os.path.exists("/dev/full"):
        with pytest.raises(OSError):
            htl.html(V, F, what, "/dev/full")
    with pytest.raises(OSError):
        htl.html(V, F, what, tmp_path / "no" / "page.html")


def test_what_cannot_be_drawn(torus):
    for what in (None, 5, "loops", np.zeros((4, 3), dtype=int), (1, 2, 3)):
        with pytest.raises(TypeError, match="^L must be a result of loops"):
            htl.html(*torus, what, "page.html")
    with pytest.raises(ValueError, match="the cut: the mesh has no edge from 0 to 0"):
        htl.html(*torus, np.array([[0, 0]]), "page.html")


def test_records_that_do_not_fit(torus, tmp_path):
    skeleton = htl.curve_skeleton(*torus)
    skeleton._record["edges"] = skeleton._record["edges"] + len(skeleton.points)
    with pytest.raises(ValueError, match="edges at points that do not exist"):
        htl.html(*torus, skeleton, tmp_path / "page.html")
    graph = htl.reeb(*torus)
    graph._record["arcs"]["ends"] = graph._record["arcs"]["ends"] + 1000
    with pytest.raises(ValueError, match="belongs to another mesh"):
        htl.html(*torus, graph, tmp_path / "page.html")
    removal = removed(*torus)
    del removal[3]["face_patch"]
    with pytest.raises(ValueError, match="the record of the report is incomplete: it has no 'face_patch'"):
        htl.html(*torus, removal, tmp_path / "page.html")


def test_patches_of_a_removal():
    V, F = htl.generate("plates", faces=9000, genus=12)
    new_V, new_F, face_origin, report = removed(V, F)
    patch = report["face_patch"]
    assert np.array_equal(patch >= 0, report["face_parent"] < 0)
    corners = new_V[new_F[patch >= 0]]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    shown = np.bincount(patch[patch >= 0], area, len(report["removed"]))
    told = np.zeros(len(report["removed"]))
    for handle in report["removed"]:
        told[handle["patch"]] += handle["area"]
    assert np.allclose(shown, told, rtol=0.02)
