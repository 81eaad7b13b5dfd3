"""Reeb graphs."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Literal, Optional, Sequence, Union, get_args

import numpy as np

from . import _core
from ._arguments import numbers, real_or_none, threads_of, vertices, word
from ._meshes import arrays
from ._records import Comparable, Record
from ._waiting import computed

Measure = Literal["limbs", "persistence", "length", "area", "vertices"]
Drawing = Literal["means", "inside"]


class ReebGraph(Comparable):
    """The Reeb graph of a function on a mesh: each component of a contour becomes a point.

    Nodes are critical points, and arcs are the parts between them. For a closed surface, or with
    ``capped=True``, the graph has one independent cycle for each handle. For a connected surface of genus g
    with b boundary curves, it has g to 2 g + b - 1.
    """

    def __init__(self, record: Dict[str, Any]):
        self._record = record
        record = Record("the Reeb graph", record)
        nodes, arcs = record["nodes"], record["arcs"]
        self.positions: np.ndarray = nodes["positions"]  #: (n, 3): of the nodes, for drawing
        self.node_values: np.ndarray = nodes["values"]  #: (n,): of the function
        self.node_vertices: np.ndarray = nodes["vertices"]  #: (n,): of the mesh
        self.node_types: List[str] = nodes["types"]  #: "minimum", "saddle", "maximum" or "regular"
        self.arcs: np.ndarray = arcs["ends"]  #: (m, 2): the nodes at the lower and the upper end
        self.lengths: np.ndarray = arcs["lengths"]  #: (m,): of the polylines
        self.girths: np.ndarray = arcs["girths"]  #: (m,): the length of the contour just below the middle vertex
        self.numbers_of_vertices: np.ndarray = arcs["numbers_of_vertices"]  #: (m,): of the mesh
        self.is_on_cycle: np.ndarray = arcs["is_on_cycle"].astype(bool)  #: (m,)
        self.arc_of_vertex: np.ndarray = record["arc_of_vertex"]  #: by vertex; -1 without a face
        self.values: np.ndarray = record["values"]  #: by vertex, of the function
        self.number_of_cycles: int = record["number_of_cycles"]  #: number of independent cycles
        cuts = arcs["starts"][1:-1]
        #: by arc, (k, 3): from the lower end to the upper one
        self.polylines: List[np.ndarray] = np.split(arcs["points"], cuts)
        #: by arc, (k,): the radius of the surface around each point of the polyline
        self.radii: List[np.ndarray] = np.split(arcs["radii"], cuts)
        if len(self.arcs) == 0:
            self.polylines, self.radii = [], []

    def __repr__(self) -> str:
        return (
            f"<ReebGraph: {len(self.positions)} nodes, {len(self.arcs)} arcs, "
            f"{self.number_of_cycles} cycles>"
        )

    def to_networkx(self) -> Any:
        """A `networkx.MultiGraph`. Nodes have pos, value, vertex and type; edges have the number of the arc
        as key, and length, girth, polyline, radii and is_on_cycle."""
        import networkx

        graph = networkx.MultiGraph()
        for i, position in enumerate(self.positions):
            graph.add_node(
                i,
                pos=position,
                value=float(self.node_values[i]),
                vertex=int(self.node_vertices[i]),
                type=self.node_types[i],
            )
        for i, (low, high) in enumerate(self.arcs.tolist()):
            graph.add_edge(
                low,
                high,
                key=i,
                length=float(self.lengths[i]),
                girth=float(self.girths[i]),
                polyline=self.polylines[i],
                radii=self.radii[i],
                is_on_cycle=bool(self.is_on_cycle[i]),
            )
        return graph

    def to_swc(self, path: Union[str, "os.PathLike[str]"]) -> int:
        """Writes the graph as SWC, a format for neurons; returns the number of points.

        SWC stores trees only. Each cycle is cut where it returns to a node: the last point of that arc is
        a copy of the node, and a comment at the top names the two, `# cycle: COPY NODE`. A reader can use
        it to join them.
        """
        rows: List[str] = []
        cycles: List[str] = []
        at: Dict[int, int] = {}  # of nodes, in the file
        around: Dict[int, List[int]] = {}
        for i, ends in enumerate(self.arcs.tolist()):
            for end in ends:
                around.setdefault(end, []).append(i)
        is_written = np.zeros(len(self.arcs), dtype=bool)

        def add(point: np.ndarray, radius: float, parent: int) -> int:
            x, y, z = (repr(float(c)) for c in point)
            rows.append(f"{len(rows) + 1} 0 {x} {y} {z} {float(radius)!r} {parent}")
            return len(rows)

        def add_arc(arc: int, start: int, parent: int) -> int:
            """All points except the first; returns the node at the other end, or -1 if it was already written."""
            is_up = int(self.arcs[arc, 0]) == start
            line, radii = self.polylines[arc], self.radii[arc]
            if not is_up:
                line, radii = line[::-1], radii[::-1]
            for point, radius in zip(line[1:], radii[1:]):
                parent = add(point, radius, parent)
            end = int(self.arcs[arc, 1 if is_up else 0])
            if end in at:
                cycles.append(f"# cycle: {parent} {at[end]}")
                return -1
            at[end] = parent
            return end

        for root in range(len(self.positions)):
            if root in at or root not in around:
                continue
            first = around[root][0]
            radius = self.radii[first][0 if int(self.arcs[first, 0]) == root else -1]
            at[root] = add(self.positions[root], radius, -1)
            reached = [root]
            while reached:
                node = reached.pop()
                for arc in around[node]:
                    if not is_written[arc]:
                        is_written[arc] = True
                        end = add_arc(arc, node, at[node])
                        if end >= 0:
                            reached.append(end)
        with open(path, "w", encoding="ascii") as file:
            file.write("\n".join(["# handle_tunnel_loops: id type x y z radius parent", *cycles, *rows]))
            file.write("\n")
        return len(rows)


def reeb(
    V: Any,
    F: Any = None,
    f: Any = None,
    simplify: Optional[float] = None,
    measure: Optional[Measure] = None,
    *,
    shortest_arc: float = 0.0,
    capped: bool = False,
    drawing: Drawing = "means",
    sources: Sequence[int] = (),
    threads: Optional[int] = 0,
    progress: Any = None,
) -> ReebGraph:
    """Computes the Reeb graph of a function on a mesh.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    f : (n,): the function, a number for each vertex; integers are compared exactly. By default the arrival
        times of a front that starts at one vertex; the graph is then similar to a skeleton
    simplify : remove leaves up to this fraction of the whole, by ``measure``; default 0.03
    measure : "limbs" (the default without f), "persistence" (the default with f), "length", "area" or
        "vertices"
    shortest_arc : contract arcs between saddles that are shorter than this many times their radius, but
        never a cycle. With 2, an arc is at least as long as thick, and arcs are distinct parts of the
        surface with short borders. Arcs may then be parallel, or lead from a node to itself
    capped : close each boundary curve by a cap first. By default contours end at the boundary
    drawing : "means": along the means of contours; "inside": in the middle of the solid, which takes much
        longer
    sources : the vertices at which the front starts; chosen by default
    threads, progress : as for `loops`
    """
    points, triangles = arrays(V, F)
    starts = vertices("sources", sources)
    shortest = real_or_none("shortest_arc", shortest_arc)
    if shortest is None or not 0 <= shortest < float("inf"):
        raise ValueError(f"shortest_arc cannot be {shortest_arc}: it must be finite, and 0 or larger")
    if f is not None:
        if starts:
            raise ValueError("sources and f cannot be given together: f replaces the front that starts at sources")
        f = numbers("f", f)
        is_integer = f.dtype.kind in "iu"
        if f.dtype.kind == "u" and f.size > 0 and int(f.max()) > np.iinfo(np.int64).max:
            raise ValueError("f has integers of 2**63 or more")
        f = np.ascontiguousarray(f, dtype=np.int64 if is_integer else float)
        if f.shape != (len(points),):
            raise ValueError(f"f must be an array of {len(points)} numbers, one for each vertex")
    return ReebGraph(
        computed(
            "reeb",
            progress,
            _core.reeb,
            points,
            triangles,
            f,
            real_or_none("simplify", simplify),
            None if measure is None else word("measure", measure, get_args(Measure)),
            shortest,
            bool(capped),
            word("drawing", drawing, get_args(Drawing)) == "inside",
            starts,
            threads_of(threads),
        )
    )
