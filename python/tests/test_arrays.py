"""What is accepted as a mesh, and what is said of what is not."""

import os
import pathlib
import sys
import tracemalloc
import types

import numpy as np
import pytest

import handle_tunnel_loops as htl


def lengths(L):
    return [loop.length for loop in L.handles + L.tunnels]


@pytest.fixture(scope="module")
def expected(torus):
    return lengths(htl.loops(*torus))


@pytest.mark.parametrize("integer", ["i1", "i2", "i4", "i8", "u2", "u4", "u8", ">i4"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_integers_and_orders(torus, expected, integer, order):
    V, F = torus
    if len(V) > np.iinfo(integer).max:
        V, F = htl.generate("torus", faces=200)
        expected = lengths(htl.loops(V, F))
    V = np.array(V, order=order)
    F = np.array(F, dtype=integer, order=order)
    assert lengths(htl.loops(V, F)) == expected


def test_points_of_other_types(torus, expected):
    V, F = torus
    as_float = V.astype(np.float32)
    assert lengths(htl.loops(as_float, F)) == lengths(htl.loops(as_float.astype(float), F))
    assert lengths(htl.loops(V.astype(">f8"), F)) == expected
    assert lengths(htl.loops(V.tolist(), F.tolist())) == expected
    whole = np.round(V * 1000).astype(np.int32)
    assert lengths(htl.loops(whole, F)) == lengths(htl.loops(whole.astype(float), F))


def test_views(torus, expected):
    V, F = torus
    wide = np.zeros((len(V), 7))
    wide[:, 1:6:2] = V
    assert lengths(htl.loops(wide[:, 1:6:2], F)) == expected
    backwards = np.ascontiguousarray(F[::-1])
    assert lengths(htl.loops(V, backwards[::-1])) == expected
    unaligned = np.frombuffer(b"x" + V.tobytes(), dtype=np.uint8)[1:].view(np.float64)
    assert lengths(htl.loops(unaligned.reshape(V.shape), F)) == expected


def test_there_is_no_second_copy():
    """Of arrays that have to be converted, before they are copied into a mesh."""
    V = np.zeros((10**6, 3), dtype=">f4")
    F = np.zeros((10**6, 3), dtype=">i2")
    F[-1] = -1
    tracemalloc.start()
    try:
        with pytest.raises(htl.MeshError, match="face 999999 refers to vertex -1"):
            htl.loops(V, F)
        assert tracemalloc.get_traced_memory()[1] < 2e6
    finally:
        tracemalloc.stop()


def test_nothing_is_changed(torus):
    V, F = (array.copy() for array in torus)
    V.flags.writeable = F.flags.writeable = False
    L = htl.loops(V, F)
    htl.remove_handles(V, F, genus=0)
    htl.cut_to_disk(V, F)
    htl.reeb(V, F)
    assert np.array_equal(V, torus[0]) and np.array_equal(F, torus[1])
    L.handles[0].points[:] = 0  # what is returned is the caller's
    assert lengths(L) == lengths(htl.loops(V, F))


def test_answers_outlive_what_they_came_from(torus):
    points = [htl.loops(*torus).handles[0].points for _ in range(3)]
    assert np.array_equal(points[0], points[2])


def test_objects(torus, expected):
    V, F = torus
    trimesh = types.SimpleNamespace(vertices=V, faces=F)
    rows = np.column_stack([np.full(len(F), 3), F]).ravel()
    pyvista = types.SimpleNamespace(points=V, faces=rows)
    for mesh in [trimesh, pyvista, (V, F)]:
        assert lengths(htl.loops(mesh)) == expected
    with pytest.raises(TypeError, match="of type dict"):
        htl.loops({})
    with pytest.raises(htl.MeshError, match="faces with 4 corners"):
        htl.loops(types.SimpleNamespace(points=V, faces=np.array([4, 0, 1, 2, 3])))
    with pytest.raises(htl.MeshError, match="different numbers"):
        htl.loops(types.SimpleNamespace(points=V, faces=np.array([3, 0, 1, 2, 4, 0, 1, 2, 3])))


def test_meshio(torus, expected):
    meshio = pytest.importorskip("meshio")
    V, F = torus
    assert lengths(htl.loops(meshio.Mesh(V, [("triangle", F)]))) == expected
    with_points = meshio.Mesh(V, [("vertex", [[0]]), ("triangle", F[:700]), ("triangle", F[700:])])
    assert lengths(htl.loops(with_points)) == expected
    with pytest.raises(htl.MeshError, match="neither triangles nor quads: tetra"):
        htl.loops(meshio.Mesh(V, [("tetra", [[0, 1, 2, 3]])]))
    with pytest.raises(htl.MeshError, match="has no faces"):
        htl.loops(meshio.Mesh(V, [("line", [[0, 1]])]))


def cube():
    """Of quads, two of which are cut."""
    corners = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
    quads = np.array([[0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    triangles = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5]])
    return corners, triangles, quads


@pytest.mark.parametrize("names", [("line", "triangle", "quad"), (3, 5, 9)])  # of meshio, of VTK
def test_cells(torus, expected, names):
    line, triangle, quad = names
    V, F = torus
    no_lines = np.zeros((1, 2), dtype=int)
    mesh = types.SimpleNamespace(points=V, cells_dict={triangle: F, line: no_lines})
    assert lengths(htl.loops(mesh)) == expected
    V, triangles, quads = cube()
    mesh = types.SimpleNamespace(points=V, cells_dict={quad: quads, triangle: triangles})
    with pytest.raises(htl.MeshError, match="4 corners; repair\\(\\) cuts them into triangles"):
        htl.loops(mesh)
    new_V, new_F, face_origin, _, _ = htl.repair(mesh)
    assert htl.loops(new_V, new_F).genus == 0 and len(new_F) == 12
    # The triangles come first, then the quads.
    assert np.array_equal(np.bincount(face_origin), [1] * 4 + [2] * 4)
    with pytest.raises(htl.MeshError, match="nor quads: VTK type 10|nor quads: tetra"):
        tetra = 10 if triangle == 5 else "tetra"
        htl.loops(types.SimpleNamespace(points=V, cells_dict={tetra: [[0, 1, 2, 3]]}))


def test_objects_are_taken_everywhere(torus, tmp_path):
    mesh = types.SimpleNamespace(vertices=torus[0], faces=torus[1])
    L = htl.loops(mesh)
    for given in [(mesh, L), (torus, L), (*torus, L)]:
        assert htl.certify(*given)
        htl.html(*given, tmp_path / "a.html", title="a ring")
        assert "a ring" in (tmp_path / "a.html").read_text()
    assert htl.certify(mesh, L=L)
    htl.html(mesh, L, path=tmp_path / "b.html")
    assert (tmp_path / "b.html").exists()


@pytest.mark.parametrize(
    "change, message",
    [
        (lambda V, F: (V[:, :2], F), r"V must be .* \(n, 3\).* its shape is \(\d+, 2\)"),
        (lambda V, F: (V.ravel(), F), r"V must be"),
        (lambda V, F: (V, F[:, :2]), r"F must be .* \(m, 3\)"),
        (lambda V, F: (V, F.astype(float)), "of integers, not of float64"),
        (lambda V, F: (V[:-1], F), r"face \d+ refers to vertex \d+, which does not exist: there are \d+ vertices$"),
        (lambda V, F: (V, np.where(F == 7, -1, F)), r"face \d+ refers to vertex -1"),
        (lambda V, F: (np.where(np.arange(len(V)) == 5, np.nan, V.T).T, F), "vertex 5$"),
        (lambda V, F: (V, np.vstack([F, F[:1]])), r"repair\(\) fixes this$"),
        (lambda V, F: (V, np.vstack([F[:1, ::-1], F[1:]])), r"repair\(\) fixes this$"),
        (lambda V, F: (V, np.column_stack([F, F[:, 0]])), "triangle"),
    ],
)
def test_what_is_refused(torus, change, message):
    with pytest.raises(ValueError, match=message):
        htl.loops(*change(*torus))


def test_mesh_errors_are_value_errors():
    assert issubclass(htl.MeshError, ValueError)
    with pytest.raises(htl.MeshError):
        htl.loops(np.zeros((3, 3)), [[0, 1, 1]])


def test_too_many(torus):
    """More than numbers of 32 bits count, in arrays that take no memory."""
    V, F = torus
    with pytest.raises(htl.MeshError, match=r"more than 2\^32 - 2 halfedges"):
        htl.loops(V, np.broadcast_to(np.int32(0), (2**32 // 3, 3)))
    with pytest.raises(htl.MeshError, match=r"more than 2\^32 - 2 vertices"):
        htl.loops(np.broadcast_to(0.0, (2**32 - 1, 3)), F)


def test_other_arguments(torus):
    for arguments, message in [
        (dict(basis="best"), "'pure' or 'shortest', not 'best'"),
        (dict(seed=10**6), "vertex 1000000 does not exist"),
        (dict(seed=-1), "vertex -1 does not exist"),
    ]:
        with pytest.raises(ValueError, match=message):
            htl.loops(*torus, **arguments)
    with pytest.raises(TypeError, match="progress"):
        htl.loops(*torus, progress=7)


def test_generators():
    assert "torus" in htl.kinds()
    V, F = htl.generate("multi-torus", faces=3000, genus=2, seed=5)
    assert V.dtype == np.float64 and F.dtype == np.int64
    assert len(V) - len(F) // 2 == 2 - 2 * 2
    with pytest.raises(ValueError, match="there is no kind 'ring'"):
        htl.generate("ring")
    with pytest.raises(TypeError, match="no option 'size'"):
        htl.generate("torus", size=3)


def test_files(torus, tmp_path):
    from conftest import write_off

    write_off(tmp_path / "torus.off", *torus)
    V, F = htl.read(tmp_path / "torus.off")
    assert np.array_equal(V, torus[0]) and np.array_equal(F, torus[1])
    with pytest.raises(OSError, match="nothing.off"):
        htl.read(tmp_path / "nothing.off")
    (tmp_path / "quad.off").write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    with pytest.raises(ValueError, match="triangulate"):
        htl.read(tmp_path / "quad.off")
    assert len(htl.read(tmp_path / "quad.off", triangulate=True)[1]) == 2


def test_messages_are_in_words_of_python(torus, tmp_path):
    from conftest import write_off

    V, F = torus
    (tmp_path / "--repair.off").write_text("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    write_off(tmp_path / "turned.off", V, np.vstack([F[:1, ::-1], F[1:]]))
    (tmp_path / "mesh.txt").write_text("mesh")
    for name, words in [
        ("--repair.off", r"--repair.off: .*; triangulate=True splits it into triangles$"),
        ("turned.off", r"; repair=True fixes this:\n  1 face flipped: face 0$"),
        ("mesh.txt", r"does not name a supported format; those are: \.off \.obj \.ply \.stl .*\.vtp"),
    ]:
        with pytest.raises((ValueError, OSError), match=words):
            htl.read(tmp_path / name)


def test_names_of_files(torus, tmp_path, monkeypatch):
    from conftest import write_off

    monkeypatch.chdir(tmp_path)
    L = htl.loops(*torus)
    names = ["ä.off", os.fsencode("ä.off"), pathlib.Path("ä.off")]
    if sys.platform.startswith("linux"):
        names.append(b"\xff.off")
    for name in names:
        write_off(name, *torus)
        assert np.array_equal(htl.read(name)[1], torus[1])
        assert htl.survey([name])[0]["genus"] == 1
        htl.html(*torus, L, name)
        with pytest.raises(OSError):
            htl.read(name)  # it is a page now
    htl.html(*torus, L, "-")  # these are no streams
    assert os.path.getsize("-") > 0
    with pytest.raises(OSError, match="supported format"):
        htl.read("-")
    with pytest.raises(FileNotFoundError):
        htl.read("nothing.off")
    with pytest.raises(TypeError):
        htl.read(3)


def test_repair(torus):
    V, F = torus
    soup = V[F].reshape(-1, 3)  # no two faces share a corner
    new_V, new_F, face_origin, vertex_origin, changes = htl.repair(
        soup, np.arange(len(soup)).reshape(-1, 3)
    )
    assert htl.loops(new_V, new_F).genus == 1
    assert np.array_equal(face_origin, np.arange(len(F)))
    assert np.array_equal(new_V, soup[vertex_origin])
    assert any("weld" in words or "same place" in words for _, words in changes), changes
    assert htl.repair(V, F)[4] == []
    turned = np.vstack([F[:1, ::-1], F[1:]])
    assert [count for count, _ in htl.repair(V, turned, steps=["orient"])[4]] == [1]
    with pytest.raises(htl.MeshError):
        htl.repair(V, turned, steps=["weld", "split"])
    with pytest.raises(ValueError, match="steps must be 'degenerate', 'weld'"):
        htl.repair(V, F, steps=["all"])
    pillow = len(V) + np.array([[0, 1, 2], [0, 2, 1]])
    with_pillow = np.vstack([V, V[:3] + 99]), np.vstack([F, pillow])
    assert np.array_equal(htl.repair(*with_pillow)[1], F)
    assert len(htl.repair(*with_pillow, steps=["weld"])[1]) == len(F) + 2
    # A cube of quads.
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    _, triangles, origin, _, _ = htl.repair(corners, quads)
    assert len(triangles) == 12 and np.array_equal(np.bincount(origin), np.full(6, 2))
    assert htl.loops(corners, triangles).genus == 0
    with pytest.raises(htl.MeshError):
        htl.repair(np.full((3, 3), np.nan), [[0, 1, 2]])


def test_a_vertex_without_faces_does_not_matter(genus_3):
    V, F = genus_3
    V = np.vstack([V, np.full((1, 3), 99)])
    L = htl.loops(V, F)
    assert L.genus == 3 and htl.certify(V, F, L) and len(htl.measure(V, F, L)) == 3
    for given in {}, {"loops": L}:
        assert htl.remove_handles(V, F, genus=0, **given)[3]["genus_after"] == 0
    assert isinstance(htl.throats(V, F, L), list)
