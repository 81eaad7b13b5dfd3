"""Meshes that are changed, or cut."""

import numpy as np
import pytest

import handle_tunnel_loops as htl


def edges_of(F):
    return np.sort(F[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)


def euler_characteristic(F):
    return len(np.unique(F)) - len(np.unique(edges_of(F), axis=0)) + len(F)


def check_origin(V, F, new_V, new_F, face_origin):
    kept = face_origin >= 0
    assert np.array_equal(new_V[new_F[kept]], V[F[face_origin[kept]]])
    assert len(np.unique(face_origin[kept])) == kept.sum()


def test_all_handles(genus_3):
    V, F = genus_3
    new_V, new_F, face_origin, report = htl.remove_handles(V, F, genus=0)
    assert euler_characteristic(new_F) == 2 and htl.loops(new_V, new_F).genus == 0
    check_origin(V, F, new_V, new_F, face_origin)
    kept = report["vertex_origin"] >= 0
    assert len(kept) == len(new_V) and np.array_equal(new_V[kept], V[report["vertex_origin"][kept]])
    assert len(np.unique(report["vertex_origin"][kept])) == kept.sum() > 0.9 * len(V)
    parent, kept = report["face_parent"], face_origin >= 0
    assert len(parent) == len(new_F) and np.array_equal(parent[kept], face_origin[kept])
    assert 0 < (parent >= 0).sum() - kept.sum() < (~kept).sum() and parent.max() < len(F)
    assert report["genus_before"] == 3 and report["genus_after"] == 0
    assert [handle["pair"] for handle in report["removed"]] and report["refused"] == []


def test_some_handles(genus_3):
    V, F = genus_3
    L = htl.loops(V, F)
    new_V, new_F, face_origin, report = htl.remove_handles(V, F, genus=2, loops=L)
    assert report["genus_after"] == 2 and len(report["removed"]) == 1
    check_origin(V, F, new_V, new_F, face_origin)
    _, _, _, report = htl.remove_handles(V, F, pairs=[1], loops=L, by="fill")
    assert [(handle["pair"], handle["by"]) for handle in report["removed"]] == [(1, "fill")]
    _, _, _, report = htl.remove_handles(V, F, pairs={0: "cut", 2: None}, loops=L, by="fill", force=True)
    ways = {handle["pair"]: handle for handle in report["removed"]}
    assert ways[0]["by"] == "cut" and ways[2]["by"] == "fill"
    assert ways[0]["change"]["volume_removed"] > 0 and ways[2]["change"]["volume_added"] > 0
    assert report["change"]["cap_area"] == pytest.approx(sum(handle["area"] for handle in ways.values()))
    assert 0 < report["change"]["cap_ratio"] < 3 and report["change"]["sharpest_angle"] > 30
    _, _, _, report = htl.remove_handles(V, F, shorter_than=1e-9)
    assert report["genus_after"] == 3 and report["removed"] == []
    loop = min((L.handles[2], L.tunnels[2]), key=lambda loop: loop.length)
    box = (loop.points.min(axis=0) - 1e-9, loop.points.max(axis=0) + 1e-9)
    _, _, _, report = htl.remove_handles(V, F, box=box)
    assert 2 in [handle["pair"] for handle in report["removed"]]


def test_noise():
    V, F = htl.generate("scan", faces=28000, genus=1, bridges=2, tunnels=2)
    L = htl.loops(V, F)
    M = htl.measure(V, F, L)
    limit = 1.01 * np.sort(M.noise)[-2]
    for length in limit, f"{100 * limit / np.linalg.norm(np.ptp(V, axis=0))}%":
        new_V, new_F, face_origin, report = htl.remove_handles(V, F, noise_below=length, loops=L)
        assert sorted(handle["pair"] for handle in report["removed"]) == np.flatnonzero(M.noise < limit).tolist()
        assert report["genus_before"] == 5 and report["genus_after"] == htl.loops(new_V, new_F).genus == 1
        assert np.array_equal(report["measures"].noise_ranges, M.noise_ranges) and report["undecided"] == []
        check_origin(V, F, new_V, new_F, face_origin)
    fractions = []
    _, _, _, report = htl.remove_handles(V, F, noise_below=0, progress=fractions.append)
    assert report["removed"] == [] and fractions == sorted(fractions)
    with pytest.raises(ValueError, match="noise_below and pairs|pairs and noise_below"):
        htl.remove_handles(V, F, noise_below=limit, pairs=[1], loops=L)


def test_large_noise_is_asked_for():
    V, F = htl.generate("torus", faces=600)
    with pytest.raises(ValueError, match=r'noise_below=2 is \d.*%.* width of \d.*Did you mean "2%"\? Use force=True'):
        htl.remove_handles(V, F, noise_below=2)
    with pytest.raises(ValueError, match='noise_below="6%" is 6% of the diagonal.* remove no handle. Use force=True'):
        htl.remove_handles(V, F, noise_below="6%")
    assert htl.remove_handles(V, F, noise_below="5%")[3]["genus_after"] == 1
    assert htl.remove_handles(V, F, noise_below=2, force=True)[3]["genus_after"] == 0
    with pytest.raises(ValueError, match=r'noise_below=2 is .* remove 1 handle, .*Did you mean "2%"\? Use force=True'):
        htl.clean(V, F, noise_below=2)
    assert htl.clean(V, F, noise_below=2, force=True)[3]["after"]["genus"] == 0


def test_a_gap_between_sizes_is_asked_for():
    V, F = htl.generate("scan", faces=30000, genus=1, bridges=3, tunnels=3)
    wide = r'remove 7 handles.* Between 0.05\d* and 0.28\d* there is a wide gap.*: noise_below=.* only the 6 below it'
    for function in htl.remove_handles, htl.clean:
        for limit in 0.4, "10%":
            with pytest.raises(ValueError, match=wide):
                function(V, F, noise_below=limit)
    assert htl.remove_handles(V, F, noise_below=0.4, force=True)[3]["genus_after"] == 0


def test_handles_are_chosen(torus):
    with pytest.raises(ValueError, match="which handles.*genus, shorter_than, noise_below, pairs, box, necks"):
        htl.remove_handles(*torus)


def nut():
    """A bore of six sides, 2 wide."""
    angles = np.arange(6) * np.pi / 3
    V = [[r * np.cos(a), r * np.sin(a), z] for r, z in ((1, 0), (4, 0), (4, 1), (1, 1)) for a in angles]
    F = []
    for ring in range(4):
        for i in range(6):
            a, b = 6 * ring + i, 6 * ring + (i + 1) % 6
            c, d = (a + 6) % 24, (b + 6) % 24
            F += [[a, b, c], [b, d, c]]
    return np.array(V), np.array(F)


def test_bores(genus_3):
    V, F = nut()
    for bores in ((None, None), (1.9, 2.1), (1.9, None), [None, 2.1]):
        _, new_F, _, report = htl.remove_handles(V, F, bores=bores)
        assert euler_characteristic(new_F) == 2 and report["removed"][0]["by"] == "fill"
        assert report["removed"][0]["volume"] == pytest.approx(-1.5 * np.sqrt(3))
    for bores in ((2.1, None), (None, 1.9)):
        assert htl.remove_handles(V, F, bores=bores)[3]["removed"] == []
    assert htl.remove_handles(*genus_3, bores=(None, None))[3]["genus_after"] == 3
    with pytest.raises(ValueError, match="bores must be two diameters"):
        htl.remove_handles(V, F, bores=(1, 2, 3))
    with pytest.raises(ValueError, match="the least diameter first"):
        htl.remove_handles(V, F, bores=(2, 1))
    with pytest.raises(ValueError, match="bores and genus|genus and bores"):
        htl.remove_handles(V, F, bores=(1, 2), genus=0)
    with pytest.raises(ValueError, match="bores can only be filled"):
        htl.remove_handles(V, F, bores=(1, 2), by="cut")


def test_what_cannot_be_asked(genus_3):
    with pytest.raises(ValueError, match="genus and pairs cannot be given together"):
        htl.remove_handles(*genus_3, genus=1, pairs=[0], loops=htl.loops(*genus_3))
    with pytest.raises(ValueError, match="by must be"):
        htl.remove_handles(*genus_3, by="magic")
    with pytest.raises(ValueError, match="each way in pairs must be"):
        htl.remove_handles(*genus_3, pairs={0: "saw"}, loops=htl.loops(*genus_3))
    with pytest.raises(ValueError, match="7"):
        htl.remove_handles(*genus_3, pairs=[7], loops=htl.loops(*genus_3))
    with pytest.raises(ValueError, match="pairs requires loops"):
        htl.remove_handles(*genus_3, pairs=[0])
    with pytest.raises(ValueError, match="box must be two corners"):
        htl.remove_handles(*genus_3, box=np.zeros((3, 2)))
    with pytest.raises(ValueError, match="genus cannot be -1"):
        htl.remove_handles(*genus_3, genus=-1)


def test_cut_to_disk(genus_3):
    V, F = genus_3
    new_V, new_F, origin = htl.cut_to_disk(V, F)
    assert euler_characteristic(new_F) == 1  # a disk
    assert np.array_equal(origin[: len(V)], np.arange(len(V)))
    assert np.array_equal(new_V, V[origin]) and np.array_equal(origin[new_F], F)
    cone = 17
    _, with_cone, origin = htl.cut_to_disk(V, F, cones=[cone])
    edges, counts = np.unique(edges_of(with_cone), axis=0, return_counts=True)
    assert cone in origin[edges[counts == 1]]
    V, F = htl.generate("sphere", faces=320)
    assert np.array_equal(htl.cut_to_disk(V, F)[1], F)
    assert euler_characteristic(htl.cut_to_disk(V, F, cut_spheres=True)[1]) == 1


def test_cut_edges_avoid_the_diagonals_of_polygons(genus_3):
    V, F = genus_3
    _, opened, origin = htl.cut_to_disk(V, F)
    edges, counts = np.unique(edges_of(opened), axis=0, return_counts=True)
    sides = np.unique(np.sort(origin[edges[counts == 1]], axis=1), axis=0)
    assert np.array_equal(np.unique(np.sort(htl.cut_edges(V, F), axis=1), axis=0), sides)
    n = 12  # a torus of squares
    i, j = np.divmod(np.arange(n * n), n)
    at = lambda i, j: i % n * n + j % n
    angles = 2 * np.pi / n
    V = np.stack([(3 + np.cos(j * angles)) * np.cos(i * angles), (3 + np.cos(j * angles)) * np.sin(i * angles),
                  np.sin(j * angles)], axis=1)
    a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    F = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    diagonals = np.stack([a, c], axis=1)
    cut = np.sort(htl.cut_edges(V, F, avoid=diagonals), axis=1)
    assert len(cut) and not {tuple(e) for e in cut} & {tuple(e) for e in np.sort(diagonals, axis=1)}
    assert euler_characteristic(htl.cut_to_disk(V, F, avoid=diagonals)[1]) == 1
    with pytest.raises(ValueError, match="avoid: the mesh has no edge from 0 to 7"):
        htl.cut_edges(V, F, avoid=[[0, 7]])
    with pytest.raises(ValueError, match="avoid must be an array of shape"):
        htl.cut_edges(V, F, avoid=[0, 1])


def test_dual_cuts():
    V, F = htl.generate("multi-torus", faces=3000, genus=2, holes=3, hole_faces=30)
    cuts = htl.dual_cuts(V, F)
    assert [cut.loop.kind for cut in cuts] == ["handle", "tunnel"] * 2 + ["boundary"] * 2
    edges, counts = np.unique(edges_of(F), axis=0, return_counts=True)
    on_boundary = np.unique(edges[counts == 1])
    for cut in cuts:
        ends = np.zeros(len(V), dtype=int)  # of the chain
        np.add.at(ends, cut.edges[:, 1], cut.times)
        np.add.at(ends, cut.edges[:, 0], -cut.times)
        assert set(np.flatnonzero(ends)) <= set(on_boundary)
        assert cut.edges.shape == (len(cut.times), 2) and len(cut.times) > 0


def test_lengths_are_shares_of_the_diagonal(genus_3):
    V, F = genus_3
    L = htl.loops(V, F)
    diagonal = np.linalg.norm(V.max(axis=0) - V.min(axis=0))
    sizes = np.sort(L.table()["size"])
    share = 100 * (sizes[0] + sizes[1]) / 2
    by_share = htl.remove_handles(V, F, shorter_than=f"{share}%", loops=L)
    by_length = htl.remove_handles(V, F, shorter_than=share / 100 * diagonal)
    assert by_share[3]["genus_after"] == by_length[3]["genus_after"] == 2
    assert np.array_equal(by_share[0], by_length[0]) and np.array_equal(by_share[1], by_length[1])
    assert htl.remove_handles(V, F, necks=f"{share}%", loops=L)[3]["genus_after"] == 2
    assert htl.remove_handles(V, F, shorter_than="0.001%", loops=L)[3]["removed"] == []
