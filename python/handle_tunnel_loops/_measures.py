"""How thick handles are, and how wide their holes."""

from __future__ import annotations

from typing import Any, Dict, List, Optional

import numpy as np

from . import _core
from ._arguments import threads_of
from ._loops import Loops, record_of
from ._meshes import arrays
from ._records import Comparable
from ._waiting import computed


class Balls(Comparable):
    """The largest balls that can move along closed curves, one for each pair; NaN if it is not known."""

    def __init__(self, record: Dict[str, Any]):
        known = np.array([len(curve) > 0 for curve in record["curves"]], dtype=bool)
        self.diameters: np.ndarray = np.where(known, record["diameters"], np.nan)  #: (g,), in the unit of the mesh
        self.errors: np.ndarray = np.where(known, record["errors"], np.nan)  #: (g,): bounds of the errors of the diameters
        self.throats: np.ndarray = np.where(known[:, None], record["throats"], np.nan)  #: (g, 3): where each ball has the least room
        self.curves: List[np.ndarray] = record["curves"]  #: (k, 3) each: paths of the centers


class Measures(Comparable):
    """Thickness of handles and clear width of their holes, in the order of the pairs."""

    def __init__(self, record: Dict[str, Any]):
        self.thickness = Balls(record["thickness"])  #: of balls around a handle, in the material
        self.clear_width = Balls(record["clear_width"])  #: of balls through its hole
        #: (g, 2): bounds of the smaller of the two measures. One that is missing is at most the length of its loop over pi
        self.noise_ranges: np.ndarray = np.column_stack([record["least_noise"], record["most_noise"]])
        self.why: List[str] = record["why"]  #: why a measure is missing; empty if none is

    def __len__(self) -> int:
        return len(self.why)

    @property
    def noise(self) -> np.ndarray:
        """(g,): the smaller of the two measures: the middle of its range."""
        return self.noise_ranges.mean(axis=1)

    def columns(self) -> Dict[str, np.ndarray]:
        """A dictionary of columns, one for each number: ``pandas.DataFrame(M.columns())``."""
        columns: Dict[str, np.ndarray] = {"pair": np.arange(len(self))}
        for name, place, balls in (
            ("thickness", "thickness", self.thickness),
            ("clear_width", "throat", self.clear_width),
        ):
            columns[name] = balls.diameters
            columns[f"{name}_error"] = balls.errors
            columns.update({f"{place}_{axis}": balls.throats[:, k] for k, axis in enumerate("xyz")})
        columns["why"] = np.array(self.why, dtype=object)
        return columns


def measure(
    V: Any,
    F: Any = None,
    L: Optional[Loops] = None,
    threads: Optional[int] = 0,
) -> Measures:
    """Measures how thick each handle is, and how wide its hole, given the loops of a mesh.

    ``measure(mesh, L)`` takes one mesh object. The result includes a bound for the error of each measure:
    1% of it, or more where less is known.
    """
    if isinstance(F, Loops):
        F, L = None, F
    return measures_of(arrays(V, F), record_of(L), threads_of(threads), None)


def measures_of(mesh: Any, loops: Any, threads: int, progress: Any) -> Measures:
    return Measures(computed("measure", progress, _core.measure, *mesh, loops, threads))


class Way(Comparable):
    """What one way of removing each handle alone would change; NaN where it is refused."""

    def __init__(self, record: Dict[str, Any]):
        self.areas: np.ndarray = record["areas"]  #: (g,): of the caps
        self.volumes: np.ndarray = record["volumes"]  #: (g,): of the solid that is taken away; negative if solid is added
        self.why_not: List[str] = record["why_not"]  #: why the removal is refused; empty if it is possible


class RemovalCosts(Comparable):
    """What a cut and a fill of each handle alone would change, in the order of the pairs."""

    def __init__(self, record: Dict[str, Any]):
        self.cut = Way(record["cut"])  #: along the handle loop
        self.fill = Way(record["fill"])  #: along the tunnel loop

    def __len__(self) -> int:
        return len(self.cut.why_not)

    def columns(self) -> Dict[str, np.ndarray]:
        """A dictionary of columns, one for each number: ``pandas.DataFrame(C.columns())``."""
        columns: Dict[str, np.ndarray] = {"pair": np.arange(len(self))}
        for name, way in (("cut", self.cut), ("fill", self.fill)):
            columns[f"{name}_area"] = way.areas
            columns[f"{name}_volume"] = way.volumes
            columns[f"no_{name}_because"] = np.array(way.why_not, dtype=object)
        return columns


def removal_costs(V: Any, F: Any = None, L: Optional[Loops] = None, threads: Optional[int] = 0) -> RemovalCosts:
    """Computes what `remove_handles` would change by a cut and by a fill of each handle alone.

    The result has the area of the caps, and the volume of the solid that is taken away (negative if solid
    is added). ``removal_costs(mesh, L)`` takes one mesh object.
    """
    if isinstance(F, Loops):
        F, L = None, F
    return RemovalCosts(
        computed("costs", None, _core.removal_costs, *arrays(V, F), record_of(L), threads_of(threads))
    )
