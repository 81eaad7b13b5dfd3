"""Sources of meshes: files, generators, and arrays that are not a surface yet."""

from __future__ import annotations

import os
from typing import Any, Dict, Iterable, List, Literal, Optional, Sequence, Tuple, Union, get_args

import numpy as np

from . import _core
from ._arguments import whole, word
from ._meshes import arrays, soup
from ._waiting import computed

# Options of the tool in messages of the compiled part, and their names here.
_options = {
    "--triangulate": "triangulate=True",
    "--repair": "repair=True",
    " (--format says which one it is, whatever its name)": "",
    "; try --format": "; rename it to end in",
}

RepairStep = Literal["degenerate", "weld", "duplicates", "one-sided", "pillows", "orient", "split"]


def generate(kind: str, **options: int) -> Tuple[np.ndarray, np.ndarray]:
    """Makes a test mesh of a kind: the arrays V, float64, and F, int64.

    `kinds` lists the kinds. Options: faces, genus and seed; some kinds have parts, long_way and short_way,
    frequency, bridges and tunnels, or necks; holes and hole_faces make a boundary. The genus is exact, the
    number of faces is within 20%.
    """
    largest = {"seed": 2**32 - 1}
    given = {key: whole(key, value, 0, largest.get(key, 2**31 - 1)) for key, value in options.items()}
    return computed("generate", None, _core.generate, word("kind", kind), given)


def kinds() -> Dict[str, str]:
    """The kinds of test meshes: a dictionary from names to descriptions."""
    return _core.kinds()


def read(
    path: "Union[str, bytes, os.PathLike[str]]",
    *,
    triangulate: bool = False,
    repair: bool = False,
    progress: Any = None,
) -> Tuple[np.ndarray, np.ndarray]:
    """Reads a mesh file of any format that ``htloops loops`` reads: the arrays V, float64, and F, int64.

    `triangulate` cuts faces, convex or not, into triangles. `repair` welds coincident points, drops duplicate
    and degenerate faces, splits non-manifold edges and vertices, and orients faces consistently. Vertices
    keep their numbers. Raises OSError if the file cannot be read, and ValueError if it has no surface.
    A callable ``progress`` can stop the reading by returning False.
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
    """Writes a mesh in the format given by the ending of the name; an unknown ending is an error that lists all.

    ``write(path, mesh)`` takes one mesh object. It need not be a surface. Coordinates keep all digits, except
    in the formats of single precision: .stl, .glb, .gii and FreeSurfer surfaces. Raises OSError if the file
    cannot be written.
    """
    name = os.fsdecode(path)
    if name == "-":
        raise ValueError("path must be the name of a file; - does not mean standard output here")
    computed("write", None, _core.write, name, *arrays(V, F))


def _in_words_of_python(message: str, name: str) -> str:
    before, name, after = message.rpartition(name)
    for option, words in _options.items():
        after = after.replace(option, words)
    return before + name + after


def repair(
    V: Any, F: Any = None, *, steps: Optional[Iterable[RepairStep]] = None
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, List[Tuple[int, str]]]:
    """Makes an oriented triangle manifold from defective arrays, with faces of any size.

    V, F  : arrays of shape (n, 3) and (m, k), k at least 3, or one mesh object
    steps : some of "degenerate", "weld", "duplicates", "one-sided", "pillows", "orient" and "split", as for
            ``htloops repair``; default: all

    Cuts faces into triangles, welds coincident points, drops duplicate and degenerate faces, non-orientable
    components and components of two faces, splits non-manifold edges and vertices, and orients faces
    consistently.

    Returns V and F, in which given vertices keep their numbers and copies follow; for each face the given
    face that it is, or is a part of; for each vertex the given vertex that it is, or is a copy of; and the
    changes, as pairs of a number and a description. In an object with cells, triangles are numbered before
    quads. Raises MeshError if no surface can be made.
    """
    names = None if steps is None else [word("steps", step, get_args(RepairStep)) for step in steps]
    return computed("repair", None, _repair, *soup(V, F), names)


def _repair(
    points: np.ndarray, faces: Sequence[np.ndarray], steps: Optional[List[str]], watch: _core.Watch
) -> Tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, List[Tuple[int, str]]]:
    return _core.repair(points, faces, watch, steps)
