"""Handle and tunnel loops."""

from __future__ import annotations

import operator
import weakref
from dataclasses import dataclass, fields
from typing import Any, Dict, List, Literal, Optional, Sequence, Tuple, get_args

import numpy as np

from . import _core
from ._arguments import real_or_none, threads_of, vertex_or_none, word
from ._meshes import arrays
from ._pairs import PairTable, html_table, table_of
from ._records import Comparable, Record
from ._waiting import computed


Basis = Literal["pure", "shortest"]


@dataclass(frozen=True)
class Certificate:
    """What is proved about loops. It is true if everything required holds."""

    certified: bool
    closed_on_surface: bool  #: each loop is a closed curve on the surface
    basis: bool  #: they and the boundary curves, except one of each component, are a basis of H1(S; Z)
    pairing: bool  #: the loops of each pair cross once, counted with sign
    types: bool  #: no handle loop and tunnel loop are swapped
    handles_bound_inside: Optional[int]  #: their number, if it was computed
    tunnels_bound_outside: Optional[int]
    failure: str  #: what fails, one per line; empty if nothing does

    def __bool__(self) -> bool:
        return self.certified


def certificate_of(record: Dict[str, Any]) -> Certificate:
    return Certificate(**{part.name: record[part.name] for part in fields(Certificate)})


@dataclass(frozen=True, eq=False, repr=False)
class Loop(Comparable):
    """A closed polyline on a mesh. Its k points lie on edges or at vertices; consecutive points, and the
    last and the first, lie on a common face."""

    kind: str  #: "handle", "tunnel", or "boundary"
    number: int  #: of its pair, or of the boundary curve
    points: np.ndarray  #: (k, 3), float64, in the unit of the coordinates
    edges: np.ndarray  #: (k, 2), int64: the end vertices of the edge of each point
    ratios: np.ndarray  #: (k,), float64 in [0, 1]: the position of each point along its edge
    length: float  #: of the closed polyline
    component: int  #: of the surface
    bounds: str = "undecided"  #: "inside", "outside", "both", "neither" or "undecided"
    bounds_alone: str = "undecided"  #: the same, without the other components

    def __hash__(self) -> int:
        return hash((self.kind, self.number, self.length))

    def __len__(self) -> int:
        return len(self.ratios)

    def __repr__(self) -> str:
        return f"<Loop: {self.kind} {self.number}, length {self.length:g}, {len(self)} places>"

    def closed(self) -> np.ndarray:
        """(k + 1, 3): the points, with the first one repeated at the end, for plotting."""
        return np.concatenate([self.points, self.points[:1]])


def _loops_of(record: Dict[str, Any], kinds: List[str], numbers: List[int]) -> List[Loop]:
    loops = []
    starts = record["starts"]
    bounds = record.get("bounds") or ["undecided"] * len(kinds)
    alone = record.get("bounds_alone") or bounds
    for i, (kind, number) in enumerate(zip(kinds, numbers)):
        places = slice(starts[i], starts[i + 1])
        loops.append(
            Loop(
                kind,
                number,
                record["points"][places],
                record["edges"][places],
                record["ratios"][places],
                float(record["lengths"][i]),
                int(record["components"][i]),
                bounds[i],
                alone[i],
            )
        )
    return loops


class Loops(Comparable, Sequence[Tuple[Loop, Loop]]):
    """The loops of a mesh, a sequence of pairs: ``L[i]`` is ``(handles[i], tunnels[i])``, a slice is a list.

    It can be pickled. Two are equal if everything in them is equal, except the times.
    """

    # Weak references to the caller's arrays on which the loops were found.
    _mesh: Tuple[Any, Any] = (None, None)

    def __init__(self, record: Dict[str, Any]):
        self._record = record
        record = self._whole_record()
        count = len(record["lengths"]) // 2
        loops = _loops_of(
            record, ["handle", "tunnel"] * count, [i // 2 for i in range(2 * count)]
        )
        self.genus: int = count  #: of the surface, summed over its components
        self.basis: str = record["basis"]  #: "pure" or "shortest"
        self.handles: List[Loop] = loops[0::2]
        self.tunnels: List[Loop] = loops[1::2]
        curves = record["boundaries"]
        number = len(curves["lengths"])
        #: the boundary curves of the surface
        self.boundaries: List[Loop] = _loops_of(curves, ["boundary"] * number, list(range(number)))
        numbers = record["waists"]["numbers"]
        waists = dict(record["waists"], components=[curves["components"][i] for i in numbers])
        #: with ``waists=True``: for each boundary curve a short loop homologous to it, with the number
        #: of the curve; the only curve of a component has none
        self.waists: List[Loop] = _loops_of(waists, ["boundary"] * len(numbers), numbers)
        #: (n,): the layer, from 1, in which a front of the first pass reached each vertex; 0 without a face.
        #: With ``layers=True``, else None, like the next.
        self.layers: Optional[np.ndarray] = record.get("layers")
        #: (n,): the arrival time, in steps of the field; -1 without a face
        self.layer_times: Optional[np.ndarray] = record.get("layer_times")
        self.certificate = certificate_of(record["certificate"])
        #: whether the time budget ended the search for shorter loops
        self.ended_by_time: bool = record["ended_by_time"]
        self.number_of_components: int = record["number_of_components"]
        self.seconds: Dict[str, float] = record["seconds"]  #: by stage of the computation

    def _whole_record(self) -> Record:
        return Record("the loops", self._record)

    def __len__(self) -> int:
        return self.genus

    def __getitem__(self, i: Any) -> Any:
        if isinstance(i, slice):
            return list(zip(self.handles[i], self.tunnels[i]))
        if not -self.genus <= operator.index(i) < self.genus:
            raise IndexError(f"there is no pair {i}: the genus is {self.genus}")
        return self.handles[i], self.tunnels[i]

    def __bool__(self) -> bool:
        return True  # also for genus 0

    def _content(self) -> Dict[str, Any]:
        record = {key: part for key, part in self._record.items() if key != "seconds"}
        return {**self.__getstate__(), "_record": record, "seconds": None}

    def __repr__(self) -> str:
        return f"<Loops: genus {self.genus}, basis {self.basis!r}, {len(self.boundaries)} boundary curves>"

    @property
    def linking(self) -> Any:
        """The linking numbers, (2g, 2g): entry (i, j) is the linking number of loop i with loop j pushed
        outwards off the surface. Loop 2k is handle loop k, loop 2k + 1 is tunnel loop k. Two loops
        that are both undecided have none. A `scipy.sparse.coo_matrix`, or rows, columns and values if
        SciPy is not installed."""
        rows, columns, values = self._whole_record()["linking"]
        try:
            from scipy.sparse import coo_matrix
        except ImportError:
            return rows, columns, values
        return coo_matrix((values, (rows, columns)), shape=(2 * self.genus, 2 * self.genus))

    def table(self) -> PairTable:
        """A structured array with a row for each pair, the smallest first: ``pandas.DataFrame(L.table())``.

        The columns:

        pair, component : the number of the pair, and of its component
        handle_length, tunnel_length : in the unit of the coordinates
        size : the length of the shorter loop over the diagonal of the bounding box
        centre_x to centre_z : of a bore, on its axis, in the middle; otherwise of the box of the shorter loop
        xmin to zmax : the bounding box of the shorter loop
        handle_bounds, tunnel_bounds : as `Loop.bounds`
        diameter : of the round bore that the tunnel loop goes around, or else of the circle that fits that
            loop best
        diameter_of : "bore" or "hole"
        out_of_roundness : of a hole that is no bore, the largest distance of its tunnel loop to the center of
            that circle less the smallest one, over the diameter
        wall_diameter : of a circle as long as the handle loop, which goes around the wall beside the hole
        bore_axis_x to bore_deviation : of the bore; NaN if there is none. Its depth is its length along the
            axis, and the deviation the largest distance of an edge of its wall to the cylinder, at most
        drilling : parts of one bore that others cut have the same number; -1 if there is no bore

        For the table and its rows, "centre", "bore_axis" and "bore_centre" give three columns as one array,
        and "box" gives six, of shape (2, 3).
        """
        record = self._whole_record()
        return table_of(self, record["diagonal"], record["holes"])

    def _repr_html_(self) -> str:
        """The table, for notebooks, below a picture as long as the arrays of the mesh exist."""
        from ._pictures import html_picture  # which imports this module

        V, F = (None if array is None else array() for array in self._mesh)
        shown = "" if V is None or F is None else html_picture(V, F, self)
        return shown + html_table(repr(self), self.table())

    def __getstate__(self) -> Dict[str, Any]:
        return {name: part for name, part in vars(self).items() if name != "_mesh"}

    def columns(self) -> Dict[str, np.ndarray]:
        """The table as a dictionary of columns."""
        table = self.table()
        return {name: table[name] for name in table.dtype.names or ()}


def loops(
    V: Any,
    F: Any = None,
    basis: Basis = "pure",
    threads: Optional[int] = 0,
    seed: Optional[int] = None,
    progress: Any = None,
    *,
    waists: bool = False,
    layers: bool = False,
    time_budget: Optional[float] = None,
) -> Loops:
    """Computes the handle and tunnel loops of a mesh.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    basis : "pure": handle loops that bound inside and tunnel loops that bound outside; "shortest": a
        shortest basis, on any side
    threads : the largest number of threads; 0 or None: one for each core
    seed : the vertex at which the computation begins; chosen by default
    waists : whether to also compute, for each boundary curve, a short loop homologous to it
    layers : whether to keep the layers and arrival times of the first pass
    time_budget : seconds after which the search for shorter loops in other homology classes ends; all other
        steps are completed
    progress : True for a bar, or a callable that takes a number from 0 to 1

    The result is certified. It is the same for any number of threads, unless the time budget ended the
    search. The time is about linear in m; memory is about 150 bytes per face besides the arrays.
    """
    points, triangles = arrays(V, F)
    L = Loops(
        computed(
            "loops",
            progress,
            _core.loops,
            points,
            triangles,
            word("basis", basis, get_args(Basis)),
            threads_of(threads),
            vertex_or_none("seed", seed),
            bool(waists),
            bool(layers),
            real_or_none("time_budget", time_budget),
        )
    )
    L._mesh = weakref.ref(points), weakref.ref(triangles)
    return L


def record_of(L: Any, name: str = "L") -> Dict[str, Any]:
    """The record of loops, as the compiled part takes it."""
    if not isinstance(L, Loops):
        raise TypeError(f"{name} must be a result of loops(), not of type {type(L).__name__}")
    return L._whole_record()


def certify(V: Any, F: Any = None, L: Optional[Loops] = None) -> Certificate:
    """Certifies loops on a mesh, from the loops and the mesh alone. Earlier certificates are not used.

    The boundary curves must be those of the mesh, and each waist homologous to its curve.

    ``certify(mesh, L)`` takes one mesh object.
    """
    if isinstance(F, Loops):
        F, L = None, F
    return certificate_of(computed("certify", None, _core.certify, *arrays(V, F), record_of(L)))
