"""Within pvpython: FOLDER_OF_PLUGIN PICTURE VERSION_OF_PYTHON. Loads the plugin, runs every filter, and prints for each
check whether it holds. No picture is drawn where there is no display."""

import collections
import json
import logging
import math
import os
import sys
import traceback

folder, picture, version = sys.argv[1:4]


def say(**words):
    print("JUDGED " + json.dumps(words), flush=True)


say(python=f"{sys.version_info[0]}.{sys.version_info[1]}")
if version != f"{sys.version_info[0]}.{sys.version_info[1]}":
    sys.exit()
sys.path.insert(0, folder)
import handle_tunnel_loops_paraview

handle_tunnel_loops_paraview.load(globals())

import numpy as np
import paraview
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray, reference
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCellLocator, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

htl = handle_tunnel_loops_paraview.module()
CHECKS = []


def check(function):
    CHECKS.append(function)
    return function


class Sayings(logging.Handler):
    """What ParaView is told to show."""

    def __init__(self):
        super().__init__()
        self.all = []
        paraview.logger.addHandler(self)

    def emit(self, record):
        self.all.append((record.levelname, record.getMessage()))

    def taken(self):
        all_, self.all = self.all, []
        return all_


SAYINGS = Sayings()


# ---- Data


def polydata(V, faces, **point_arrays):
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(V), deep=1))
    sizes = [len(f) for f in faces]
    cells.SetData(numpy_to_vtkIdTypeArray(np.cumsum([0, *sizes]), deep=1),
                  numpy_to_vtkIdTypeArray(np.array([v for f in faces for v in f], dtype=np.int64), deep=1))
    data.SetPoints(points)
    data.SetPolys(cells)
    for name, values in point_arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def source_of(data):
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def generated(kind, **options):
    return source_of(polydata(*htl.generate(kind, **options)))


def torus_of_quads(n=24, m=12):
    V = [((3 + math.cos(b)) * math.cos(a), (3 + math.cos(b)) * math.sin(a), math.sin(b))
         for a in (2 * math.pi * i / n for i in range(n)) for b in (2 * math.pi * j / m for j in range(m))]
    return np.array(V), [(i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m)
                         for i in range(n) for j in range(m)]


def fetched(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def array_of(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


def words_of(attributes, name):
    array = attributes.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def lines_of(data):
    offsets, ids = (vtk_to_numpy(a) for a in (data.GetLines().GetOffsetsArray(), data.GetLines().GetConnectivityArray()))
    points = vtk_to_numpy(data.GetPoints().GetData())
    return [ids[a:b] for a, b in zip(offsets[:-1], offsets[1:])], points


def length_of(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def triangles_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def genus_of(F):
    uses = collections.Counter(frozenset((t[i - 1], t[i])) for t in F.tolist() for i in range(3))
    assert set(uses.values()) == {2}, "not closed"
    ways = collections.Counter((t[i - 1], t[i]) for t in F.tolist() for i in range(3))
    assert set(ways.values()) == {1}, "not oriented alike"
    vertices = {int(v) for v in F.ravel()}
    parent = {v: v for v in vertices}

    def find(a):
        while parent[a] != a:
            parent[a] = parent[parent[a]]
            a = parent[a]
        return a

    for e in uses:
        a, b = e
        parent[find(a)] = find(b)
    parts = len({find(v) for v in vertices})
    return parts - (len(vertices) - len(uses) + len(F)) // 2


def farthest_from(surface, points):
    locator = vtkCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    worst, cell, sub, square = 0.0, reference(0), reference(0), reference(0.0)
    for p in points:
        locator.FindClosestPoint(p, [0, 0, 0], cell, sub, square)
        worst = max(worst, math.sqrt(float(square)))
    return worst


def check_loops(data, surface):
    """Each line is closed, lies on the surface, and has the length that it says."""
    rows, points = lines_of(data)
    for row, length in zip(rows, array_of(data.GetCellData(), "length")):
        assert row[0] == row[-1] and len(row) > 3
        assert abs(length_of(points[row]) - length) < 1e-6 * length
    assert farthest_from(surface, points) < 1e-6
    return len(rows)


# ---- Checks


@check
def loops_of_a_source_with_seams():
    source = simple.Superquadric(Toroidal=1, ThetaResolution=40, PhiResolution=24)
    loops = HandleTunnelLoops(Input=source)
    data = fetched(loops)
    assert check_loops(data, fetched(source)) == 2
    cells = data.GetCellData()
    assert array_of(cells, "pair").tolist() == [0, 0] and array_of(cells, "kind").tolist() == [0, 1]
    assert words_of(cells, "bounds") == ["inside", "outside"]
    assert cells.GetScalars().GetName() == "kind"
    assert vtk_to_numpy(data.GetFieldData().GetArray("genus")).tolist() == [1]
    loops.Mending = "Take the surface as it is"  # with boundary curves along the seams
    loops.Boundaries = 1
    data = fetched(loops)
    assert set(array_of(data.GetCellData(), "kind").tolist()) == {2} and check_loops(data, fetched(source)) >= 2
    assert not SAYINGS.taken()


@check
def loops_are_chosen_by_length_and_by_share():
    source = generated("scan", faces=40000, genus=2, bridges=3, tunnels=2, seed=1)
    loops = HandleTunnelLoops(Input=source)
    every = fetched(loops)
    assert check_loops(every, fetched(source)) == 14
    lengths = array_of(every.GetCellData(), "length").reshape(-1, 2).min(axis=1)
    loops.ShorterThan = "0.9"
    short = fetched(loops)
    expected = np.flatnonzero(lengths < 0.9)
    assert 0 < len(expected) < 7
    assert array_of(short.GetCellData(), "pair").tolist() == np.repeat(expected, 2).tolist()
    bounds = np.array(fetched(source).GetBounds())
    diagonal = np.linalg.norm(bounds[1::2] - bounds[::2])
    loops.ShorterThan = f"{0.9 / diagonal * 100}%"
    assert fetched(loops).GetNumberOfLines() == short.GetNumberOfLines()
    loops.LongerThan, loops.ShorterThan, loops.Show = "0.9", "", "The shorter loop of each pair"
    rest = array_of(fetched(loops).GetCellData(), "length")
    assert sorted(rest.tolist()) == sorted(lengths[lengths >= 0.9].tolist())
    loops.Show = "Tunnel loops"
    assert set(array_of(fetched(loops).GetCellData(), "kind").tolist()) == {1}
    assert not SAYINGS.taken()


@check
def loops_are_measured_if_asked_for():
    V, F = htl.generate("multi-torus", genus=3, faces=4000)
    loops = HandleTunnelLoops(Input=source_of(polydata(V, F)), Measures=1)
    cells = fetched(loops).GetCellData()
    M = htl.measure(V, F, htl.loops(V, F))
    pairs = array_of(cells, "pair")
    assert np.array_equal(array_of(cells, "thickness"), M.thickness.diameters[pairs])
    assert np.array_equal(array_of(cells, "clear_width"), M.clear_width.diameters[pairs]) and np.all(M.noise > 0)
    loops.Basis = "Shortest"
    assert fetched(loops).GetNumberOfLines() in (0, 6)  # or it says what measures want
    SAYINGS.taken()


@check
def quads_polygons_and_strips_are_taken_where_their_points_are():
    V, quads = torus_of_quads()
    source = source_of(polydata(V, quads, height=V[:, 2]))
    for surface in (source, simple.TriangleStrips(Input=simple.Triangulate(Input=source))):
        assert fetched(HandleTunnelLoops(Input=surface)).GetNumberOfLines() == 2
        data = fetched(RemoveHandles(Input=surface, Which="All handles"))
        points, height = vtk_to_numpy(data.GetPoints().GetData()), array_of(data.GetPointData(), "height")
        origin = array_of(data.GetPointData(), "vertex_origin")
        is_new = origin < 0
        assert genus_of(triangles_of(data)) == 0 and 0 < is_new.sum() < 0.5 * len(origin)
        assert np.array_equal(points[~is_new], V[origin[~is_new]]) and np.array_equal(height[~is_new], points[~is_new, 2])
        assert np.all(np.isnan(height[is_new]))
    cylinder = simple.Cylinder(Resolution=12)  # with two polygons of twelve corners
    assert fetched(HandleTunnelLoops(Input=cylinder)).GetNumberOfLines() == 0
    assert not SAYINGS.taken()


@check
def data_of_cells_is_kept():
    V, quads = torus_of_quads()
    quads = [(0, 1, 1), *quads]  # one without area goes before
    data = polydata(V, quads)
    number, names = np.arange(len(quads)), vtkStringArray()
    names.SetName("name")
    for i in number:
        names.InsertNextValue(f"quad {i}")
    colours = numpy_to_vtk(np.stack([number % 200, number % 100, number % 50], axis=1).astype(np.uint8), deep=1)
    colours.SetName("colour")
    numbers = numpy_to_vtk(number, deep=1)
    numbers.SetName("number")
    for array in (names, colours, numbers):
        data.GetCellData().AddArray(array)
    result = fetched(RemoveHandles(Input=source_of(data), Which="All handles", By="Cuts along handle loops"))
    cells = result.GetCellData()
    parent, number = array_of(cells, "face_parent"), array_of(cells, "number")
    kept = parent >= 0
    points, F = vtk_to_numpy(result.GetPoints().GetData()), triangles_of(result)
    assert kept.sum() > 0.8 * 2 * len(quads) and np.all(number[~kept] == 0) and (~kept).sum() > 0
    for f in np.flatnonzero(kept).tolist():  # a piece lies on the quad that it says
        corners = V[list(quads[number[f]])]
        assert np.all(points[F[f]] >= corners.min(axis=0) - 1e-9) and np.all(points[F[f]] <= corners.max(axis=0) + 1e-9)
        assert cells.GetAbstractArray("name").GetValue(f) == f"quad {number[f]}"
    assert array_of(cells, "colour").dtype == np.uint8 and array_of(cells, "colour").shape == (len(F), 3)
    assert np.array_equal(array_of(cells, "colour")[kept][:, 0], number[kept] % 200)


@check
def handles_are_removed_as_they_are_chosen():
    V, F = htl.generate("scan", faces=40000, genus=2, bridges=3, tunnels=2, seed=1)
    source = source_of(polydata(V, F))
    L = htl.loops(V, F)
    remove = RemoveHandles(Input=source)

    def genus():
        data = fetched(remove)
        before, after = (int(vtk_to_numpy(data.GetFieldData().GetArray(f"genus_{x}"))[0]) for x in ("before", "after"))
        assert before == 7 and genus_of(triangles_of(data)) == after
        assert data.GetNumberOfPoints() == len(np.unique(triangles_of(data)))
        return after

    lengths = np.array([min(h.length, t.length) for h, t in L])
    remove.Which, remove.Limit = "Those with a shorter loop than", "0.9"
    assert genus() == 7 - (lengths < 0.9).sum() == 2
    remove.Which, remove.Genus = "The smallest, down to a genus", 5
    assert genus() == 5
    remove.Which, remove.Pairs = "Pairs", "0, 1"
    assert genus() == 5
    remove.Which = "All handles"
    assert genus() == 0
    noise = htl.measure(V, F, L).noise
    limit = float(np.sort(noise)[2:4].mean())
    remove.Which, remove.Limit = "Noise: what is thinner, or narrower, than", f"{limit}"
    assert genus() == 4
    remove.Which, remove.Limit = "Those with a shorter loop than", "1e-6"
    assert genus() == 7
    assert not SAYINGS.taken()


@check
def reeb_graphs_have_a_cycle_for_each_handle():
    V, F = htl.generate("multi-torus", genus=3, faces=4000)
    source = source_of(polydata(V, F, height=V[:, 0], vectors=V))
    graph = SurfaceReebGraph(Input=source)
    assert graph.Function == "(a front)"
    for function in ("(a front)", "height"):
        graph.Function = function
        data = fetched(graph)
        rows, points = lines_of(data)
        cells = data.GetCellData()
        nodes = np.stack([array_of(cells, "lower_node"), array_of(cells, "upper_node")], axis=1)
        assert len(rows) - len(np.unique(nodes)) + 1 == 3  # it is connected
        for row, length in zip(rows, array_of(cells, "length")):
            assert abs(length_of(points[row]) - length) < 1e-6 * (1 + length)
        assert len(array_of(data.GetPointData(), "radius")) == len(points)
    ends = {}
    for row, (a, b) in zip(rows, nodes.tolist()):
        for node, p in ((a, points[row[0]]), (b, points[row[-1]])):
            assert np.allclose(ends.setdefault(node, p), p)
        assert points[row[0], 0] <= points[row[-1], 0] + 1e-9  # of this function
    assert not SAYINGS.taken()
    graph.Function = "vectors"
    assert fetched(graph).GetNumberOfLines() == 0 and "one component" in SAYINGS.taken()[0][1]


@check
def skeletons_lie_inside_with_their_radii():
    source = generated("multi-torus", genus=3, faces=4000)
    data = fetched(CurveSkeleton(Input=source))
    rows, points = lines_of(data)
    radius = array_of(data.GetPointData(), "radius")
    inside = vtkImplicitPolyDataDistance()
    inside.SetInput(fetched(source))
    for p, r in zip(points, radius):
        assert 0 < r <= -inside.EvaluateFunction(p) * 1.01 + 1e-9, (p, r)
    joints = collections.Counter(tuple(np.round(points[row[k]], 9)) for row in rows for k in (0, -1))
    assert len(rows) - len(joints) + 1 == 3
    assert data.GetPointData().GetScalars().GetName() == "radius"
    assert not SAYINGS.taken()


@check
def throats_are_closed_lines():
    source = generated("multi-torus", genus=2, faces=3000)
    data = fetched(Throats(Input=source))
    assert check_loops(data, fetched(source)) >= 2
    assert np.allclose(array_of(data.GetCellData(), "diameter") * math.pi, array_of(data.GetCellData(), "length"))
    assert not SAYINGS.taken()


FILTERS = [HandleTunnelLoops, RemoveHandles, SurfaceReebGraph, CurveSkeleton, Throats]


@check
def what_is_no_surface_is_said_and_leaves_nothing():
    V, quads = torus_of_quads()
    with_fin = source_of(polydata([*V, (9, 0, 0)], [*quads, (0, 1, len(V))]))
    for filter_ in FILTERS:
        proxy = filter_(Input=with_fin)
        assert fetched(proxy).GetNumberOfCells() == 0
        (level, said), = SAYINGS.taken()
        assert level == "ERROR" and "1 edge has more than two faces" in said and "try Mending: Repair" in said, said
        assert "\n" not in said and "repair()" not in said
        proxy.Mending = "Repair"
        proxy.UpdatePipeline()
        assert not [one for one in SAYINGS.taken() if one[0] == "ERROR"]
    proxy = HandleTunnelLoops(Input=with_fin, Mending="Repair")
    assert fetched(proxy).GetNumberOfLines() == 2


@check
def empty_and_open_surfaces():
    for filter_ in FILTERS:
        assert fetched(filter_(Input=source_of(vtkPolyData()))).GetNumberOfCells() == 0
        assert SAYINGS.taken() and not SAYINGS.taken()
        assert fetched(filter_(Input=simple.Line())).GetNumberOfCells() == 0
        assert "no polygons" in SAYINGS.taken()[0][1]
    plane = simple.Plane(XResolution=6, YResolution=6)
    assert fetched(HandleTunnelLoops(Input=plane)).GetNumberOfLines() == 0
    assert fetched(HandleTunnelLoops(Input=plane, Boundaries=1)).GetNumberOfLines() == 1
    assert fetched(RemoveHandles(Input=plane, Which="All handles")).GetNumberOfPolys() == 72
    assert not SAYINGS.taken()


@check
def wrong_properties_are_said():
    source = generated("torus", faces=600)
    for options, words in (({"ShorterThan": "abc"}, "abc is not a length"), ({"LongerThan": "-1"}, "-1 is not a length"),
                           ({"ShorterThan": "nan%"}, "nan% is not a length")):
        assert fetched(HandleTunnelLoops(Input=source, **options)).GetNumberOfCells() == 0
        assert words in SAYINGS.taken()[0][1]
    for options, words in (({"Which": "Pairs"}, "not a list of pairs"), ({"Which": "Pairs", "Pairs": "7"}, "7"),
                           ({"Limit": ""}, "Limit is empty")):
        assert fetched(RemoveHandles(Input=source, **options)).GetNumberOfCells() == 0
        assert words in SAYINGS.taken()[0][1]


@check
def progress_is_told_and_who_aborts_gets_nothing():
    proxy = HandleTunnelLoops(Input=generated("multi-torus", genus=60, faces=200000))
    algorithm, seen = proxy.GetClientSideObject(), []
    is_to_stop = [True]

    def watch(caller, event):
        seen.append(caller.GetProgress())
        if is_to_stop[0]:
            caller.SetAbortExecute(1)

    algorithm.AddObserver("ProgressEvent", watch)
    proxy.UpdatePipeline()
    assert algorithm.GetOutputDataObject(0).GetNumberOfCells() == 0 and 0 < len(seen)
    assert ("WARNING", "Handle Tunnel Loops: interrupted") in SAYINGS.taken()
    is_to_stop[0], seen[:] = False, []
    proxy.ShorterThan = "100%"
    proxy.UpdatePipeline()
    assert algorithm.GetOutputDataObject(0).GetNumberOfCells() == 120
    assert len(seen) > 2 and seen == sorted(seen) and seen[-1] == 1
    assert not SAYINGS.taken()


@check
def of_several_blocks_each_is_worked_on():
    both = simple.GroupDatasets(Input=[generated("torus", faces=600), generated("multi-torus", genus=2, faces=2000)])
    data = fetched(HandleTunnelLoops(Input=both))
    assert [data.GetBlock(i).GetNumberOfLines() for i in range(2)] == [2, 4]


@check
def precision_of_points_stays():
    V, F = htl.generate("torus", faces=600)
    for kind in (np.float32, np.float64):
        data = fetched(RemoveHandles(Input=source_of(polydata(V.astype(kind), F)), Which="All handles"))
        assert vtk_to_numpy(data.GetPoints().GetData()).dtype == kind


@check
def a_picture_can_be_drawn():
    if not os.environ.get("DISPLAY"):
        return  # ParaView of Debian crashes then
    source = generated("multi-torus", genus=3, faces=6000)
    view = simple.CreateRenderView()
    view.ViewSize, view.Background, view.UseColorPaletteForBackground = [640, 480], [1, 1, 1], 0
    surface = simple.Show(source, view)
    surface.Opacity, surface.DiffuseColor, surface.AmbientColor = 0.4, [0.8, 0.8, 0.8], [0.8, 0.8, 0.8]
    size = fetched(source).GetLength()
    for lines, colour in ((HandleTunnelLoops(Input=source, Show="Handle loops"), [0.9, 0.4, 0]),
                          (HandleTunnelLoops(Input=source, Show="Tunnel loops"), [0, 0.4, 0.9]),
                          (CurveSkeleton(Input=source), [0.1, 0.6, 0.1])):
        shown = simple.Show(simple.Tube(Input=lines, Radius=0.004 * size), view)
        simple.ColorBy(shown, None)
        shown.DiffuseColor = shown.AmbientColor = colour
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [0.3, -0.8, 1.2], [0, 0, 0], [0, 0, 1]
    simple.ResetCamera(view)
    simple.SaveScreenshot(picture, view)
    assert os.path.getsize(picture) > 10000


for one in CHECKS:
    SAYINGS.taken()
    failure = ""
    try:
        one()
    except BaseException:
        failure = traceback.format_exc()
    say(check=one.__name__, failure=failure)
