"""Judges what `htloops cut --dual FILE` wrote, by what is in it alone: FILE LOOPS.json

A file of Gmsh is read by Gmsh, one of VTK by VTK. Then each cut has to cross its own loop once, and no
other one, counted with sign.
"""

import collections
import json
import sys

Mesh = collections.namedtuple("Mesh", "triangles cuts boundaries")  # by name, directed edges


def read_with_gmsh(name):
    import gmsh

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(name)
    groups = {}
    for dimension, tag in gmsh.model.getPhysicalGroups():
        elements = groups[gmsh.model.getPhysicalName(dimension, tag)] = []
        for entity in gmsh.model.getEntitiesForPhysicalGroup(dimension, tag):
            for kind, nodes in zip(*gmsh.model.mesh.getElements(dimension, entity)[::2]):
                assert kind == dimension  # lines are of type 1, triangles of type 2
                nodes = [int(node) - 1 for node in nodes]
                elements += zip(*(nodes[i :: dimension + 1] for i in range(dimension + 1)))
    gmsh.finalize()
    cuts = {name[4:]: edges for name, edges in groups.items() if name.startswith("cut ")}
    boundaries = {name: edges for name, edges in groups.items() if name.startswith("boundary ")}
    return Mesh(groups["surface"], cuts, boundaries)


def read_with_vtk(name):
    import vtk

    reader = vtk.vtkXMLUnstructuredGridReader() if name.endswith(".vtu") else vtk.vtkXMLPolyDataReader()
    reader.SetFileName(name)
    reader.Update()
    data = reader.GetOutput()
    array = {n: data.GetCellData().GetArray(n) for n in ("cut", "loop", "index", "jump", "left", "right")}
    corners = []
    for i in range(data.GetNumberOfCells()):
        ids = data.GetCell(i).GetPointIds()
        corners.append(tuple(ids.GetId(k) for k in range(ids.GetNumberOfIds())))
    cuts = {}
    for i, cell in enumerate(corners):
        value = {n: int(array[n].GetTuple1(i)) for n in array}
        if value["cut"] < 0:
            assert len(cell) == 3 and value["jump"] == 0
            continue
        kind = ("handle", "tunnel", "boundary")[value["loop"]]
        cuts.setdefault(f"{kind} {value['index']}", []).extend([cell] * value["jump"])
        # The triangles beside the line: on the left it is passed in its direction.
        for side, edge in (("left", cell), ("right", cell[::-1])):
            beside = corners[value[side]]
            assert edge in zip(beside, beside[1:] + beside[:1]), (i, side)
    return Mesh([cell for cell in corners if len(cell) == 3], cuts, None)


def corner_levels(triangles, cut):
    """For each corner of a triangle, how much a walk around its vertex has been given since it left the first."""
    jump = collections.Counter()
    for u, v in cut:  # who crosses it from right to left is given 1
        jump[u, v] += 1
        jump[v, u] -= 1
    side = {}  # by directed edge, the triangle to its left
    for t, triangle in enumerate(triangles):
        for i in range(3):
            side[triangle[i], triangle[(i + 1) % 3]] = t
    after = lambda t, v: triangles[t][(triangles[t].index(v) + 1) % 3]
    before = lambda t, v: triangles[t][(triangles[t].index(v) + 2) % 3]
    level = {}
    for first, triangle in enumerate(triangles):
        for v in triangle:
            if (first, v) in level:
                continue
            t = first  # or where the boundary is, if there is one
            while (after(t, v), v) in side:
                t = side[after(t, v), v]
                if t == first:
                    break
            begin, value = t, 0
            while True:
                level[t, v] = value
                out = before(t, v)  # the walk goes counterclockwise: over the edge from v to `out`
                if (v, out) not in side:
                    break
                t, value = side[v, out], value + jump[v, out]
                if t == begin:
                    assert value == 0, f"the cut ends at vertex {v}, inside the surface"
                    break
    return level, side


def crossings(triangles, cut, loops):
    """How often a cut is crossed by each of some closed walks of vertices, from right to left."""
    level, side = corner_levels(triangles, cut)
    beside = lambda u, v: side[(u, v) if (u, v) in side else (v, u)]
    result = []
    for walk in loops:
        pairs = [(u, v) for u, v in zip(walk, walk[1:] + walk[:1]) if u != v]
        result.append(sum(level[beside(u, v), u] - level[beside(u, v), v] for u, v in pairs))
    return result


def walk_of(line):
    """Vertices beside a loop: each place on an edge is moved to an end; neighbours share a face."""
    return [u if t < 1 else v for u, v, t in line["locations"]]


def main(name, loops_name):
    mesh = read_with_gmsh(name) if ".msh" in name else read_with_vtk(name)
    document = json.load(open(loops_name))
    loops = {}
    for i, pair in enumerate(document["pairs"]):
        for kind in ("handle", "tunnel"):
            loops[f"{kind} {i}"] = walk_of(pair[kind])
    boundaries = {f"boundary {i}": walk_of(b) for i, b in enumerate(document["boundaries"])}
    loops.update((n, walk) for n, walk in boundaries.items() if n in mesh.cuts)
    assert list(loops) == list(mesh.cuts), (list(loops), list(mesh.cuts))
    for name in mesh.cuts:
        expected = [int(other == name) for other in loops]
        found = crossings(mesh.triangles, mesh.cuts[name], list(loops.values()))
        assert found == expected, (name, found)
    if mesh.boundaries is not None:
        sides = {e for t in mesh.triangles for e in zip(t, t[1:] + t[:1])}
        border = sorted((u, v) for u, v in sides if (v, u) not in sides)
        assert sorted(mesh.boundaries) == sorted(boundaries)
        assert sorted(e for edges in mesh.boundaries.values() for e in edges) == border
    print(f"{len(mesh.triangles)} triangles, {len(loops)} cuts: each crosses its own loop once, and no other")


main(*sys.argv[1:])
