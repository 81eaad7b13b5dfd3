"""What is accepted as a mesh."""

from __future__ import annotations

import os
from typing import Any, List, Tuple

import numpy as np

from ._arguments import numbers
from ._core import MeshError

_most = 2**32 - 2  # vertices, and corners of faces

# What meshio calls cells, by the numbers that VTK and PyVista have for them.
_of_vtk = {1: "vertex", 2: "poly_vertex", 3: "line", 4: "poly_line", 5: "triangle", 9: "quad"}
_no_faces = ("vertex", "poly_vertex", "line", "poly_line")
_faces = ("triangle", "quad")


def arrays(mesh: Any, faces: Any = None) -> Tuple[np.ndarray, np.ndarray]:
    """The points and the triangles of a mesh: the given arrays, or those of an object.

    An object has ``vertices`` and ``faces`` (trimesh), ``points`` and ``faces`` (PyVista: rows of a
    number of corners and the corners), or ``points`` and ``cells_dict`` (meshio, and grids of PyVista);
    or it is a pair.
    """
    points, parts = soup(mesh, faces)
    for part in parts:
        if part.shape[1] != 3:
            raise MeshError(
                f"the mesh has faces with {part.shape[1]} corners; repair() cuts them into triangles"
            )
    return points, parts[0]


def soup(mesh: Any, faces: Any = None) -> Tuple[np.ndarray, List[np.ndarray]]:
    """The same for faces with any number of corners: one array for each number."""
    points, parts = _given(mesh, faces)
    points = numbers("V", points)
    if points.ndim != 2 or points.shape[1] != 3:
        _refuse_shape("V", "(n, 3), the coordinates of the vertices", points)
    if len(points) > _most:
        raise MeshError("the mesh has more than 2^32 - 2 vertices")
    parts = [numbers("F", part, "integers") for part in parts]
    for part in parts:
        if part.ndim != 2 or part.shape[1] < 3:
            _refuse_shape("F", "(m, 3), three vertices for each face", part)
    if sum(part.shape[0] * part.shape[1] for part in parts) > _most:
        raise MeshError("the mesh has more than 2^32 - 2 halfedges")
    _refuse_numbers_from_1(parts, len(points))
    return points, parts


def _refuse_numbers_from_1(parts: List[np.ndarray], count: int) -> None:
    """As in MATLAB and in OBJ files. Other wrong numbers are found where they are used."""
    filled = [part for part in parts if part.size > 0]
    if filled and max(part.max() for part in filled) == count and min(part.min() for part in filled) == 1:
        raise MeshError(
            f"F refers to vertices 1 to {count}, but vertices are numbered from 0: subtract 1 from F"
        )


def _refuse_shape(name: str, expected: str, array: np.ndarray) -> None:
    raise ValueError(f"{name} must be an array of shape {expected}; its shape is {array.shape}")


def _given(mesh: Any, faces: Any) -> Tuple[Any, List[Any]]:
    if faces is not None:
        return mesh, [faces]
    if isinstance(mesh, tuple) and len(mesh) == 2:
        return mesh[0], [mesh[1]]
    if hasattr(mesh, "cells_dict"):
        return mesh.points, _faces_of_cells(mesh.cells_dict)
    points = getattr(mesh, "vertices", None)
    if points is None:
        points = getattr(mesh, "points", None)
    if points is None or not hasattr(mesh, "faces"):
        raise TypeError(
            f"a mesh must be two arrays, V and F, or an object with vertices or points and faces, "
            f"not of type {type(mesh).__name__}"
            + ("; read() returns the arrays of a file" if isinstance(mesh, (str, os.PathLike)) else "")
        )
    corners = np.asarray(mesh.faces)
    return points, [corners if corners.ndim == 2 else _faces_of_rows(corners)]


def _faces_of_cells(cells: Any) -> List[Any]:
    named = {
        kind if isinstance(kind, str) else _of_vtk.get(int(kind), f"VTK type {kind}"): corners
        for kind, corners in cells.items()
        if len(corners) > 0
    }
    others = sorted(set(named).difference(_faces, _no_faces))
    if others:
        raise MeshError(f"the mesh has cells that are neither triangles nor quads: {', '.join(others)}")
    faces = [named[kind] for kind in _faces if kind in named]
    if not faces:
        raise MeshError("the mesh has no faces")
    return faces


def _faces_of_rows(rows: np.ndarray) -> np.ndarray:
    corners = int(rows[0]) if rows.size > 0 else 3
    if corners < 3 or rows.size % (corners + 1) != 0 or np.any(rows[:: corners + 1] != corners):
        raise MeshError("the faces of the mesh have different numbers of corners; cut them into triangles first")
    return rows.reshape(-1, corners + 1)[:, 1:]
