"""Pictures of meshes with their loops."""

from __future__ import annotations

import base64
import os
import tempfile
from typing import Any, List, Optional, Sequence

from . import _core
from ._arguments import wholes
from ._loops import Loops, record_of
from ._meshes import arrays
from ._waiting import computed

_most_faces = 10**6


def picture(
    V: Any, F: Any = None, L: Any = None, path: Any = None, *, size: Optional[Sequence[int]] = None
) -> Optional[bytes]:
    """A picture of a mesh with its loops, in PNG, as ``htloops loops --picture`` draws it.

    It is written to `path`, or returned as bytes without one, for ``IPython.display.Image``. `size` is its
    width and height in pixels. ``picture(mesh, L, path)`` takes one mesh object.
    """
    if isinstance(F, Loops):
        F, L, path = None, F, L if path is None else path
    if path is not None and not os.fsdecode(path).lower().endswith(".png"):
        raise ValueError(f"a picture is written in PNG: its name ends in .png, not {path!r}")
    content = _drawn(V, F, L, size)
    if path is None:
        return content
    with open(os.fsdecode(path), "wb") as file:
        file.write(content)
    return None


def _drawn(V: Any, F: Any, L: Any, size: Optional[Sequence[int]]) -> bytes:
    pixels: List[int] = [] if size is None else wholes("size", size, 1)
    if size is not None and len(pixels) != 2:
        raise ValueError("size is a width and a height in pixels")
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "loops.png")
        try:
            computed("picture", None, _core.picture, name, *arrays(V, F), record_of(L), pixels)
        except ValueError as error:  # of options of the program, in words of Python
            raise type(error)(str(error).replace("--size", "size")) from None
        with open(name, "rb") as file:
            return file.read()


def html_picture(V: Any, F: Any, L: Loops) -> str:
    """Of what is quickly drawn; nothing where there can be none, as the arrays were changed, say."""
    if not _core.has_pictures or len(F) > _most_faces:
        return ""
    try:
        content = _drawn(V, F, L, (480, 360))
    except (OSError, ValueError):
        return ""
    return f'<img src="data:image/png;base64,{base64.b64encode(content).decode("ascii")}">'
