"""Meshes that are changed, or cut."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Literal, Mapping, Optional, Sequence, Tuple, Union, get_args

import numpy as np

from . import _core
from ._arguments import length_or_none, numbers, real_or_none, threads_of, vertices, whole, wholes, word
from ._loops import Loop, Loops, _loops_of, record_of
from ._loops import loops as loops_of_mesh
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
    """A mesh without some of its handles: of all, or of those that one of the following selects.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    genus : the smallest handles go until so many are left
    shorter_than : handles with a loop that is shorter, in the unit of the coordinates, or as a share of the
        diagonal of the box of the mesh: "3%"
    pairs : those of the pairs of these numbers, as in the table of ``loops``, which has to be given; as a
        mapping, each with a way of its own, or None: {1: "fill", 5: None}
    box : ((x, y, z), (x, y, z)): those of which a loop lies in this box
    necks : as shorter_than; shorter loops at which shells come apart go, too
    channels : as shorter_than: leaks from an outer wall to an inner one, of which the inner wall comes off by
        that, and nothing else
    bores : (least, largest): round bores of a diameter in this range, in the unit of the coordinates; None
        for no limit, so that (None, None) are all of them. Of a stepped bore, or one with counterbores, the
        narrowest cylinder counts; slots have no diameter
    by : "cut" along the handle loop, "fill" the hole along the tunnel loop, or "smallest-change", what
        changes the shape less
    force : also where that is no repair: where the bounding box would grow, say
    loops : of this mesh, if they are known; computed if not
    threads, progress : as for `loops`

    Returns
    -------
    V, F : the new mesh; what stays keeps its order
    face_origin : (m',): for each face the face of the given mesh that it is, or -1 if it is new
    report : genus_before, genus_after, components_before and _after, and lists of dictionaries: removed
        (pair, by, length, area, volume of the solid taken away, negative if it was put in, change, patch),
        refused (pair, length, reason), removed_necks, refused_necks. Each change, and that of all, says how the shape differs: volume_removed,
        volume_added, cap_area; cap_ratio, the largest area of a cap over that of a circle as long as its rim;
        displacement, the largest distance of a cap from the old surface; burial, that of what was taken
        out with solid from the caps; sharpest_angle, at an edge of a cap, in degrees; box_growth. And
        vertex_origin : (n',): for each vertex the one of the given mesh that it is, or -1 if it is new
        face_parent : (m',): for each face the one of the given mesh that it is or is a part of, as there are
            at the rims of caps, or -1 if it is of a cap
        face_patch : (m',): for each face of a cap the handle that it closes, by its place in removed followed by
            removed_necks, else -1. Handles that were removed together have the same caps: the patch of each
            in these lists is the place of the first of them
        loops : those along which handles were looked for
    ``picture`` and ``html`` show what was done, given all of this.
    """
    methods = {}
    if isinstance(pairs, Mapping):
        methods = {n: word("pairs", way, get_args(Way)) for n, way in pairs.items() if way is not None}
        pairs = list(pairs)
    lengths = {"shorter_than": shorter_than, "necks": necks, "channels": channels}
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
        raise ValueError("pairs are numbers of loops: give these, too")
    chosen.update(by=word("by", by, get_args(Way)), methods=methods, force=bool(force))
    mesh, number = arrays(V, F), threads_of(threads)
    with told(progress, "remove") as callback:
        begin = 0.0
        if loops is None:
            begin = 0.8  # the most of the time
            loops = loops_of_mesh(*mesh, threads=number, progress=part(callback, 0, begin))
        record = record_of(loops, "loops")
        for name, length in lengths.items():
            chosen[name] = length_or_none(name, length, record["diagonal"])
        rest = part(callback, begin, 1)
        removed = computed("remove", rest, _core.remove_handles, *mesh, record, chosen, number)
        removed[3]["loops"] = loops
        return removed


def _range(bores: Any) -> List[float]:
    if not isinstance(bores, Sequence) or isinstance(bores, str) or len(bores) != 2:
        raise ValueError("bores is two diameters, each of which may be None: (least, largest)")
    least, largest = (real_or_none("bores", diameter) for diameter in bores)
    limits = [0.0 if least is None else least, float("inf") if largest is None else largest]
    if not limits[0] <= limits[1]:
        raise ValueError("bores has the least diameter first, then the largest")
    return limits


def _corners(box: Any) -> List[float]:
    corners = numbers("box", box).astype(float)
    if corners.shape != (2, 3) or not np.all(corners[0] <= corners[1]):
        raise ValueError("box is two corners, the lower one first: ((x, y, z), (x, y, z))")
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
    """A mesh cut open along edges, so that each component is a disk.

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, 3), or one mesh object
    cones : vertices that the cut has to pass
    cut_spheres : whether spheres are cut, too
    avoid : (k, 2): edges, by the vertices that each joins, that the cut is not to run along, as those that cut
        polygons into triangles
    threads, progress : as for `loops`

    Returns
    -------
    V, F : the opened mesh; faces keep their order, and vertices theirs; copies come after them
    vertex_origin : (n',): the vertex of the given mesh that each vertex is, or is a copy of
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
    """The edges that `cut_to_disk` cuts a mesh along, as seams of textures: (k, 2), by the vertices that each joins."""
    points, triangles = arrays(V, F)
    chosen = _cut_options(cones, cut_spheres, avoid)
    return computed("cut", progress, _core.cut_edges, points, triangles, chosen, threads_of(threads))


def _cut_options(cones: Any, cut_spheres: Any, avoid: Any) -> Dict[str, Any]:
    edges = numbers("avoid", avoid, "integers")
    if edges.size > 0 and (edges.ndim != 2 or edges.shape[1] != 2):
        raise ValueError(f"avoid has to be an array of shape (k, 2), edges; its shape is {edges.shape}")
    return dict(cones=vertices("cones", cones), cut_spheres=bool(cut_spheres), avoid=edges.tolist())


@dataclass(frozen=True, eq=False)
class DualCut(Comparable):
    """A cut that crosses one loop once, counted with sign, and no other."""

    loop: Loop  #: a handle or tunnel loop, or a boundary curve
    edges: np.ndarray  #: (k, 2), int64: vertices that edges of the mesh join
    times: np.ndarray  #: (k,), int64: how often the cut runs along each, in that direction

    def __hash__(self) -> int:
        return hash(self.loop)


def dual_cuts(
    V: Any, F: Any = None, *, threads: int = 0, progress: Any = None
) -> List[DualCut]:
    """The cuts that are dual to the loops of a mesh, and to its boundary curves but one of each component.

    Of a plate with holes: from hole to hole, or to the rim. What jumps across one is the unknown of a
    loop in a circuit.
    """
    cuts = []
    for record in computed(
        "dual cuts", progress, _core.dual_cuts, *arrays(V, F), threads_of(threads)
    ):
        loop = dict(record["loop"], components=np.array([-1]))
        (of_mesh,) = _loops_of(loop, [record["kind"]], [record["pair"]])
        cuts.append(DualCut(of_mesh, record["edges"], record["times"]))
    return cuts
