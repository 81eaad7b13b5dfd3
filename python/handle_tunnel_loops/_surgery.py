"""Removal of handles, and cutting."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, Tuple, Union, get_args

import numpy as np

from . import _core
from ._arguments import (
    in_words_of_python, length_or_none, numbers, real_or_none, threads_of, vertices, whole, wholes, word
)
from ._loops import Loop, Loops, _loops_of, record_of
from ._loops import loops as loops_of_mesh
from ._measures import measures_of
from ._meshes import arrays
from ._progress import part, told
from ._records import Comparable
from ._waiting import computed

Way = Literal["cut", "fill", "smallest-change", "cheapest"]

# Numbers, or such as "3%".
Length = Union[float, str]


def remove_handles(
    V: Any,
    F: Any = None,
    *,
    genus: Optional[int] = None,
    shorter_than: Optional[Length] = None,
    noise_below: Optional[Length] = None,
    pairs: Union[None, int, Sequence[int], Mapping[int, Optional[Way]]] = None,
    box: Any = None,
    necks: Optional[Length] = None,
    channels: Optional[Length] = None,
    bores: Optional[Tuple[Optional[float], Optional[float]]] = None,
    by: Way = "smallest-change",
    force: bool = False,
    loops: Optional[Loops] = None,
    threads: Optional[int] = 0,
    progress: Any = None,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, Dict[str, Any]]:
    """Removes handles from a mesh: those selected by one of the parameters from genus to bores.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    genus : remove the smallest handles until this many remain; 0 selects all
    shorter_than : remove handles with a loop shorter than this length, in the unit of the coordinates, or as a
        percentage of the diagonal of the bounding box: "3%"
    noise_below : a length like shorter_than: remove handles whose thickness or clear width is surely less.
        More than 5% of the diagonal, or a length across a wide gap between the sizes, is an error unless force is
        given
    pairs : remove the handles of the pairs with these numbers, as in the table of ``loops``, which is required.
        A mapping gives the way of removal for each, or None: {1: "fill", 5: None}
    box : ((x, y, z), (x, y, z)): remove handles with a loop in this box
    necks : like shorter_than; also cut shorter loops that separate the surface
    channels : a length like shorter_than: fill shorter channels between an outer and an inner wall if the
        inner wall becomes a separate component, and change nothing else
    bores : (least, largest): fill round bores with a diameter in this range, in the unit of the coordinates;
        None is no limit, so (None, None) selects all. The narrowest cylinder of a stepped bore or a
        counterbore counts; slots have no diameter
    by : "cut" along the handle loop, "fill" the hole along the tunnel loop, or "smallest-change", whichever
        changes the shape less
    force : also remove handles where the result is not a repair, for example where the bounding box would grow
        or more faces would intersect; accept any noise_below
    loops : the loops of this mesh; computed by default
    threads, progress : as for `loops`

    Returns
    -------
    V, F : the new mesh; remaining vertices and faces keep their order
    face_origin : (m',): for each face the same face of the given mesh, or -1 if it is new
    report : genus_before, genus_after, components_before, components_after, and lists of dictionaries: removed
        (pair, by, length, area, volume of the solid that was taken away, negative if solid was added, change,
        patch), refused (pair, length, reason), removed_necks, refused_necks. ``by`` is "cut", "fill", or, where
        both loops were replaced with their surroundings, "out" if solid was removed and "plug" if solid closed the
        hole. Each ``change``, and the change of the whole mesh, measures how the shape differs: volume_removed, volume_added, cap_area; cap_ratio, the
        largest area of a cap over that of a circle as long as its rim; displacement, the largest distance of a
        cap from the old surface; burial, the largest distance from the caps of what was taken out with solid;
        sharpest_angle, at an edge of a cap, in degrees; box_growth; crossings, how many more pairs of faces
        intersect, 0 unless forced. Further keys:
        vertex_origin : (n',): for each vertex the same vertex of the given mesh, or -1 if it is new
        face_parent : (m',): for each face the face of the given mesh that it is, or is a part of (at the rims of
            caps), or -1 for faces of caps
        face_patch : (m',): for each face of a cap the handle that it closes, as a position in removed followed by
            removed_necks; else -1. Handles that were removed together share their caps: their patch is the
            position of the first of them
        loops : the loops that were used
        measures, undecided : if noise_below was given, what `measure` returns, and the pairs whose bounds are on
            either side of the limit: they are kept
    Pass the whole tuple to ``picture`` or ``html`` to show what was done.
    """
    methods = {}
    if isinstance(pairs, Mapping):
        methods = {n: word("each way in pairs", way, get_args(Way)) for n, way in pairs.items() if way is not None}
        pairs = list(pairs)
    lengths = {"shorter_than": shorter_than, "noise_below": noise_below, "necks": necks, "channels": channels}
    chosen: Dict[str, Any] = dict(
        genus=None if genus is None else whole("genus", genus),
        pairs=None if pairs is None else wholes("pairs", pairs),
        box=None if box is None else _corners(box),
        **{name: length_or_none(name, length) for name, length in lengths.items()},
        bores=None if bores is None else _range(bores),
    )
    given = [name for name, value in chosen.items() if value is not None]
    if len(given) > 1:
        raise ValueError(f"{' and '.join(given)} cannot be given together")
    if pairs is not None and loops is None:
        raise ValueError("pairs requires loops: the numbers are those of its pairs")
    chosen.update(by=word("by", by, get_args(Way)), methods=methods, force=bool(force))
    if not given:
        raise ValueError(
            "which handles are to be removed? Give one of genus, shorter_than, noise_below, pairs, box, necks, "
            "channels and bores; genus=0 removes all"
        )
    mesh, number = arrays(V, F), threads_of(threads)
    with told(progress, "remove") as callback:
        begin = 0.0
        if loops is None:
            begin = 0.8 if noise_below is None else 0.4  # most of the time, but for that of measures
            loops = loops_of_mesh(*mesh, threads=number, progress=part(callback, 0, begin))
        record = record_of(loops, "loops")
        for name, length in lengths.items():
            chosen[name] = length_or_none(name, length, record["diagonal"])
        used: Dict[str, Any] = {"loops": loops}
        limit = chosen.pop("noise_below")
        if limit is not None:
            used["measures"] = measures_of(mesh, record, number, part(callback, begin, 0.8))
            least, most = used["measures"].noise_ranges.T
            if not force:
                _check_noise(most, noise_below, limit, record["diagonal"])
            chosen["pairs"], begin = np.flatnonzero(most < limit).tolist(), 0.8
            used["undecided"] = np.flatnonzero((least < limit) & (limit <= most)).tolist()
        rest = part(callback, begin, 1)
        removed = computed("remove", rest, _core.remove_handles, *mesh, record, chosen, number)
        removed[3].update(used)
        return removed


def _check_noise(sizes: np.ndarray, given: Length, limit: float, diagonal: float) -> None:
    try:
        _core.check_noise(sizes, given if isinstance(given, str) else f"{given:g}", limit, diagonal)
    except ValueError as reason:
        raise ValueError(in_words_of_python(str(reason))) from None


def _range(bores: Any) -> List[float]:
    if not isinstance(bores, Sequence) or isinstance(bores, str) or len(bores) != 2:
        raise ValueError("bores must be two diameters, (least, largest); each can be None")
    least, largest = (real_or_none("bores", diameter) for diameter in bores)
    limits = [0.0 if least is None else least, float("inf") if largest is None else largest]
    if not limits[0] <= limits[1]:
        raise ValueError("bores must have the least diameter first, then the largest")
    return limits


def _corners(box: Any) -> List[float]:
    corners = numbers("box", box).astype(float)
    if corners.shape != (2, 3) or not np.all(corners[0] <= corners[1]):
        raise ValueError("box must be two corners, the lower one first: ((x, y, z), (x, y, z))")
    return corners.ravel().tolist()


def cut_to_disk(
    V: Any,
    F: Any = None,
    *,
    cones: Sequence[int] = (),
    cut_spheres: bool = False,
    avoid: Any = (),
    threads: Optional[int] = 0,
    progress: Any = None,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cuts a mesh open along edges, so that each component becomes a disk.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    cones : vertices that the cut must pass through
    cut_spheres : whether to also cut spheres
    avoid : (k, 2): edges, as pairs of vertices, that the cut must not use, such as diagonals that divide
        polygons into triangles
    threads, progress : as for `loops`

    Returns
    -------
    V, F : the opened mesh; faces and vertices keep their order, and copies of vertices follow
    vertex_origin : (n',): for each vertex the vertex of the given mesh that it is, or is a copy of
    """
    points, triangles = arrays(V, F)
    chosen = _cut_options(cones, cut_spheres, avoid)
    new_points, new_triangles = computed(
        "cut", progress, _core.cut_to_disk, points, triangles, chosen, threads_of(threads)
    )
    origin = np.arange(len(new_points))
    origin[new_triangles] = triangles
    return new_points, new_triangles, origin


def cut_edges(
    V: Any,
    F: Any = None,
    *,
    cones: Sequence[int] = (),
    cut_spheres: bool = False,
    avoid: Any = (),
    threads: Optional[int] = 0,
    progress: Any = None,
) -> np.ndarray:
    """Computes the edges that `cut_to_disk` cuts along, for texture seams: (k, 2), as pairs of vertices."""
    points, triangles = arrays(V, F)
    chosen = _cut_options(cones, cut_spheres, avoid)
    return computed("cut", progress, _core.cut_edges, points, triangles, chosen, threads_of(threads))


def _cut_options(cones: Any, cut_spheres: Any, avoid: Any) -> Dict[str, Any]:
    edges = numbers("avoid", avoid, "integers")
    if edges.size > 0 and (edges.ndim != 2 or edges.shape[1] != 2):
        raise ValueError(f"avoid must be an array of shape (k, 2), pairs of vertices; its shape is {edges.shape}")
    return dict(cones=vertices("cones", cones), cut_spheres=bool(cut_spheres), avoid=edges.tolist())


@dataclass(frozen=True, eq=False)
class DualCut(Comparable):
    """A cut that has algebraic crossing number 1 with one loop and 0 with all others."""

    loop: Loop  #: a handle or tunnel loop, or a boundary curve
    edges: np.ndarray  #: (k, 2), int64: edges of the mesh, as pairs of vertices
    times: np.ndarray  #: (k,), int64: how many times the cut uses each edge in that direction

    def __hash__(self) -> int:
        return hash(self.loop)


def dual_cuts(
    V: Any, F: Any = None, *, threads: int = 0, progress: Any = None
) -> List[DualCut]:
    """Computes the cuts dual to the loops of a mesh, and to its boundary curves except one of each component.

    On a plate with holes, they lead from hole to hole, or to the rim. In a field computation, the jump of a
    potential across a cut is the unknown of its loop.
    """
    cuts = []
    for record in computed(
        "dual cuts", progress, _core.dual_cuts, *arrays(V, F), threads_of(threads)
    ):
        loop = dict(record["loop"], components=np.array([-1]))
        (of_mesh,) = _loops_of(loop, [record["kind"]], [record["pair"]])
        cuts.append(DualCut(of_mesh, record["edges"], record["times"]))
    return cuts
