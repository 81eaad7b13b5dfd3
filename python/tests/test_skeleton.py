"""Curve skeletons."""

import json
import pickle
import subprocess
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from conftest import write_off

import handle_tunnel_loops as htl


def length_of(S):
    return np.linalg.norm(S.points[S.edges[:, 0]] - S.points[S.edges[:, 1]], axis=1).sum()


def test_definitions(genus_3):
    V, F = genus_3
    S = htl.curve_skeleton(V, F)
    count = len(S.points)
    assert S.genus == S.number_of_cycles == len(S.edges) - count + 1 == 3
    assert S.radii.shape == S.components.shape == S.is_inlet.shape == (count,)
    assert np.all(S.radii > 0) and not S.is_inlet.any() and not S.components.any()
    degrees = np.bincount(S.edges.ravel(), minlength=count)
    assert sum(len(arc) - 1 for arc in S.arcs) == len(S.edges)
    for i, arc in enumerate(S.arcs):
        assert np.all(degrees[arc[1:-1]] == 2)
        assert arc[0] == arc[-1] or np.all(degrees[arc[[0, -1]]] != 2)
        line, radii = S.polylines[i], S.radii[arc]
        steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
        assert np.isclose(S.lengths[i], steps.sum())
        assert S.smallest_radii[i] == radii.min()
        assert np.isclose(S.mean_radii[i], (steps * (radii[1:] + radii[:-1])).sum() / 2 / steps.sum())
        chord = np.linalg.norm(line[-1] - line[0])
        assert np.isinf(S.tortuosities[i]) if chord == 0 else np.isclose(S.tortuosities[i], steps.sum() / chord)
    assert S.point_of_vertex.shape == S.arc_of_vertex.shape == (len(V),)
    assert S.point_of_vertex.min() >= 0 and S.arc_of_vertex.min() >= 0
    on_arc = [S.point_of_vertex[v] in S.arcs[S.arc_of_vertex[v]] for v in range(len(V))]
    assert all(on_arc)


def test_the_certificate(genus_3):
    S = htl.curve_skeleton(*genus_3)
    assert S.certificate and S.certificate.failure == "" and S.certificate.edges_outside == []


def test_a_mesh_that_crosses_itself(torus):
    V, F = torus
    S = htl.curve_skeleton(np.vstack([V, V + [0.1, 0.1, 0.1]]), np.vstack([F, F + len(V)]))
    assert S.genus == S.number_of_cycles == 2
    assert not S.certificate and "crosses" in S.certificate.failure


def test_cavities():
    V, F = htl.generate("sphere", faces=400)
    in_turn = htl.curve_skeleton(np.vstack([V, 0.4 * V]), np.vstack([F, F[:, ::-1] + len(V)]))
    distances, size = np.linalg.norm(in_turn.points, axis=1), np.linalg.norm(V, axis=1).max()
    assert in_turn.certificate and in_turn.certificate.taken_alone == "" and not in_turn.components.any()
    assert np.all((0.39 * size < distances) & (distances < size))
    alike = htl.curve_skeleton(np.vstack([V, 0.4 * V]), np.vstack([F, F + len(V)]))
    assert "component 1 lies in component 0 with the same orientation" in alike.certificate.taken_alone
    assert set(alike.components) == {0, 1}


def test_inlets(plate):
    S = htl.curve_skeleton(*plate)
    assert S.is_inlet.sum() == 4 and S.number_of_cycles == 0


def test_networkx(genus_3):
    networkx = pytest.importorskip("networkx")
    S = htl.curve_skeleton(*genus_3)
    graph = S.to_networkx()
    assert graph.number_of_nodes() == len(S.points) and graph.number_of_edges() == len(S.edges)
    assert len(networkx.cycle_basis(graph)) == 3
    assert np.isclose(sum(d["length"] for _, _, d in graph.edges(data=True)), S.lengths.sum())


def read_swc(path):
    rows, cycles = {}, []
    for line in open(path, encoding="ascii"):
        if line.startswith("# cycle:"):
            cycles.append(tuple(map(int, line.split()[2:])))
        elif not line.startswith("#"):
            number, kind, x, y, z, radius, parent = line.split()
            rows[int(number)] = (int(kind), (float(x), float(y), float(z)), float(radius), int(parent))
    return rows, cycles


def test_swc(genus_3, tmp_path):
    S = htl.curve_skeleton(*genus_3)
    S.save(tmp_path / "a.swc")
    rows, cycles = read_swc(tmp_path / "a.swc")
    assert len(rows) == len(S.points) + 3 and len(cycles) == 3
    assert [row[3] for row in rows.values()].count(-1) == 1
    length = 0.0
    for number, (kind, point, radius, parent) in rows.items():
        assert parent == -1 or 1 <= parent < number
        assert (kind == 7) == (number in [copy for copy, _ in cycles])
        if parent != -1:
            length += np.linalg.norm(np.subtract(point, rows[parent][1]))
    assert np.isclose(length, length_of(S))
    for copy, node in cycles:
        assert rows[copy][1:3] == rows[node][1:3]
    assert {row[1] for row in rows.values()} == set(map(tuple, S.points.tolist()))


def test_vtp(genus_3, tmp_path):
    S = htl.curve_skeleton(*genus_3)
    S.save(tmp_path / "a.vtp")
    piece = ElementTree.parse(tmp_path / "a.vtp").getroot().find("PolyData/Piece")
    arrays = {array.get("Name"): array for array in piece.iter("DataArray")}
    read = {name: np.array(array.text.split(), dtype=float) for name, array in arrays.items() if array.text}
    assert np.array_equal(read["Points"].reshape(-1, 3), S.points)
    assert np.array_equal(read["MaximumInscribedSphereRadius"], S.radii)
    assert arrays["Points"].get("type") == arrays["MaximumInscribedSphereRadius"].get("type") == "Float64"
    assert np.array_equal(read["Arc"], np.arange(len(S.arcs)))
    lines = piece.find("Lines")
    numbers, ends = (np.array(array.text.split(), dtype=int) for array in lines.iter("DataArray"))
    assert all(np.array_equal(*pair) for pair in zip(np.split(numbers, ends[:-1]), S.arcs))


@pytest.mark.parametrize("end", ["vtp", "binary.vtp"])
def test_vtk_reads_it(genus_3, tmp_path, end):
    vtk = pytest.importorskip("vtk")
    S = htl.curve_skeleton(*genus_3)
    S.save(tmp_path / f"a.{end}")
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / f"a.{end}"))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfPoints() == len(S.points) and data.GetNumberOfLines() == len(S.arcs)
    assert data.GetPoint(0) == tuple(S.points[0])


def test_all_formats(genus_3, tmp_path):
    S = htl.curve_skeleton(*genus_3)
    for end in ["json", "csv", "swc", "vtp", "binary.vtp", "obj", "ply", "polylines.txt", "graphml", "dot"]:
        S.save(tmp_path / f"a.{end}")
        assert (tmp_path / f"a.{end}").stat().st_size > 100
    read = json.loads((tmp_path / "a.json").read_text())
    assert read["format"] == "htloops-skeleton/1" and read["certificate"]["cycles"]
    assert all(np.array_equal(arc["polyline"], line) for arc, line in zip(read["arcs"], S.polylines))
    assert len(read["arcs"]) == len(S.arcs)
    points = [node["position"] for node in read["nodes"]]
    assert [points[arc["target"]] for arc in read["arcs"]] == [line[-1].tolist() for line in S.polylines]
    points += [point for arc in read["arcs"] for point in arc["polyline"][1:-1]]
    assert np.array_equal(np.array(points)[read["vertex_point"]], S.points[S.point_of_vertex])
    obj = [line.split() for line in (tmp_path / "a.obj").read_text().splitlines()]
    assert np.array_equal([list(map(float, words[1:])) for words in obj if words[0] == "v"], S.points)
    lines = [np.array(words[1:], dtype=int) - 1 for words in obj if words[0] == "l"]
    assert all(np.array_equal(*pair) for pair in zip(lines, S.arcs)) and len(lines) == len(S.arcs)
    with pytest.raises(ValueError, match="one of .json"):
        S.save(tmp_path / "a.png")
    with pytest.raises(OSError, match="cannot write"):
        S.save(tmp_path / "missing" / "a.swc")


def test_pickled_ones_are_the_same(genus_3, tmp_path):
    S = htl.curve_skeleton(*genus_3)
    pickle.loads(pickle.dumps(S)).save(tmp_path / "b.vtp")
    S.save(tmp_path / "a.vtp")
    assert (tmp_path / "a.vtp").read_text() == (tmp_path / "b.vtp").read_text()


def test_the_program_says_the_same(genus_3, tmp_path, htloops):
    V, F = genus_3
    write_off(tmp_path / "a.off", V, F)
    subprocess.run(
        [htloops, "skeleton", "a.off", "--lines", "a.swc", "--quiet"], cwd=tmp_path, check=True
    )
    htl.curve_skeleton(V, F).save(tmp_path / "b.swc")
    assert (tmp_path / "a.swc").read_text() == (tmp_path / "b.swc").read_text()


def test_what_is_refused(torus):
    V, F = torus
    for limb in [-1.0, float("inf"), float("nan"), None]:
        with pytest.raises(ValueError, match="shortest_limb"):
            htl.curve_skeleton(V, F, limb)
    with pytest.raises(htl.MeshError):
        htl.curve_skeleton(V, F[:, ::-1][:100].repeat(2, axis=0))
