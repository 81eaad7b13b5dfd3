"""Curve skeletons."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from . import _core
from ._arguments import real_or_none, threads_of
from ._meshes import arrays
from ._records import Comparable, Record
from ._waiting import computed


@dataclass(frozen=True)
class SkeletonCertificate:
    """What is proved about a skeleton, in exact arithmetic. It is true if everything holds."""

    connected: bool  #: one connected part for each piece of the solid, with a cycle for each handle of its surfaces
    inside: bool  #: every edge lies strictly inside, except for inlets, which lie on caps
    embedded: bool  #: edges meet only in common ends
    basis: bool  #: the cycles are a basis of H1 of the solid
    failure: str  #: what fails, one per line; empty if nothing does
    taken_alone: str  #: components that are no cavities of those they lie in, or meet others, one per line
    edges_outside: List[Tuple[int, int]]  #: edges not known to be inside, as pairs of points

    def __bool__(self) -> bool:
        return self.connected and self.inside and self.embedded and self.basis


class CurveSkeleton(Comparable):
    """Lines in the middle of the solid inside a surface, with the radii of the largest balls around their points.

    Nodes are the points that do not have exactly two edges: joints, ends and inlets (ends at boundary
    curves). Arcs are the paths between nodes. There is one independent cycle for each handle.

    It can be pickled.
    """

    def __init__(self, record: Dict[str, Any]):
        self._record = record
        record = Record("the skeleton", record)
        self.points: np.ndarray = record["points"]  #: (n, 3)
        self.radii: np.ndarray = record["radii"]  #: (n,): of the largest balls inside around the points
        self.components: np.ndarray = record["components"]  #: (n,): of the surface; with cavities, the outer one
        self.is_inlet: np.ndarray = record["is_inlet"].astype(bool)  #: (n,)
        self.edges: np.ndarray = record["edges"]  #: (e, 2): the two points of each edge
        #: by arc, (k,): its points from one node to the other; a closed arc repeats the first at the end
        self.arcs: List[np.ndarray] = np.split(record["arc_points"], record["arc_starts"][1:-1])
        self.lengths: np.ndarray = record["lengths"]  #: (m,): of the arcs
        if len(self.lengths) == 0:
            self.arcs = []
        self.smallest_radii: np.ndarray = record["smallest_radii"]  #: (m,): along each arc
        self.mean_radii: np.ndarray = record["mean_radii"]  #: (m,): mean along the length of each arc
        with np.errstate(divide="ignore"):
            #: (m,): the length over the distance of the ends; infinite for a closed arc
            self.tortuosities: np.ndarray = np.divide(record["lengths"], record["chords"])
        self.is_on_cycle: np.ndarray = record["is_on_cycle"].astype(bool)  #: (m,)
        self.point_of_vertex: np.ndarray = record["point_of_vertex"]  #: by vertex; -1 without a face
        self.arc_of_vertex: np.ndarray = record["arc_of_vertex"]  #: by vertex; -1 if there is none
        self.number_of_cycles: int = record["number_of_cycles"]  #: number of independent cycles
        self.genus: int = record["counts"]["genus"]  #: of the surface, summed over its components
        #: what is proved
        self.certificate = SkeletonCertificate(**record["certificate"])

    def __repr__(self) -> str:
        return (
            f"<CurveSkeleton: {len(self.points)} points, {len(self.arcs)} arcs, "
            f"{self.number_of_cycles} cycles>"
        )

    @property
    def polylines(self) -> List[np.ndarray]:
        """By arc, (k, 3): the coordinates of its points."""
        return [self.points[arc] for arc in self.arcs]

    def to_networkx(self) -> Any:
        """A `networkx.Graph` of all points and edges. Nodes have pos, radius, component and is_inlet; edges
        have arc and length."""
        import networkx

        graph = networkx.Graph()
        for i, point in enumerate(self.points):
            graph.add_node(
                i,
                pos=point,
                radius=float(self.radii[i]),
                component=int(self.components[i]),
                is_inlet=bool(self.is_inlet[i]),
            )
        for number, arc in enumerate(self.arcs):
            steps = np.linalg.norm(np.diff(self.points[arc], axis=0), axis=1)
            for a, b, length in zip(arc[:-1].tolist(), arc[1:].tolist(), steps.tolist()):
                graph.add_edge(a, b, arc=number, length=length)
        return graph

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the skeleton in the format given by the ending of the name.

        .swc: trees with radii, each cycle cut at a point that is written twice; .vtp: lines with radii, for
        ParaView and VMTK (.binary.vtp: binary); .obj, .ply, .polylines.txt: lines; .graphml, .dot: graphs;
        .csv: a row for each arc; .json: everything, for ``htloops check``. Numbers keep all digits.
        """
        computed("save", None, _core.save_skeleton, os.fspath(path), Record("the skeleton", self._record))


def curve_skeleton(
    V: Any,
    F: Any = None,
    shortest_limb: float = 1.2,
    *,
    threads: Optional[int] = 0,
    progress: Any = None,
) -> CurveSkeleton:
    """Computes a curve skeleton of a mesh, with a certificate.

    Components that lie in another one, oriented the other way, are its cavities: the skeleton lies between them.
    If the mesh crosses itself, nothing is proved, and ``certificate`` gives the reason.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    shortest_limb : leave out limbs that are shorter than this many times the radius at their base; cycles
        are always kept
    threads, progress : as for `loops`
    """
    points, triangles = arrays(V, F)
    limb = real_or_none("shortest_limb", shortest_limb)
    if limb is None or limb == float("inf"):
        raise ValueError(f"shortest_limb cannot be {shortest_limb}: it must be finite, and 0 or larger")
    return CurveSkeleton(
        computed(
            "curve_skeleton",
            progress,
            _core.curve_skeleton,
            points,
            triangles,
            limb,
            threads_of(threads),
        )
    )
