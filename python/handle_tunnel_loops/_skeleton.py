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
    """What has been proved of a skeleton, in exact arithmetic. It is true if all of it holds."""

    connected: bool  #: each component of the mesh has one connected part, with as many cycles as handles
    inside: bool  #: every edge lies strictly inside, but for the ends of inlets, which lie on caps
    embedded: bool  #: no two edges meet but in a common end
    basis: bool  #: the cycles are a basis of H1 of the solid
    failure: str  #: what fails, a line each; empty if nothing does
    edges_outside: List[Tuple[int, int]]  #: edges that are not known to be inside, by their points

    def __bool__(self) -> bool:
        return self.connected and self.inside and self.embedded and self.basis


class CurveSkeleton(Comparable):
    """Lines in the middle of the solid inside a surface, with the radii of the largest balls there.

    Points of other than two edges are nodes: joints, ends and inlets, which are the ends at boundary
    curves. Paths between nodes are arcs. There are as many independent cycles as the surface has handles.

    It is made of arrays and can be pickled.
    """

    def __init__(self, record: Dict[str, Any]):
        self._record = record
        record = Record("the skeleton", record)
        self.points: np.ndarray = record["points"]  #: (n, 3)
        self.radii: np.ndarray = record["radii"]  #: (n,): of the largest balls inside
        self.components: np.ndarray = record["components"]  #: (n,): of the surface
        self.is_inlet: np.ndarray = record["is_inlet"].astype(bool)  #: (n,)
        self.edges: np.ndarray = record["edges"]  #: (e, 2): the points that each joins
        #: by arc, (k,): its points from one node to the other; of a cycle the first again at the end
        self.arcs: List[np.ndarray] = np.split(record["arc_points"], record["arc_starts"][1:-1])
        self.lengths: np.ndarray = record["lengths"]  #: (m,): of the arcs
        if len(self.lengths) == 0:
            self.arcs = []
        self.smallest_radii: np.ndarray = record["smallest_radii"]  #: (m,): along each arc
        self.mean_radii: np.ndarray = record["mean_radii"]  #: (m,): along the length of each arc
        with np.errstate(divide="ignore"):
            #: (m,): the length over the distance of the ends; infinite for a cycle
            self.tortuosities: np.ndarray = np.divide(record["lengths"], record["chords"])
        self.is_on_cycle: np.ndarray = record["is_on_cycle"].astype(bool)  #: (m,)
        self.point_of_vertex: np.ndarray = record["point_of_vertex"]  #: by vertex; -1 without a face
        self.arc_of_vertex: np.ndarray = record["arc_of_vertex"]  #: by vertex; -1 if on none
        self.number_of_cycles: int = record["number_of_cycles"]  #: independent ones
        self.genus: int = record["counts"]["genus"]  #: of the surface, summed over its components
        #: what has been proved
        self.certificate = SkeletonCertificate(**record["certificate"])

    def __repr__(self) -> str:
        return (
            f"<CurveSkeleton: {len(self.points)} points, {len(self.arcs)} arcs, "
            f"{self.number_of_cycles} cycles>"
        )

    @property
    def polylines(self) -> List[np.ndarray]:
        """By arc, (k, 3): where its points are."""
        return [self.points[arc] for arc in self.arcs]

    def to_networkx(self) -> Any:
        """A `networkx.Graph` of all points and edges: nodes with pos, radius, component and is_inlet, edges
        with arc and length."""
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
        """Writes it in the format that the end of the name tells.

        .swc: trees with radii, each cycle cut at a point that is there twice; .vtp: lines with radii, for
        ParaView and VMTK, as bytes if the name ends in .binary.vtp; .obj, .ply, .polylines.txt: lines;
        .graphml, .dot: graphs; .csv: a row for each arc; .json: all, for ``htloops check``. Numbers read
        back as exactly themselves.
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
    """A curve skeleton of a mesh, and what is proved of it.

    If the mesh crosses itself, the skeleton comes with the reason why nothing is proved: see
    ``certificate``.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    shortest_limb : limbs that are shorter than so many times the radius of their base are left out;
        cycles never are
    threads, progress : as for `loops`
    """
    points, triangles = arrays(V, F)
    limb = real_or_none("shortest_limb", shortest_limb)
    if limb is None or limb == float("inf"):
        raise ValueError(f"shortest_limb cannot be {shortest_limb}")
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
