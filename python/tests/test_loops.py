"""Loops, by their definitions, and as `htloops` finds them."""

import json
import pickle
import subprocess

import numpy as np
import pytest
from conftest import write_off

import handle_tunnel_loops as htl


def check_loop(V, F, loop):
    """It is where it says, as long as it says, and leaves no face between two places."""
    k = len(loop)
    assert loop.points.shape == (k, 3) and loop.edges.shape == (k, 2) and loop.ratios.shape == (k,)
    assert np.all((loop.ratios >= 0) & (loop.ratios <= 1))
    t = loop.ratios[:, np.newaxis]
    places = (1 - t) * V[loop.edges[:, 0]] + t * V[loop.edges[:, 1]]
    size = np.abs(V).max()
    assert np.allclose(loop.points, places, rtol=0, atol=1e-12 * size)
    steps = np.diff(loop.closed(), axis=0)
    assert np.isclose(loop.length, np.linalg.norm(steps, axis=1).sum(), rtol=1e-12)
    faces = {tuple(sorted(face)) for face in F.tolist()}
    edges = {tuple(sorted((f[i], f[i - 1]))) for f in faces for i in range(3)}
    assert all(tuple(sorted(edge)) in edges for edge in loop.edges.tolist())
    for i in range(k):
        on = [
            {end for end, rest in zip(loop.edges[j], (1 - loop.ratios[j], loop.ratios[j])) if rest > 0}
            for j in (i - 1, i)
        ]
        corners = on[0] | on[1]
        assert len(corners) <= 3
        assert any(corners <= set(face) for face in faces) if len(corners) == 3 else (
            len(corners) == 1 or tuple(sorted(corners)) in edges
        )


@pytest.mark.parametrize("basis", ["pure", "shortest"])
def test_definitions(genus_3, basis):
    V, F = genus_3
    L = htl.loops(V, F, basis)
    assert L.genus == len(L) == len(L.handles) == len(L.tunnels) == 3
    assert L.basis == basis and L.boundaries == [] and L.number_of_components == 1
    for i, (handle, tunnel) in enumerate(zip(L.handles, L.tunnels)):
        assert (handle.kind, handle.number, tunnel.kind, tunnel.number) == ("handle", i, "tunnel", i)
        for loop in (handle, tunnel):
            check_loop(V, F, loop)
            assert loop.component == 0
    assert L.certificate and L.certificate.basis and L.certificate.failure == ""
    if basis == "pure":
        assert {loop.bounds for loop in L.handles} == {"inside"}
        assert {loop.bounds for loop in L.tunnels} == {"outside"}
    assert htl.certify(V, F, L)


def test_time_budget(genus_3):
    L = htl.loops(*genus_3, time_budget=0)
    assert L.certificate and L.ended_by_time
    assert not htl.loops(*genus_3, time_budget=1e6).ended_by_time
    assert not htl.loops(*genus_3).ended_by_time


def test_linking(genus_3):
    sparse = pytest.importorskip("scipy.sparse")
    matrix = htl.loops(*genus_3).linking
    assert sparse.isspmatrix_coo(matrix) and matrix.shape == (6, 6)
    crossings = (matrix - matrix.T).toarray()  # of loops that are a basis
    assert round(abs(np.linalg.det(crossings))) == 1


def test_certify_believes_nothing(genus_3, torus):
    V, F = genus_3
    L = pickle.loads(pickle.dumps(htl.loops(V, F)))
    assert htl.certify(V, F, L)
    record = L._record
    twice = slice(record["starts"][0], record["starts"][1])
    again = slice(record["starts"][4], record["starts"][5])
    for name in ("points", "edges", "ratios"):  # handle 2 is handle 0 again
        parts = [record[name][: again.start], record[name][twice], record[name][again.stop :]]
        record[name] = np.concatenate(parts)
    record["lengths"][4] = record["lengths"][0]
    shift = (twice.stop - twice.start) - (again.stop - again.start)
    record["starts"] = np.where(np.arange(7) >= 5, record["starts"] + shift, record["starts"])
    certificate = htl.certify(V, F, L)
    assert not certificate and not certificate.basis and certificate.failure
    with pytest.raises(ValueError, match="not on this mesh"):
        htl.certify(*torus, htl.loops(V, F))


def test_certify_is_brief(genus_3):
    V, F = genus_3
    L = htl.loops(V, F)
    with pytest.raises(ValueError, match=r"not on this mesh:\n  .* was it scaled or moved\?$"):
        htl.certify(V + 1, F, L)
    moved = V.copy()
    moved[: len(V) // 4] += 1
    with pytest.raises(ValueError, match=r"not on this mesh:\n(  .*\n){10}  and \d+ more$"):
        htl.certify(moved, F, L)
    for name, value in [("starts", -1), ("starts", 10**9), ("edges", -5), ("edges", 10**9)]:
        changed = pickle.loads(pickle.dumps(L))
        changed._record[name].flat[1] = value
        with pytest.raises(ValueError, match="are inconsistent|does not exist"):
            htl.certify(V, F, changed)


def test_table(genus_3):
    V, F = genus_3
    L = htl.loops(V, F)
    table = L.table()
    assert len(table) == 3 and sorted(table["pair"]) == [0, 1, 2]
    assert np.all(np.diff(table["size"]) >= 0)
    diagonal = np.linalg.norm(V.max(axis=0) - V.min(axis=0))
    for row in table:
        handle, tunnel = L.handles[row["pair"]], L.tunnels[row["pair"]]
        shorter = min(handle, tunnel, key=lambda loop: loop.length)
        assert np.isclose(row["size"], shorter.length / diagonal)
        assert np.array_equal(row["box"][0], shorter.points.min(axis=0))
        assert (row["handle_bounds"], row["tunnel_bounds"]) == (handle.bounds, tunnel.bounds)
        assert row["diameter_of"] == "hole" and row["drilling"] == -1
        distance = np.linalg.norm(tunnel.points - tunnel.points.mean(axis=0), axis=1)
        assert distance.min() <= row["diameter"] / 2 <= distance.max()
        assert row["out_of_roundness"] > 0 and np.isclose(row["wall_diameter"], handle.length / np.pi)
        assert np.all(np.isnan(row["bore_axis"])) and np.isnan(row["bore_depth"])


def test_notebooks(genus_3):
    L = htl.loops(*genus_3)
    page = L._repr_html_()
    assert page.count("<tr>") == 4 and "&lt;Loops: genus 3" in page and "<Loops" not in page
    assert f"<td>{L.table()['size'][0]:.6g}</td>" in page and "more" not in page
    assert ("<img" in page) == htl.has_pictures
    assert "<img" not in pickle.loads(pickle.dumps(L))._repr_html_()  # it does not keep the mesh
    V, F = (array.copy() for array in genus_3)
    L = htl.loops(V, F)
    V += 1  # no mesh of these loops any more
    assert "<img" not in L._repr_html_() and "<table>" in L._repr_html_()
    many = htl.loops(*htl.generate("multi-torus", faces=9000, genus=23))._repr_html_()
    assert many.count("<tr>") == 21 and "and 3 more" in many


def test_bores():
    """A washer with sixteen sides, outside and inside."""
    turn = 2 * np.pi * np.arange(16)[:, None] / 16
    radius, height = np.array([1.0, 3.0, 3.0, 1.0]), np.array([0.0, 0.0, 1.0, 1.0])
    V = np.stack([radius * np.cos(turn), radius * np.sin(turn), height + 0 * turn], axis=-1)
    here = np.arange(64).reshape(16, 4)
    right, up = np.roll(here, -1, axis=0), np.roll(here, -1, axis=1)
    across = np.roll(right, -1, axis=1)
    F = np.concatenate([np.stack(c, axis=-1).reshape(-1, 3) for c in ((here, right, across), (here, across, up))])
    L = htl.loops(V.reshape(-1, 3), F)
    (row,) = L.table()
    assert row["diameter_of"] == "bore" and np.isclose(row["diameter"], 2)
    assert np.allclose(row["bore_axis"], (0, 0, 1)) and np.allclose(row["bore_centre"], (0, 0, 0.5))
    assert np.allclose(row["centre"], (0, 0, 0.5)) and np.isclose(row["bore_depth"], 1) and row["drilling"] == 0
    assert row["bore_deviation"] < 1e-12 and np.isnan(row["out_of_roundness"])
    columns = L.columns()
    assert all(column.shape == (1,) for column in columns.values())
    assert columns["bore_axis_z"] == row["bore_axis"][2] and columns["ymax"] == row["box"][1, 1]


def test_columns_have_one_dimension(genus_3):
    L = htl.loops(*genus_3)
    for table in (L.table(), pickle.loads(pickle.dumps(L.table())), L.table()[:2], L.table()[::-1]):
        assert all(table[name].ndim == 1 for name in table.dtype.names)
        assert table["centre"].shape == (len(table), 3) and table["box"].shape == (len(table), 2, 3)
        for i, row in enumerate(table):
            assert np.array_equal(row["centre"], table["centre"][i])
            assert np.array_equal(row["box"], [[row[x + end] for x in "xyz"] for end in ("min", "max")])
    with pytest.raises(ValueError, match="no field of name centroid"):
        L.table()["centroid"]


def test_pandas_takes_tables(genus_3):
    pandas = pytest.importorskip("pandas")
    L = htl.loops(*genus_3)
    frame = pandas.DataFrame(L.table())
    assert frame.shape == (3, len(L.table().dtype.names))
    assert np.array_equal(frame["centre_x"], L.table()["centre"][:, 0])
    assert list(frame["diameter_of"]) == list(L.table()["diameter_of"])


def test_boundary(plate):
    V, F = plate
    L = htl.loops(V, F, waists=True)
    assert L.genus == 0 and len(L.boundaries) == len(L.waists) == 4
    for curve, waist in zip(L.boundaries, L.waists):
        assert curve.kind == waist.kind == "boundary" and curve.number == waist.number
        assert waist.length <= curve.length
        check_loop(V, F, curve)
        check_loop(V, F, waist)
    assert htl.loops(V, F).waists == []


def test_waists_are_certified(plate):
    V, F = plate
    L = htl.loops(V, F, waists=True)
    assert htl.certify(V, F, L)
    L._record["waists"]["numbers"] = L._record["waists"]["numbers"][::-1]
    certificate = htl.certify(V, F, L)
    assert not certificate and certificate.basis
    assert "is not homologous to the curve" in certificate.failure


def test_the_only_boundary_curve_has_no_waist():
    V = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    L = htl.loops(V, np.array([[0, 1, 2]]), waists=True)
    assert len(L.boundaries) == 1 and L.waists == []


def test_layers(genus_3):
    V, F = genus_3
    plain, L = htl.loops(V, F), htl.loops(V, F, layers=True)
    assert plain.layers is None and plain.layer_times is None
    assert [h.length for h in plain.handles] == [h.length for h in L.handles]
    assert L.layers.shape == L.layer_times.shape == (len(V),)
    assert L.layers.min() == 1 and L.layer_times.min() == 0
    # Each handle takes a split, a merge, and the layers before, between and after.
    assert L.layers.max() >= 3 * L.genus + 1
    seed = int(np.argmin(L.layer_times))
    assert L.layers[seed] == 1


def test_components(torus, genus_3):
    V = np.concatenate([torus[0], genus_3[0] + 10])
    F = np.concatenate([torus[1], genus_3[1] + len(torus[0])])
    L = htl.loops(V, F)
    assert L.number_of_components == 2
    assert sorted(loop.component for loop in L.handles) == [0, 1, 1, 1]


def test_nothing_to_find():
    L = htl.loops(*htl.generate("sphere", faces=320))
    assert L.genus == 0 and L.handles == [] and len(L.table()) == 0 and L.certificate


def test_page(genus_3, tmp_path):
    V, F = genus_3
    htl.html(V, F, htl.loops(V, F), tmp_path / "page.html", title="three rings")
    page = (tmp_path / "page.html").read_text()
    assert "<title>" in page and "three rings" in page
    assert "pairs =" in page and "--pairs" not in page
    with pytest.raises(OSError):
        htl.html(V, F, htl.loops(V, F), tmp_path / "no" / "page.html")
    htl.html(V, F, htl.loops(V, F), tmp_path / "page.html", title="before/after")
    assert "loops of before/after</title>" in (tmp_path / "page.html").read_text()


def test_threads_change_nothing(genus_3):
    one, two = (htl.loops(*genus_3, threads=threads) for threads in (1, 2))
    for a, b in zip(one.handles + one.tunnels, two.handles + two.tunnels):
        assert np.array_equal(a.points, b.points) and np.array_equal(a.edges, b.edges)


def meshes():
    for genus in range(1, 6):
        for seed in range(10):
            yield "multi-torus", dict(faces=400 * genus, genus=genus, seed=seed)
            yield "random", dict(faces=300 + 40 * genus, genus=genus, seed=seed)


def test_the_program_gives_the_same(htloops, tmp_path):
    for kind, options in meshes():
        V, F = htl.generate(kind, **options)
        write_off(tmp_path / "a.off", V, F)
        subprocess.run(
            [htloops, "loops", tmp_path / "a.off", "-o", tmp_path / "a.json", "--quiet"], check=True
        )
        answer = json.loads((tmp_path / "a.json").read_text())
        L = htl.loops(V, F)
        assert len(answer["pairs"]) == L.genus
        for pair, handle, tunnel in zip(answer["pairs"], L.handles, L.tunnels):
            for record, loop in ((pair["handle"], handle), (pair["tunnel"], tunnel)):
                assert record["length"] == loop.length, (kind, options)
                assert np.array_equal(record["points"], loop.points)
                assert record["bounds"] == loop.bounds
        linking = {(i, j): value for i, j, value in answer["linking"]}
        rows, columns, values = L._record["linking"]
        assert dict(zip(zip(rows.tolist(), columns.tolist()), values.tolist())) == linking
