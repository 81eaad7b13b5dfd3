"""Filters for ParaView that use the Python module handle_tunnel_loops, in the menu Filters > Handles.

Load this file with Tools > Manage Plugins > Load New. In scripts, and in ParaView's Python shell:

    import handle_tunnel_loops_paraview
    handle_tunnel_loops_paraview.load(globals())

Use these lines also for ParaView 5.11 with Python 3.11, which refuses all Python plugins before it reads them.
"""

import glob
import inspect
import os
import re
import sys

import numpy as np

if not hasattr(inspect, "getargspec"):  # ParaView 5.11 uses it; Python 3.11 removed it
    inspect.getargspec = inspect.getfullargspec

from paraview import print_error, print_warning
from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

paraview_plugin_name = "Handle and tunnel loops"
paraview_plugin_version = "0.1"


def module():
    """Imports handle_tunnel_loops from where Python looks, or from the place where both are installed."""
    try:
        import handle_tunnel_loops
    except ImportError:
        here = os.path.abspath(__file__)
        above = [os.path.dirname(here)]
        while len(above) < 4:
            above.append(os.path.dirname(above[-1]))
        for folder in [above[2], *glob.glob(os.path.join(above[3], "lib*", "python3*", "*-packages"))]:
            if os.path.isdir(os.path.join(folder, "handle_tunnel_loops")):
                sys.path.append(folder)
        try:
            import handle_tunnel_loops
        except ImportError as error:
            raise ImportError(
                f"Python {sys.version_info[0]}.{sys.version_info[1]} does not find the module handle_tunnel_loops ({error}): "
                "install it with `cmake --install`, and add the folder that contains it to PYTHONPATH"
            ) from None
    return handle_tunnel_loops


# ---- Properties; ParaView shows them in this order.


class Property:
    """A property with its XML. `only` is (NAME, VALUES): shown only if that property has one of these values. The label
    is the name in words, because scripts address properties by their labels."""

    def __init__(self, name, default, help_, kind="String", domain="", only=None):
        self.name, self.default = name, default
        label = re.sub("(?<=[a-z])(?=[A-Z])", " ", name)
        hints = ""
        if only is not None:
            hints = "<Hints>" + "".join(
                f'<PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="{only[0]}" '
                f'values="{" ".join(map(str, only[1]))}"/>'
            ) + "</Hints>"
        self.xml = (
            f'<{kind}VectorProperty name="{name}" label="{label}" command="Set{name}" number_of_elements="1" '
            f'default_values="{default}">{domain}<Documentation>{help_}</Documentation>{hints}</{kind}VectorProperty>'
        )


def text(name, help_, only=None):
    return Property(name, "", help_, only=only)


def real(name, default, help_, only=None):
    return Property(name, default, help_, "Double", '<DoubleRangeDomain name="range" min="0"/>', only)


def whole(name, default, help_, only=None):
    return Property(name, default, help_, "Int", '<IntRangeDomain name="range" min="0"/>', only)


def flag(name, default, help_, only=None):
    return Property(name, int(default), help_, "Int", '<BooleanDomain name="bool"/>', only)


def choice(name, words, help_, default=0, only=None):
    entries = "".join(f'<Entry text="{word}" value="{i}"/>' for i, word in enumerate(words))
    domain = f'<EnumerationDomain name="enum">{entries}</EnumerationDomain>'
    return Property(name, default, help_, "Int", domain, only)


def point_array(name, none, help_):
    domain = (
        f'<ArrayListDomain name="array_list" attribute_type="Scalars" input_domain_name="input_array" none_string="{none}">'
        '<RequiredProperties><Property function="Input" name="Input"/></RequiredProperties></ArrayListDomain>'
    )
    return Property(name, none, help_, domain=domain)


MENDING = choice(
    "Mending",
    ["Take the surface as it is", "Weld points in the same place", "Repair"],
    "Meshes in ParaView often have seams, where points coincide. Repair also drops duplicate and degenerate faces, "
    "splits non-manifold edges and points, and orients faces consistently.",
    default=1,
)


def filter_of_surfaces(label, *properties):
    """Makes a class a filter of surfaces with these properties."""

    def setter(name):
        def set_value(self, value):
            if self.values[name] != value:
                self.values[name] = value
                self.Modified()

        return set_value

    def decorate(cls):
        every = [MENDING, *properties]
        cls.defaults = {one.name: one.default for one in every}
        for one in every:
            setattr(cls, f"Set{one.name}", setter(one.name))
        arrays = '<InputArrayDomain name="input_array" attribute_type="point" number_of_components="1" optional="1"/>'
        cls = smdomain.xml(arrays)(cls)
        cls = smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=True)(cls)
        cls = smproperty.input(name="Input", port_index=0, multiple_input=False)(cls)
        cls = smproperty.xml(
            f"<Documentation>{cls.__doc__}</Documentation>" + "".join(one.xml for one in [*properties, MENDING]))(cls)
        cls = smhint.xml('<ShowInMenu category="Handles"/>')(cls)
        return smproxy.filter(label=label, support_reload=False)(cls)

    return decorate


# ---- Data of VTK, and arrays


class Surface:
    """The triangles of a polydata, V and F, with the points and cells that they come from."""

    def __init__(self, htl, data, mending):
        triangles = vtkTriangleFilter()
        triangles.PassVertsOff()
        triangles.PassLinesOff()
        triangles.SetInputData(data)
        triangles.Update()
        self.data = triangles.GetOutput()
        if self.data.GetNumberOfPolys() == 0:
            raise ValueError("the input has no polygons")
        self.V = vtk_to_numpy(self.data.GetPoints().GetData()).astype(float)
        self.F = vtk_to_numpy(self.data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.vertex_origin, self.face_origin = np.arange(len(self.V)), np.arange(len(self.F))
        if mending != 0:
            steps = ["degenerate", "weld"] if mending == 1 else None
            self.V, self.F, self.face_origin, self.vertex_origin, _ = htl.repair(self.V, self.F, steps=steps)
        self.diagonal = float(np.linalg.norm(np.ptp(self.V[np.unique(self.F)], axis=0)))


def as_vtk(name, values):
    """A VTK array of numbers or of words."""
    if len(values) > 0 and isinstance(values[0], str):
        array = vtkStringArray()
        array.SetNumberOfValues(len(values))
        for i, word in enumerate(values):
            array.SetValue(i, word)
    else:
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    return array


def cells_of(offsets, corners):
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.asarray(offsets, dtype=np.int64), deep=1),
                  numpy_to_vtkIdTypeArray(np.asarray(corners, dtype=np.int64), deep=1))
    return cells


def points_of(V):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(V), deep=1))
    return points


def lines_of(polylines, are_closed, cell_arrays, point_arrays=None, facts=None):
    """A polydata with a line for each polyline; a closed one returns to its first point."""
    data = vtkPolyData()
    V = np.concatenate([np.zeros((0, 3)), *polylines])
    starts = np.cumsum([0, *map(len, polylines)])
    rows = [np.append(np.arange(a, b), [a] if are_closed else []) for a, b in zip(starts[:-1], starts[1:])]
    data.SetPoints(points_of(V))
    data.SetLines(cells_of(np.cumsum([0, *map(len, rows)]), np.concatenate([np.zeros(0), *rows])))
    for attributes, arrays in ((data.GetCellData(), cell_arrays), (data.GetPointData(), point_arrays or {}),
                               (data.GetFieldData(), facts or {})):
        for name, values in arrays.items():
            attributes.AddArray(as_vtk(name, values))
    return data


def copy_attributes(source, target, origin):
    """Copies the data of the elements in `origin`; new elements, -1 there, get NaN or 0."""
    is_new = origin < 0
    for i in range(source.GetNumberOfArrays()):
        old = source.GetAbstractArray(i)
        if old.GetName() is None or source.IsArrayAnAttribute(i) == source.NORMALS:
            continue  # they belong to the old surface; ParaView computes new ones
        if isinstance(old, vtkDataArray):
            values = vtk_to_numpy(old)[origin]
            values[is_new] = np.nan if values.dtype.kind == "f" else 0
            new = numpy_to_vtk(np.ascontiguousarray(values), deep=1, array_type=old.GetDataType())
            for k in range(old.GetNumberOfComponents()):
                if old.GetComponentName(k):
                    new.SetComponentName(k, old.GetComponentName(k))
        elif isinstance(old, vtkStringArray):
            new = as_vtk("", ["" if j < 0 else old.GetValue(j) for j in origin.tolist()])
        else:
            continue
        new.SetName(old.GetName())
        target.AddArray(new)


# ---- Filters


class SurfaceFilter(VTKPythonAlgorithmBase):
    """Reports errors, after which the output is empty."""

    def __init__(self):
        super().__init__(nInputPorts=1, inputType="vtkPolyData", nOutputPorts=1, outputType="vtkPolyData")
        self.values = dict(self.defaults)

    def RequestData(self, request, inputs, outputs):
        data, output = vtkPolyData.GetData(inputs[0]), vtkPolyData.GetData(outputs)
        output.Initialize()
        self.SetAbortExecute(0)  # clears an earlier abort
        try:
            htl = module()
            output.ShallowCopy(self.answer(htl, Surface(htl, data, self.values["Mending"])))
        except ImportError as error:
            print_error(str(error))
        except htl.MeshError as error:
            lines = [line.strip() for line in str(error).splitlines() if not line.startswith("repair()")]
            self.say(print_error, "; ".join([*lines, *self.advice()]))
        except htl.Interrupted:
            self.say(print_warning, "interrupted")
        except (ValueError, TypeError, MemoryError) as error:
            self.say(print_error, error)
        return 1

    def say(self, how, what):
        how("%s: %s", self.label, what)

    def advice(self):
        return [] if self.values["Mending"] == 2 else ["try Mending: Repair"]

    def told(self, begin=0.0, end=1.0):
        """A callable that shows the progress, and returns whether to continue."""

        def progress(fraction):
            self.UpdateProgress(begin + (end - begin) * fraction)
            return not self.GetAbortExecute()

        return progress

    def length(self, name, diagonal):
        """A length, or a share of the diagonal; None if there is no text."""
        words = (self.values[name] or "").strip()  # ParaView has None for no text
        if not words:
            return None
        try:
            value = float(words[:-1]) / 100 * diagonal if words.endswith("%") else float(words)
        except ValueError:
            value = np.nan
        if not value >= 0:
            raise ValueError(
                f"{words} is not a length: use a number, such as 0.25, or a percentage of the diagonal of the bounding box, "
                "such as 3%")
        return value

    def numbers(self, name):
        words = (self.values[name] or "").replace(",", " ").split()
        if not words or not all(word.isdecimal() for word in words):
            raise ValueError(f"'{' '.join(words)}' is not a list of pairs: use their numbers, such as 0, 3")
        return [int(word) for word in words]


BASES = ["pure", "shortest"]
KINDS = ["handle", "tunnel", "boundary"]


@filter_of_surfaces(
    "Handle Tunnel Loops",
    choice("Show", ["Both loops of each pair", "Handle loops", "Tunnel loops", "The shorter loop of each pair"],
           "Handle loops bound inside the solid, tunnel loops outside."),
    text("ShorterThan",
         "Show only pairs with a loop shorter than this: a length, such as 0.25, or a percentage of the diagonal of the "
         "bounding box, such as 3%. Empty: all pairs."),
    text("LongerThan", "Show only pairs whose loops are both at least this long. Empty: all pairs."),
    flag("Boundaries", False, "Also show the boundary curves of the surface."),
    flag("Measures", False,
         "Measure the thickness of each handle and the clear width of its hole. Takes longer."),
    choice("Basis", ["Pure", "Shortest"],
           "Shortest: shorter loops, which may bound on either side. Use Pure for thickness and clear width."),
)
class HandleTunnelLoops(SurfaceFilter):
    """Cells are closed lines, with the arrays pair, kind (0 handle, 1 tunnel, 2 boundary), length, size (the length of
    the shorter loop of the pair over the diagonal), diameter, component and bounds; with Measures also thickness,
    clear_width and noise."""

    label = "Handle Tunnel Loops"

    def answer(self, htl, surface):
        V, F, is_measured = surface.V, surface.F, bool(self.values["Measures"])
        L = htl.loops(V, F, BASES[self.values["Basis"]], progress=self.told(0, 0.7 if is_measured else 1))
        loops = [loop for pair in self.chosen(L, surface.diagonal) for loop in pair]
        if self.values["Boundaries"]:
            loops += L.boundaries
        table = L.table()[np.argsort(L.table()["pair"])]
        of_pair = {name: table[name] for name in ("size", "diameter")}
        if is_measured:
            M = htl.measure(V, F, L)
            of_pair.update(thickness=M.thickness.diameters, clear_width=M.clear_width.diameters, noise=M.noise)
        numbers = np.array([loop.number for loop in loops], dtype=np.int64)
        kinds = np.array([KINDS.index(loop.kind) for loop in loops], dtype=np.uint8)
        arrays = {
            "pair": numbers,
            "kind": kinds,
            "length": np.array([loop.length for loop in loops]),
            **{name: column_of_pairs(column, numbers, kinds < 2) for name, column in of_pair.items()},
            "component": np.array([loop.component for loop in loops], dtype=np.int64),
            "bounds": [loop.bounds for loop in loops],
        }
        data = lines_of([loop.points for loop in loops], True, arrays,
                        facts={"genus": [L.genus], "certified": [int(L.certificate.certified)]})
        data.GetCellData().SetActiveScalars("kind")
        return data

    def chosen(self, L, diagonal):
        """The chosen loops of the chosen pairs."""
        least, most = self.length("LongerThan", diagonal), self.length("ShorterThan", diagonal)
        for pair in L:
            shorter = min(pair, key=lambda loop: loop.length)
            if (least is None or shorter.length >= least) and (most is None or shorter.length < most):
                yield [pair, pair[:1], pair[1:], [shorter]][self.values["Show"]]


def column_of_pairs(column, numbers, is_of_pair):
    values = np.full(len(numbers), np.nan)
    values[is_of_pair] = column[numbers[is_of_pair]]
    return values


WAYS = ["smallest-change", "cut", "fill"]


@filter_of_surfaces(
    "Remove Handles",
    choice("Which", ["All handles", "The smallest, down to a genus", "Those with a shorter loop than",
                               "Noise: what is thinner, or narrower, than", "Pairs"],
           "Pairs have the same numbers as in Handle Tunnel Loops.", default=2),
    whole("Genus", 0, "The number of handles to keep.", only=("Which", [1])),
    Property("Limit", "3%", "A length, such as 0.25, or a percentage of the diagonal of the bounding box, such as 3%.",
             only=("Which", [2, 3])),
    text("Pairs", "The numbers of the pairs, such as 0, 3.", only=("Which", [4])),
    choice("By", ["The smaller change", "Cuts along handle loops", "Fills along tunnel loops"],
           "Cut handles, fill their holes, or do for each what changes the shape less."),
    flag("Force", False, "Also remove handles where the result is not a repair, for example where the bounding box would grow."),
)
class RemoveHandles(SurfaceFilter):
    """The surface as triangles, without the handles. Points and cells of the input keep their data; new ones have NaN or
    0. vertex_origin and face_parent give the point and the cell of the input, -1 for new ones."""

    label = "Remove Handles"

    def answer(self, htl, surface):
        V, F = surface.V, surface.F
        L = htl.loops(V, F, progress=self.told(0, 0.6))
        V, F, _, report = htl.remove_handles(
            V, F, loops=L, by=WAYS[self.values["By"]], force=bool(self.values["Force"]),
            **self.chosen(surface.diagonal), progress=self.told(0.6, 1))
        for one in report["refused"]:
            self.say(print_warning, f"pair {one['pair']} is kept: {one['reason']}")
        vertices, faces = report["vertex_origin"], report["face_parent"]
        return self.output(surface, V, F, np.where(vertices < 0, -1, surface.vertex_origin[vertices]),
                           np.where(faces < 0, -1, surface.face_origin[faces]), report)

    def chosen(self, diagonal):
        which = self.values["Which"]
        if which == 0:
            return {"genus": 0}
        if which == 1:
            return {"genus": self.values["Genus"]}
        if which == 4:
            return {"pairs": self.numbers("Pairs")}
        limit = self.length("Limit", diagonal)
        if limit is None:
            raise ValueError("Limit is empty: enter a length, such as 0.25, or a percentage, such as 3%")
        if which == 2:
            return {"shorter_than": limit}
        return {"noise_below": limit}

    @staticmethod
    def output(surface, V, F, vertex_origin, face_parent, report):
        used, corners = np.unique(F, return_inverse=True)
        vertex_origin = vertex_origin[used]
        data, old = vtkPolyData(), surface.data
        data.SetPoints(points_of(V[used].astype(vtk_to_numpy(old.GetPoints().GetData()).dtype)))
        data.SetPolys(cells_of(np.arange(0, 3 * len(F) + 1, 3), corners))
        copy_attributes(old.GetPointData(), data.GetPointData(), vertex_origin)
        copy_attributes(old.GetCellData(), data.GetCellData(), face_parent)
        data.GetPointData().AddArray(as_vtk("vertex_origin", vertex_origin))
        data.GetCellData().AddArray(as_vtk("face_parent", face_parent))
        for name in ("genus_before", "genus_after"):
            data.GetFieldData().AddArray(as_vtk(name, [report[name]]))
        return data


DRAWINGS = ["means", "inside"]
FRONT = "(a front)"


@filter_of_surfaces(
    "Surface Reeb Graph",
    point_array("Function", FRONT,
                "A point array with one component, or the arrival times of a front, whose graph is similar to a skeleton."),
    real("Simplify", 0.03, "Remove leaves up to this fraction of the whole."),
    choice("Drawing", ["Along the means of contours", "In the middle of the solid"],
           "In the middle of the solid takes much longer."),
)
class SurfaceReebGraph(SurfaceFilter):
    """Cells are arcs, with arc, length, girth, on_cycle, lower_node and upper_node; points have radius."""

    label = "Surface Reeb Graph"

    def answer(self, htl, surface):
        graph = htl.reeb(surface.V, surface.F, self.function(surface), self.values["Simplify"],
                         drawing=DRAWINGS[self.values["Drawing"]], progress=self.told())
        arrays = {
            "arc": np.arange(len(graph.arcs)),
            "length": graph.lengths,
            "girth": graph.girths,
            "on_cycle": graph.is_on_cycle.astype(np.uint8),
            "lower_node": graph.arcs[:, 0],
            "upper_node": graph.arcs[:, 1],
        }
        return lines_of(graph.polylines, False, arrays, {"radius": np.concatenate([[], *graph.radii])},
                        {"cycles": [graph.number_of_cycles]})

    def function(self, surface):
        name = self.values["Function"]
        if name in (None, "", FRONT):
            return None
        array = surface.data.GetPointData().GetArray(name)
        if array is None or array.GetNumberOfComponents() != 1:
            raise ValueError(f"the points of the input have no array {name} with one component")
        return vtk_to_numpy(array)[surface.vertex_origin]


@filter_of_surfaces(
    "Curve Skeleton",
    real("ShortestLimb", 1.2,
         "Leave out limbs shorter than this many times the radius at their base. Cycles are always kept."),
)
class CurveSkeleton(SurfaceFilter):
    """Cells are arcs, with arc, length, smallest_radius, mean_radius, tortuosity and on_cycle; points have radius and
    component. The filter Tube, with absolute radius, draws tubes that touch the surface."""

    label = "Curve Skeleton"

    def answer(self, htl, surface):
        skeleton = htl.curve_skeleton(surface.V, surface.F, self.values["ShortestLimb"], progress=self.told())
        if not skeleton.certificate:
            self.say(print_warning, f"the skeleton is not certified: {skeleton.certificate.failure}")
        rows = np.concatenate([np.zeros(0, dtype=np.int64), *skeleton.arcs])
        arrays = {
            "arc": np.arange(len(skeleton.arcs)),
            "length": skeleton.lengths,
            "smallest_radius": skeleton.smallest_radii,
            "mean_radius": skeleton.mean_radii,
            "tortuosity": skeleton.tortuosities,
            "on_cycle": skeleton.is_on_cycle.astype(np.uint8),
        }
        of_points = {"radius": skeleton.radii[rows], "component": skeleton.components[rows]}
        data = lines_of(skeleton.polylines, False, arrays, of_points, {"cycles": [skeleton.number_of_cycles]})
        data.GetPointData().SetActiveScalars("radius")
        return data


@filter_of_surfaces(
    "Throats",
    real("LeastProminence", 0.25, "The least prominence, as a fraction of the length of the throat."),
)
class Throats(SurfaceFilter):
    """Cells are closed lines around narrow places, with throat, length, diameter, prominence, separating, pair (-1 for
    none) and bounds."""

    label = "Throats"

    def answer(self, htl, surface):
        L = htl.loops(surface.V, surface.F, progress=self.told(0, 0.4))
        throats = htl.throats(surface.V, surface.F, L, least_prominence=self.values["LeastProminence"],
                              progress=self.told(0.4, 1))
        arrays = {
            "throat": np.arange(len(throats)),
            "length": np.array([throat.length for throat in throats]),
            "diameter": np.array([throat.diameter for throat in throats]),
            "prominence": np.array([throat.prominence for throat in throats]),
            "separating": np.array([throat.separating for throat in throats], dtype=np.uint8),
            "pair": np.array([-1 if throat.pair is None else throat.pair for throat in throats], dtype=np.int64),
            "bounds": [throat.bounds for throat in throats],
        }
        return lines_of([throat.points for throat in throats], True, arrays)


def load(names=None):
    """Loads this file as a plugin, and adds the filters to the dictionary `names`, such as globals()."""
    from paraview import simple

    simple.LoadPlugin(os.path.abspath(__file__), ns=names)
