"""Where meshes come from: files, generators, and arrays that are no surface yet."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterable, List, Literal, Optional, Sequence, Tuple, Union, get_args

import numpy as np

from . import _core
from ._arguments import whole, word
from ._meshes import arrays, soup
from ._waiting import computed

# What the compiled part says of options of the program, and what they are here.
_options = {
    "--triangulate": "triangulate=True",
    "--repair": "repair=True",
    " (--format says which one it is, whatever its name)": "",
}

RepairStep = Literal["degenerate", "weld", "duplicates", "one-sided", "pillows", "orient", "split"]


def generate(kind: str, **options: int) -> Tuple[np.ndarray, np.ndarray]:
    """The arrays V, float64, and F, int64, of a mesh of a kind.

    `kinds` tells which there are. Options: faces, genus and seed; some kinds take parts, long_way and
    short_way, frequency, bridges and tunnels, or necks; holes and hole_faces make a boundary. The genus
    is met exactly, the number of faces within 20 percent.
    """
    largest = {"seed": 2**32 - 1}
    given = {key: whole(key, value, 0, largest.get(key, 2**31 - 1)) for key, value in options.items()}
    return computed("generate", None, _core.generate, word("kind", kind), given)


def kinds() -> Dict[str, str]:
    """By name, what the kinds of meshes look like."""
    return _core.kinds()


def read(
    path: "Union[str, bytes, os.PathLike[str]]",
    *,
    triangulate: bool = False,
    repair: bool = False,
    progress: Any = None,
) -> Tuple[np.ndarray, np.ndarray]:
    """The arrays V, float64, and F, int64, of a mesh file, of any format that ``htloops loops`` reads.

    triangulate cuts faces into triangles, convex or not; repair welds points, drops what is double or
    without area, splits what is no manifold, and orients faces alike. Vertices of the file keep their
    numbers. Raises OSError if the file cannot be read, and ValueError if there is no surface in it.
    ``progress`` is told nothing of interest, but stops the reading by returning False.
    """
    return computed("read", progress, _read, os.fsdecode(path), bool(triangulate), bool(repair))


def _read(
    path: str, triangulate: bool, repair: bool, watch: _core.Watch
) -> Tuple[np.ndarray, np.ndarray]:
    with open(path, "rb") as file:
        content = file.read()
    name = path.encode("utf-8", "backslashreplace").decode("utf-8")  # to be shown
    try:
        return _core.read(name, content, triangulate, repair, watch)
    except (OSError, ValueError) as error:
        raise type(error)(_in_words_of_python(str(error), name)) from None


def write(path: "Union[str, bytes, os.PathLike[str]]", V: Any, F: Any = None) -> None:
    """Writes a mesh in the format that the end of the name tells; others are refused, with those that there are.

    ``write(path, mesh)`` takes one mesh object. It need not be a surface. Numbers read back as exactly
    themselves where the format has as many digits: .stl, .glb, .gii and surfaces of FreeSurfer are of single
    precision. Raises OSError if the file cannot be written.
    """
    name = os.fsdecode(path)
    if name == "-":
        raise ValueError("path is the name of a file, which - is not here")
    computed("write", None, _core.write, name, *arrays(V, F))


def _in_words_of_python(message: str, name: str) -> str:
    before, name, after = message.rpartition(name)
    for option, words in _options.items():
        after = after.replace(option, words)
    return before + name + after


def repair(
    V: Any, F: Any = None, *, steps: Optional[Iterable[RepairStep]] = None
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, List[Tuple[int, str]]]:
    """A surface from arrays that are none: faces of any size, corners that share no vertex, and so on.

    V, F  : arrays of shape (n, 3) and (m, k), k from 3 on, or one mesh object
    steps : some of "degenerate", "weld", "duplicates", "one-sided", "pillows", "orient" and "split", which are
            those of ``htloops repair``; default: all

    Cuts faces into triangles, welds points in the same place, drops faces that are double or without
    area, components that are not orientable and such of two faces, splits edges and vertices that are no
    manifold, and orients faces alike. Returns V and F, in which
    the given vertices keep their numbers and copies come after them; for each face and for each vertex the
    given one that it is, or is a part or a copy of; and what was done, as pairs of a number and words. Of
    an object with cells, the triangles count before the quads.
    Raises MeshError if no surface can be made of it.
    """
    names = None if steps is None else [word("steps", step, get_args(RepairStep)) for step in steps]
    return computed("repair", None, _repair, *soup(V, F), names)


def _repair(
    points: np.ndarray, faces: Sequence[np.ndarray], steps: Optional[List[str]], watch: _core.Watch
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, List[Tuple[int, str]]]:
    return _core.repair(points, faces, watch, steps)
