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
    """What has been proved of loops. It is true if all holds that is required."""

    certified: bool
    closed_on_surface: bool  #: each loop is a closed curve on the surface
    basis: bool  #: they are a basis of H1(S; Z), with the boundary curves but one of each component
    pairing: bool  #: the loops of each pair cross once, counted with sign
    types: bool  #: no handle loop and tunnel loop have each other's name
    handles_bound_inside: Optional[int]  #: how many, if that was computed
    tunnels_bound_outside: Optional[int]
    failure: str  #: what fails, a line each; empty if nothing does

    def __bool__(self) -> bool:
        return self.certified


def certificate_of(record: Dict[str, Any]) -> Certificate:
    return Certificate(**{part.name: record[part.name] for part in fields(Certificate)})


@dataclass(frozen=True, eq=False, repr=False)
class Loop(Comparable):
    """A closed polyline on a mesh. Its k places are on edges or at vertices; two that follow each other,
    and the last and the first, lie on a common face."""

    kind: str  #: "handle", "tunnel", or "boundary"
    number: int  #: of its pair, or of the boundary curve
    points: np.ndarray  #: (k, 3), float64: the places, in the unit of the coordinates
    edges: np.ndarray  #: (k, 2), int64: the vertices that the edge of each place joins
    ratios: np.ndarray  #: (k,), float64 in [0, 1]: how far along its edge each place is
    length: float  #: of the closed polyline
    component: int  #: of the surface
    bounds: str = "undecided"  #: "inside", "outside", "both", "neither" or "undecided"
    bounds_alone: str = "undecided"  #: the same if the other components were not there

    def __hash__(self) -> int:
        return hash((self.kind, self.number, self.length))

    def __len__(self) -> int:
        return len(self.ratios)

    def __repr__(self) -> str:
        return f"<Loop: {self.kind} {self.number}, length {self.length:g}, {len(self)} places>"

    def closed(self) -> np.ndarray:
        """(k + 1, 3): the points, with the first one again at the end, to be plotted."""
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
    """The loops of a mesh, a sequence of pairs: ``L[i]`` is ``handles[i]`` and ``tunnels[i]``, a slice is a list.

    It is made of arrays and can be pickled. Two are equal if all in them is, but for the times that they took.
    """

    # Weak references to the arrays that it was found on, which are the caller's.
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
        #: for each boundary curve the shortest loop that goes around the same, if asked for; it has
        #: the number of its curve, and the only curve of a component has none
        self.waists: List[Loop] = _loops_of(waists, ["boundary"] * len(numbers), numbers)
        #: (n,): the layer of the front that came to each vertex in the first pass, from 1; 0 where there is
        #: no face. None unless asked for, like the next.
        self.layers: Optional[np.ndarray] = record.get("layers")
        #: (n,): when it came, in steps of the field; -1 where there is no face
        self.layer_times: Optional[np.ndarray] = record.get("layer_times")
        self.certificate = certificate_of(record["certificate"])
        #: whether the time budget has ended the search for shorter loops
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
        return True  # of genus 0, too

    def _content(self) -> Dict[str, Any]:
        record = {key: part for key, part in self._record.items() if key != "seconds"}
        return {**self.__getstate__(), "_record": record, "seconds": None}

    def __repr__(self) -> str:
        return f"<Loops: genus {self.genus}, basis {self.basis!r}, {len(self.boundaries)} boundary curves>"

    @property
    def linking(self) -> Any:
        """The linking numbers, (2g, 2g): entry (i, j) is how often loop i winds around loop j when that
        is pushed off the surface, outwards; loop 2k is handle k, and 2k + 1 is tunnel k. A
        `scipy.sparse.coo_matrix` where SciPy is there, or else rows, columns and values."""
        rows, columns, values = self._whole_record()["linking"]
        try:
            from scipy.sparse import coo_matrix
        except ImportError:
            return rows, columns, values
        return coo_matrix((values, (rows, columns)), shape=(2 * self.genus, 2 * self.genus))

    def table(self) -> PairTable:
        """A structured array, a row for each pair, the smallest first: ``pandas.DataFrame(L.table())``.

        pair, handle_length, tunnel_length (in the unit of the coordinates), size (the shorter one over
        the diagonal of the mesh's box), centre_x to centre_z and xmin to zmax, the box, of the shorter one,
        component, handle_bounds, tunnel_bounds, diameter (of the round bore that the tunnel goes around, or
        else of a circle as long as the shorter loop), diameter_of ("bore", "handle" or "tunnel"), and
        bore_axis_x to bore_centre_z, which are NaN for what is none.

        Of the table and of its rows, "centre", "bore_axis" and "bore_centre" are three of the columns in one
        array, and "box" is six, of shape (2, 3).
        """
        record = self._whole_record()
        return table_of(self, record["diagonal"], record["bores"])

    def _repr_html_(self) -> str:
        """The table, for notebooks, below a picture while the arrays of the mesh are there."""
        from ._pictures import html_picture  # which is about loops

        V, F = (None if array is None else array() for array in self._mesh)
        shown = "" if V is None or F is None else html_picture(V, F, self)
        return shown + html_table(repr(self), self.table())

    def __getstate__(self) -> Dict[str, Any]:
        return {name: part for name, part in vars(self).items() if name != "_mesh"}

    def columns(self) -> Dict[str, np.ndarray]:
        """The same as a dictionary of the columns."""
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
    """The handle and tunnel loops of a mesh.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    basis : "pure": handle loops that bound in the solid and tunnel loops that bound outside of it;
        "shortest": short loops, whatever side they bound on
    threads : how many this call takes at most; 0 or None for as many as there are processors
    seed : the vertex that the computation begins at; chosen if not given
    waists : whether to look for the shortest loops that go around what boundary curves go around
    layers : whether to keep what each front of the first pass covered, and when
    time_budget : seconds after which no more shorter loops are looked for in other classes; what else
        there is to do is done
    progress : True for a bar, or a callable that is told a number from 0 to 1

    The answer is certified, and the same for any number of threads unless its time budget has ended it. The time is about linear in m;
    memory is about 150 bytes a face besides the arrays.
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
    """What the compiled part takes for loops."""
    if not isinstance(L, Loops):
        raise TypeError(f"{name} has to be what loops() returns, not of type {type(L).__name__}")
    return L._whole_record()


def certify(V: Any, F: Any = None, L: Optional[Loops] = None) -> Certificate:
    """What has been proved of loops on a mesh, from the two alone: whatever they say of themselves.

    ``certify(mesh, L)`` takes one mesh object.
    """
    if isinstance(F, Loops):
        F, L = None, F
    return certificate_of(computed("certify", None, _core.certify, *arrays(V, F), record_of(L)))
