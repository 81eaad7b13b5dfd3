"""Pictures and pages of meshes, with results."""

from __future__ import annotations

import base64
import os
import tempfile
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np

from . import _core
from ._arguments import numbers, wholes, word
from ._loops import Loops, record_of
from ._meshes import arrays
from ._records import Record
from ._reeb import ReebGraph
from ._skeleton import CurveSkeleton
from ._waiting import computed

_most_faces = 10**6


def picture(
    V: Any, F: Any = None, L: Any = None, path: Any = None, *, size: Optional[Sequence[int]] = None
) -> Optional[bytes]:
    """Draws a mesh with its loops, or with another result, as PNG, like ``htloops --picture``.

    `L` is a result for this mesh, from `loops`, `curve_skeleton`, `reeb`, `cut_edges` or `remove_handles` (the
    whole tuple; the picture shows the mesh before and after).

    The picture is written to `path`. Without `path`, its bytes are returned, for ``IPython.display.Image``.
    `size` is the width and height in pixels. ``picture(mesh, L, path)`` takes one mesh object; for edges of a
    cut, use ``picture(mesh, None, edges, path)``.
    """
    F, L, path = _sorted_out(F, L, path)
    if path is not None and not os.fsdecode(path).lower().endswith(".png"):
        raise ValueError(f"pictures are PNG files: path must end in .png, not {path!r}")
    if path is None:
        return _drawn(V, F, L, size)
    _draw(_absolute(path), V, F, L, size)
    return None


def html(V: Any, F: Any = None, L: Any = None, path: Any = None, *, title: str = "mesh") -> None:
    """Writes an interactive page of a mesh with its loops, or with another result that `picture` takes as `L`.

    The page is one file, `path`, for any browser.

    ``html(mesh, L, path)`` takes one mesh object.
    """
    F, L, path = _sorted_out(F, L, path)
    kind, record = _drawable(L)
    if path is None:
        raise TypeError('html() writes a file, but path, its name, is missing: html(V, F, L, "loops.html")')
    title = word("title", title).encode("utf-8", "backslashreplace").decode("utf-8")
    computed("html", None, _core.page, _absolute(path), *arrays(V, F), kind, record, title)


def _absolute(path: Any) -> bytes:
    """So that no name means standard output; as bytes, because names need not be text."""
    return os.fsencode(os.path.abspath(os.fsdecode(path)))


def _is_removal(L: Any) -> bool:
    return isinstance(L, tuple) and len(L) == 4 and isinstance(L[3], dict)


def _sorted_out(F: Any, L: Any, path: Any) -> Tuple[Any, Any, Any]:
    """If the mesh is one object, the other arguments are one place early: moves them."""
    if isinstance(F, (Loops, CurveSkeleton, ReebGraph)) or _is_removal(F):
        return None, F, L if path is None else path
    return F, L, path


def _drawable(L: Any) -> Tuple[str, Dict[str, Any]]:
    """The kind of a result and its record, as the compiled part takes them."""
    if isinstance(L, CurveSkeleton):
        return "skeleton", Record("the skeleton", L._record)
    if isinstance(L, ReebGraph):
        return "reeb", Record("the Reeb graph", L._record)
    if _is_removal(L):
        points, triangles = arrays(L[0], L[1])
        report = Record("the report", {**L[3], "face_origin": numbers("face_origin", L[2], "integers")})
        return "removal", {
            "points": points,
            "triangles": triangles,
            "loops": record_of(report["loops"], "loops of the report"),
            "report": report,
        }
    if isinstance(L, np.ndarray):
        edges = numbers("edges of a cut", L, "integers")
        if edges.ndim == 2 and edges.shape[1] == 2:
            return "cut", {"edges": edges}
    if not isinstance(L, Loops):
        raise TypeError(
            "L must be a result of loops(), curve_skeleton(), reeb(), remove_handles() or cut_edges(), "
            f"not of type {type(L).__name__}"
        )
    return "loops", record_of(L)


def _draw(name: bytes, V: Any, F: Any, L: Any, size: Optional[Sequence[int]]) -> None:
    pixels: List[int] = [] if size is None else wholes("size", size, 1)
    if size is not None and len(pixels) != 2:
        raise ValueError("size must be a width and a height in pixels")
    kind, record = _drawable(L)
    try:
        computed("picture", None, _core.picture, name, *arrays(V, F), kind, record, pixels)
    except ValueError as error:  # about an option of the tool: name the parameter
        raise type(error)(str(error).replace("--size", "size")) from None


def _drawn(V: Any, F: Any, L: Any, size: Optional[Sequence[int]]) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "picture.png")
        _draw(os.fsencode(name), V, F, L, size)
        with open(name, "rb") as file:
            return file.read()


def html_picture(V: Any, F: Any, L: Loops) -> str:
    """Empty if it would take long, or if it cannot be drawn, for example because the arrays were changed."""
    if not _core.has_pictures or len(F) > _most_faces:
        return ""
    try:
        content = _drawn(V, F, L, (480, 360))
    except (OSError, ValueError):
        return ""
    return f'<img src="data:image/png;base64,{base64.b64encode(content).decode("ascii")}">'
