"""Throats."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Optional, Tuple

import numpy as np

from . import _core
from ._arguments import real_or_none, threads_of, vertices
from ._loops import Loops, loops, record_of
from ._meshes import arrays
from ._records import Comparable
from ._waiting import computed


@dataclass(frozen=True, eq=False, repr=False)
class Throat(Comparable):
    """A closed geodesic that is shorter than the loops next to it. Its k points lie on edges or at vertices,
    as for a `Loop`."""

    points: np.ndarray  #: (k, 3), float64, in the unit of the coordinates
    edges: np.ndarray  #: (k, 2), int64: the end vertices of the edge of each point
    ratios: np.ndarray  #: (k,), float64 in [0, 1]: the position of each point along its edge
    length: float  #: of the closed polyline
    prominence: float  #: about how much longer it must become to slide away or split; inf if it cannot
    separating: bool  #: whether it separates its component
    bounds: str  #: "inside", "outside", "both", "neither" or "undecided"
    pair: Optional[int]  #: the pair with a loop in its homology class, if there is one
    kind: Optional[str]  #: which loop of that pair: "handle" or "tunnel"
    through: Tuple[int, ...]  #: those vertices of ``through`` from which a short loop tightens to it

    @property
    def diameter(self) -> float:
        """The diameter of a circle of the same length."""
        return self.length / np.pi

    def __hash__(self) -> int:
        return hash((self.length, self.bounds, self.pair))

    def __len__(self) -> int:
        return len(self.ratios)

    def __repr__(self) -> str:
        return f"<Throat: diameter {self.diameter:g}, prominence {self.prominence:g}>"

    def closed(self) -> np.ndarray:
        """(k + 1, 3): the points, with the first one repeated at the end, for plotting."""
        return np.concatenate([self.points, self.points[:1]])


def _is_pure(L: Loops) -> bool:
    return all(h.bounds_alone in ("inside", "both") for h in L.handles) and all(
        t.bounds_alone in ("outside", "both") for t in L.tunnels
    )


def throats(
    V: Any,
    F: Any = None,
    L: Optional[Loops] = None,
    *,
    through: Any = (),
    least_prominence: float = 0.25,
    threads: Optional[int] = 0,
    progress: Any = None,
) -> List[Throat]:
    """Computes the throats of a mesh, the most prominent first, including those outside any basis.

    ``throats(mesh, L)`` takes one mesh object.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    L : the loops of the mesh, from `loops()`; computed by default
    through : vertices; for each, include the throat to which a short loop through it tightens, if there is one
    least_prominence : the least prominence, as a fraction of the length of the throat
    threads, progress : as for `loops`
    """
    if isinstance(F, Loops):
        F, L = None, F
    points, triangles = arrays(V, F)
    if L is None:
        L = loops(points, triangles, threads=threads)
    record = computed(
        "throats",
        progress,
        _core.throats,
        points,
        triangles,
        record_of(L),
        vertices("through", through),
        real_or_none("least_prominence", least_prominence) or 0.0,
        threads_of(threads),
    )
    is_pure = _is_pure(L)
    result = []
    for i, pair in enumerate(record["pairs"]):
        places = slice(record["starts"][i], record["starts"][i + 1])
        inside, outside = record["inside"][i], record["outside"][i]
        side = (("neither", "outside"), ("inside", "both"))[inside][outside]
        result.append(
            Throat(
                record["points"][places],
                record["edges"][places],
                record["ratios"][places],
                float(record["lengths"][i]),
                float(record["prominences"][i]),
                record["separating"][i],
                side if is_pure else "undecided",
                pair,
                None if pair is None else record["kinds"][i],
                tuple(record["through"][i]),
            )
        )
    return result
