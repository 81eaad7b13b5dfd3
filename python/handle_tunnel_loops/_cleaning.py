"""Closed solids from defective meshes."""

from __future__ import annotations

import math
from typing import Any, Dict, Iterable, List, Literal, Optional, Tuple, Union, get_args

import numpy as np

from . import _core
from ._arguments import in_words_of_python, length_or_none, real_or_none, threads_of, whole, word
from ._meshes import soup
from ._waiting import computed

CleanStep = Literal["repair", "holes", "orient", "channels", "floaters", "shells", "handles"]

# Numbers, or such as "3%".
Length = Union[float, str]


def clean(
    V: Any,
    F: Any = None,
    *,
    skip: Union[CleanStep, Iterable[CleanStep]] = (),
    weld: Optional[Length] = None,
    channels: Optional[Length] = None,
    floaters: Union[float, str] = "0.02%",
    genus: Optional[int] = None,
    noise_below: Optional[Length] = None,
    force: bool = False,
    threads: Optional[int] = 0,
    progress: Any = None,
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, Dict[str, Any]]:
    """Makes a closed solid from a defective mesh, for example for a 3D printer.

    It changes only what it can justify, and lists what it leaves. No point moves, and no new crossing is made.
    The steps, in order:

    repair : makes an oriented triangle manifold, and welds close points
    holes : closes boundary curves where a cap fits
    orient : turns over parts that are inside out
    channels : fills short channels between an outer and an inner wall if the inner wall becomes separate; if
        the volume would change by more than 5%, only with channels or force
    floaters : drops small parts that touch no other part
    shells : drops parts that lie inside another part; if the volume would change by more than 5%, only with force
    handles : removes handles, only with genus or noise_below

    Parameters
    ----------
    V, F : arrays of shape (n, 3) and (m, k), k at least 3, or one mesh object; it need not be a surface
    skip : steps to leave out
    weld : join vertices of open edges that are closer than this length; default: only those that nearly
        coincide. Lengths are in the unit of the coordinates, or a percentage of the diagonal of the bounding
        box: "3%"
    channels : fill channels up to this circumference; default: up to "3%", where the volume changes by at most 5%
    floaters : drop parts with less than this share of the volume, 0.0002 or "0.02%", if together they have less
        than five times that share
    genus : remove the smallest handles until this many remain
    noise_below : remove handles whose thickness or clear width is less than this length
    force : change volumes by more than 5%, and accept a noise_below above 5% of the diagonal, or across a wide
        gap between the sizes of handles, which is an error otherwise
    threads, progress : as for `loops`

    Returns
    -------
    V, F : the new mesh; remaining vertices and faces keep their order
    face_origin : (m',): for each face the face of the given mesh that it is, or is a triangle of, or -1 if it
        is new
    report : a dictionary:
        closed : whether the result is closed
        before, after : vertices, faces, parts, boundaries, genus, crossings, volume
        steps : a list of dictionaries: step, count, and descriptions of what was done and what is left
        vertex_origin : (n',): for each vertex the same vertex of the given mesh, or -1 if it is new
        face_parent : (m',): as face_origin, also for parts of faces at the rims of caps

    Raises MeshError if no surface can be made.
    """
    skipped = _steps(skip)
    if genus is not None and noise_below is not None:
        raise ValueError("genus and noise_below cannot be given together")
    for step, name, value in (("repair", "weld", weld), ("channels", "channels", channels),
                              ("handles", "genus", genus), ("handles", "noise_below", noise_below)):
        if step in skipped and value is not None:
            raise ValueError(f"{name} is for a step that skip leaves out: {step!r}")
    chosen: Dict[str, Any] = dict(
        skip=skipped,
        weld=_length("weld", weld),
        channels=_length("channels", channels),
        floaters=_share(floaters),
        genus=None if genus is None else whole("genus", genus),
        noise_below=_length("noise_below", noise_below),
        force=bool(force),
    )
    given = soup(V, F)
    try:
        new_V, new_F, face_origin, report = computed(
            "clean", progress, _core.clean, *given, chosen, threads_of(threads)
        )
    except ValueError as reason:
        raise type(reason)(in_words_of_python(str(reason))) from None
    for step in report["steps"]:
        step["left"] = [in_words_of_python(line) for line in step["left"]]
    return new_V, new_F, face_origin, report


def _steps(skip: Any) -> List[str]:
    if skip is None:
        raise TypeError("skip must be a step, several steps, or () for none")
    steps = [skip] if isinstance(skip, str) else list(skip)
    return [word("skip", step, get_args(CleanStep)) for step in steps]


# A length, and whether it is a share of the diagonal.
def _length(name: str, value: Optional[Length]) -> Optional[Tuple[float, bool]]:
    length = length_or_none(name, value)
    if length is None:
        return None
    if not 0 < length < math.inf:
        raise ValueError(f"{name} must be positive and finite")
    return length, isinstance(value, str)


def _share(value: Any) -> float:
    share = value
    if isinstance(value, str):
        try:
            share = float(value[:-1]) / 100 if value.endswith("%") else math.nan
        except ValueError:
            share = math.nan
    share = real_or_none("floaters", share)
    if share is None or not 0 <= share <= 1:
        raise ValueError(f'floaters must be a share of the volume, such as 0.0002 or "0.02%", not {value!r}')
    return share
