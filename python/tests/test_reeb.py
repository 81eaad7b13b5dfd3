"""Reeb graphs."""

import numpy as np
import pytest

import handle_tunnel_loops as htl


@pytest.mark.parametrize("function", [None, "height"])
def test_definitions(genus_3, function):
    V, F = genus_3
    G = htl.reeb(V, F, None if function is None else V[:, 2])
    nodes, arcs = len(G.positions), len(G.arcs)
    assert G.number_of_cycles == arcs - nodes + 1 == 3
    assert G.arc_of_vertex.shape == (len(V),) and G.arc_of_vertex.max() < arcs
    assert np.array_equal(np.bincount(G.arc_of_vertex, minlength=arcs), G.numbers_of_vertices)
    low, high = G.arcs.T
    assert np.all(G.node_values[low] <= G.node_values[high])
    assert len(G.polylines) == len(G.radii) == arcs
    for i in range(arcs):
        assert len(G.polylines[i]) == len(G.radii[i]) >= 2
        assert np.allclose(G.polylines[i][[0, -1]], G.positions[G.arcs[i]])
        assert np.isclose(G.lengths[i], np.linalg.norm(np.diff(G.polylines[i], axis=0), axis=1).sum())
        assert np.all(G.radii[i] >= 0) and G.girths[i] >= 0
    if function is not None:
        assert np.array_equal(G.values, V[:, 2])
        assert np.array_equal(G.node_values, V[G.node_vertices, 2])


def test_cycles(genus_3):
    networkx = pytest.importorskip("networkx")
    G = htl.reeb(*genus_3, simplify=0)
    graph = G.to_networkx()
    assert graph.number_of_edges() == len(G.arcs)
    bridges = set(networkx.bridges(networkx.Graph(graph))) if graph.number_of_edges() else set()
    for low, high, key, data in graph.edges(keys=True, data=True):
        is_bridge = graph.number_of_edges(low, high) == 1 and (
            (low, high) in bridges or (high, low) in bridges
        )
        assert data["is_on_cycle"] == (not is_bridge)
        assert data["length"] == G.lengths[key]


def test_parts(genus_3):
    V, F = genus_3
    G, parts = htl.reeb(V, F), htl.reeb(V, F, shortest_arc=2)
    assert parts.number_of_cycles == len(parts.arcs) - len(parts.positions) + 1 == 3
    assert len(parts.arcs) < len(G.arcs)
    assert np.array_equal(
        np.bincount(parts.arc_of_vertex, minlength=len(parts.arcs)), parts.numbers_of_vertices
    )

def test_drawing_inside(genus_3):
    V, F = genus_3
    means, inside = htl.reeb(V, F), htl.reeb(V, F, drawing="inside")
    assert np.array_equal(means.arcs, inside.arcs)
    assert np.array_equal(means.arc_of_vertex, inside.arc_of_vertex)
    assert not np.array_equal(means.positions, inside.positions)
    for line, radii in zip(inside.polylines, inside.radii):
        for point, radius in zip(line, radii):  # of the largest ball inside, which holds no vertex
            assert 0 < radius < np.linalg.norm(V - point, axis=1).min() * (1 + 1e-9)


def test_radii_of_a_tube():
    """Of a torus with a tube of radius r around a circle of radius R."""
    R, r, n = 1.0, 0.2, 120
    u, v = np.meshgrid(*[np.arange(k) * 2 * np.pi / k for k in (n, 24)], indexing="ij")
    x = (R + r * np.cos(v)) * np.cos(u)
    y = (R + r * np.cos(v)) * np.sin(u)
    V = np.column_stack([a.ravel() for a in (x, y, r * np.sin(v))])
    at = np.arange(n * 24).reshape(n, 24)
    a, b = at, np.roll(at, -1, 0)
    c, d = np.roll(b, -1, 1), np.roll(at, -1, 1)
    F = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])
    G = htl.reeb(V, F)
    on_cycle = np.concatenate([G.radii[i] for i in np.flatnonzero(G.is_on_cycle)])
    assert 0.8 * r < np.median(on_cycle) < 1.2 * r
    assert np.isclose(G.lengths[G.is_on_cycle].sum(), 2 * np.pi * R, rtol=0.15)
    assert np.isclose(np.median(G.girths[G.is_on_cycle]), 2 * np.pi * r, rtol=0.2)


def read_swc(path):
    rows, cycles = {}, []
    for line in open(path, encoding="ascii"):
        if line.startswith("# cycle:"):
            cycles.append(tuple(map(int, line.split()[2:])))
        elif not line.startswith("#"):
            number, kind, x, y, z, radius, parent = line.split()
            rows[int(number)] = (np.array([x, y, z], dtype=float), float(radius), int(parent))
    return rows, cycles


def test_swc(genus_3, tmp_path):
    G = htl.reeb(*genus_3)
    count = G.to_swc(tmp_path / "a.swc")
    rows, cycles = read_swc(tmp_path / "a.swc")
    assert len(rows) == count and len(cycles) == G.number_of_cycles == 3
    assert [parent for _, _, parent in rows.values()].count(-1) == 1
    length = 0.0
    for number, (point, radius, parent) in rows.items():
        assert radius >= 0 and (parent == -1 or 1 <= parent < number)
        if parent != -1:
            length += np.linalg.norm(point - rows[parent][0])
    assert np.isclose(length, G.lengths.sum())
    for copy, node in cycles:
        assert np.allclose(rows[copy][0], rows[node][0])


def test_a_sphere_is_a_line(tmp_path):
    V, F = htl.generate("sphere", faces=1280)
    G = htl.reeb(V, F, V[:, 0], simplify=0.1)
    assert (len(G.positions), len(G.arcs), G.number_of_cycles) == (2, 1, 0)
    assert not G.is_on_cycle[0] and list(G.node_types) == ["minimum", "maximum"]
    rows, cycles = read_swc(tmp_path / "a.swc") if G.to_swc(tmp_path / "a.swc") else (None, None)
    assert cycles == [] and len(rows) == len(G.polylines[0])


def test_integers_are_compared_exactly(torus):
    V, F = torus
    order = np.argsort(V @ [0.3, 0.2, 0.93], kind="stable")
    f = np.empty(len(V), dtype=np.int64)
    f[order] = 2**60 + np.arange(len(V))  # as floats, all of them are equal
    small = f - 2**60
    for exact in (f, f.astype(np.uint64)):
        G, expected = htl.reeb(V, F, exact, simplify=0), htl.reeb(V, F, small, simplify=0)
        assert np.array_equal(G.arcs, expected.arcs)
        assert np.array_equal(G.arc_of_vertex, expected.arc_of_vertex)
    assert len(htl.reeb(V, F, f.astype(float), simplify=0).arcs) > len(expected.arcs)
    with pytest.raises(ValueError, match=r"2\*\*63"):
        htl.reeb(V, F, np.full(len(V), 2**63, dtype=np.uint64))


def test_contours_end_at_a_boundary():
    n = 24
    angle = 2 * np.pi * (np.arange(n) + 0.3) / n
    ring = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    i, j = np.arange(n), (np.arange(n) + 1) % n
    V = np.concatenate([ring, 2 * ring])
    F = np.concatenate([np.stack([i, n + i, n + j], -1), np.stack([i, n + j, j], -1)])
    G, capped = htl.reeb(V, F, V[:, 1], simplify=0), htl.reeb(V, F, V[:, 1], simplify=0, capped=True)
    assert (len(G.positions), len(G.arcs), G.number_of_cycles) == (4, 4, 1)
    assert (len(capped.positions), len(capped.arcs), capped.number_of_cycles) == (2, 1, 0)


def test_vertices_without_faces_are_on_no_arc(torus):
    V, F = torus
    G = htl.reeb(np.vstack([V, [[9, 9, 9]]]), F)
    assert G.arc_of_vertex[-1] == -1 and G.arc_of_vertex[:-1].min() >= 0


def test_what_is_refused(torus):
    V, F = torus
    with pytest.raises(ValueError, match="f must be"):
        htl.reeb(V, F, V[:5, 0])
    with pytest.raises(ValueError, match="measure must be"):
        htl.reeb(V, F, measure="size")
    with pytest.raises(ValueError, match="drawing must be"):
        htl.reeb(V, F, drawing="outside")
    for shortest_arc in (-1, float("nan"), float("inf"), None):
        with pytest.raises(ValueError, match="shortest_arc"):
            htl.reeb(V, F, shortest_arc=shortest_arc)
    with pytest.raises(ValueError, match="sources"):
        htl.reeb(V, F, V[:, 0], sources=[0])
    with pytest.raises(ValueError, match="vertex"):
        htl.reeb(V, F, sources=[len(V)])
